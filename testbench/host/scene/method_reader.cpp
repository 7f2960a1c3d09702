#include <algorithm>

#include "testbench/host/scene/object_reader.h"

namespace repousse::host {
namespace {

constexpr double kWorldLimit = 1e6;

const std::vector<std::string> kMethods{"adaptive", "sweep", "direct"};
const std::vector<std::string> kLaterMethods{"patches", "tiles", "decal"};
const std::string kMethodChoice = "\"adaptive\", \"sweep\" or \"direct\"";

AdaptiveSettings read_adaptive(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.adaptive", context);
    AdaptiveSettings adaptive;
    if (reader.has("generation_cap")) {
        const TomlValue* cap = table.find("generation_cap");
        if (cap->kind == TomlValue::Kind::String) {
            if (cap->string != "natural") {
                reader.fail("generation_cap",
                            "object.adaptive.generation_cap is \"" + cap->string + "\"",
                            "\"natural\" or an integer in 0..15");
            }
        } else {
            adaptive.generation_cap = reader.integer("generation_cap", 0, 0, 15);
        }
    }
    adaptive.order = static_cast<StackOrder>(reader.choice("order", {"lifo", "fifo"}, 0));
    adaptive.eager = reader.boolean("eager", false);
    adaptive.box = static_cast<BoxKind>(reader.choice("box", {"square", "literal"}, 0));
    adaptive.contexts = reader.integer("contexts", 1, 1, 16);
    adaptive.normal_threshold = reader.optional_number("normal_threshold", 0.0, 2.0);
    adaptive.normal_space =
        static_cast<NormalSpace>(reader.choice("normal_space", {"world", "map"}, 0));
    adaptive.view_threshold_px = reader.optional_number("view_threshold_px", 0.0, 4096.0);

    constexpr const char* kAverageKey = "height_threshold_lsb";
    constexpr const char* kSumKey = "height_threshold_lsb_texel2";
    const auto average = reader.optional_number(kAverageKey, 0.0, 65535.0);
    const auto sum = reader.optional_number(kSumKey, 0.0, 274877906944.0);  // 2^38
    const bool summed = reader.has(kSumKey);
    const int mode = reader.choice("height_mode", {"average", "sum"}, summed ? 1 : 0);
    adaptive.height_mode = static_cast<HeightMode>(mode);
    adaptive.height_threshold = mode == 1 ? sum : average;
    if (reader.has(mode == 1 ? kAverageKey : kSumKey)) {
        reader.fail(mode == 1 ? kAverageKey : kSumKey,
                    std::string("height_mode \"") + (mode == 1 ? "sum" : "average") +
                        "\" does not take this threshold",
                    mode == 1 ? kSumKey : kAverageKey);
    }

    adaptive.uniform = reader.boolean("uniform", false);
    const bool tested = reader.has(kAverageKey) || summed || reader.has("normal_threshold");
    if (adaptive.uniform && tested) {
        reader.fail("uniform", "uniform = true together with a height or normal threshold",
                    "one or the other");
    }
    reader.finish();
    if (!adaptive.uniform && !tested) {
        context.fail(reader.mark(), "[object.adaptive] has no test that splits a triangle",
                     "height_threshold_lsb, height_threshold_lsb_texel2, normal_threshold or "
                     "uniform = true");
    }
    return adaptive;
}

SweepSettings read_sweep(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.sweep", context);
    SweepSettings sweep;
    // 4096 grid units make a side of the view at most; coarser than 1024 px nothing is cut.
    sweep.coarseness_px = reader.number("coarseness_px", sweep.coarseness_px, 0.0, 1024.0);
    if (!(sweep.coarseness_px > 0.0)) {
        reader.fail("coarseness_px", "object.sweep.coarseness_px is 0", "a number above 0");
    }
    sweep.guard_grid = reader.integer("guard_grid", sweep.guard_grid, 1, kGridLimit);
    sweep.w_min = reader.optional_number("w_min", 1e-6, kWorldLimit);
    sweep.clip = reader.boolean("clip", sweep.clip);
    reader.finish();
    return sweep;
}

// Methods that are not there yet are known by name: that is an answer, not a spelling mistake.
Method read_name(TableReader& reader) {
    const std::string name = reader.text("method", "adaptive");
    const auto at = std::find(kMethods.begin(), kMethods.end(), name);
    if (at != kMethods.end()) return static_cast<Method>(at - kMethods.begin());
    if (std::find(kLaterMethods.begin(), kLaterMethods.end(), name) != kLaterMethods.end()) {
        reader.fail("method", "method \"" + name + "\" is not built yet", kMethodChoice);
        return Method::Adaptive;
    }
    const std::string near = nearest_word(name, kMethods);
    reader.fail("method", "object.method is \"" + name + "\"", kMethodChoice,
                near.empty() ? "" : "did you mean \"" + near + "\"?");
    return Method::Adaptive;
}

// A table that would have no effect is a mistake, not a reserve.
void refuse(TableReader& reader, const char* key, Method method) {
    if (!reader.has(key)) return;
    reader.fail(
        key,
        std::string("[object.") + key + "] in an object of method \"" + method_name(method) + "\"",
        "an object without it");
}

}  // namespace

const char* method_name(Method method) {
    switch (method) {
        case Method::Adaptive:
            return "adaptive";
        case Method::Sweep:
            return "sweep";
        case Method::Direct:
            break;
    }
    return "direct";
}

void read_method(TableReader& reader, Object& object, ReadContext& context) {
    object.method = read_name(reader);
    for (const char* key : {"patches", "tiles", "decal"}) {
        if (!reader.has(key)) continue;
        reader.fail(key, std::string("[object.") + key + "] is not built yet",
                    "an object without it");
    }
    if (object.method == Method::Direct) {
        refuse(reader, "map", object.method);
        refuse(reader, "shade", object.method);
        object.map.recipe.width = object.map.recipe.height = 1;
    } else {
        reader.require("map", "a table [object.map]");
    }
    if (object.method == Method::Adaptive) {
        reader.require("adaptive", "a table [object.adaptive] with at least one threshold");
        if (const TomlValue* adaptive = reader.table("adaptive")) {
            object.adaptive = read_adaptive(*adaptive, context);
        }
    } else {
        refuse(reader, "adaptive", object.method);
    }
    if (object.map.levels && object.method == Method::Adaptive) {
        context.fail(object.map.mark,
                     "[object.map] levels in an object of method \"adaptive\", which has no "
                     "footprints",
                     "method = \"sweep\", or a map without levels");
    }
    if (object.method == Method::Sweep) {
        if (const TomlValue* sweep = reader.table("sweep")) {
            object.sweep = read_sweep(*sweep, context);
        }
    } else {
        refuse(reader, "sweep", object.method);
    }
}

}  // namespace repousse::host
