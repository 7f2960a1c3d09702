#include "testbench/host/scene/object_reader.h"

#include <algorithm>

#include "testbench/host/files.h"

namespace repousse::host {
namespace {

constexpr double kWorldLimit = 1e6;  // world units; positions beyond lose the device's fraction

MeshSource read_mesh_source(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.mesh", context);
    MeshSource mesh;
    mesh.mark = reader.mark();
    if (reader.has("file")) {
        mesh.kind = MeshKind::File;
        mesh.mark = reader.mark("file");
        const std::string file = reader.text("file", "");
        const std::string extension = extension_of(file);
        if (extension != ".obj" && extension != ".off" && extension != ".ply") {
            reader.fail("file", "mesh file \"" + file + "\" is of an unknown type",
                        "a name that ends in .obj, .off or .ply");
        }
        mesh.file = resolve_file(file, context.folder);
        if (mesh.file.empty()) {
            reader.fail("file", "mesh file \"" + file + "\" does not exist",
                        "a file beside the scene or below the working directory");
        }
        mesh.projection = static_cast<UvProjection>(
            reader.choice("projection", {"none", "planar", "spherical", "cylindrical"}, 0));
        reader.finish();
        return mesh;
    }
    reader.require("kind", "\"grid\", \"cylinder\" or \"icosphere\", or file = \"...\"");
    const int kind = reader.choice("kind", {"grid", "cylinder", "icosphere"}, 0);
    if (kind == 0) {
        mesh.kind = MeshKind::Grid;
        const std::vector<int> quads = reader.integers("quads", 2, 1, 4096);
        if (!quads.empty()) mesh.columns = quads[0], mesh.rows = quads[1];
        mesh.size = reader.vector2("size", {1.0, 1.0}, 1e-6, kWorldLimit);
    } else if (kind == 1) {
        mesh.kind = MeshKind::Cylinder;
        mesh.columns = reader.integer("segments", 12, 3, 4096);
        mesh.rows = reader.integer("rings", 4, 1, 4096);
        mesh.radius = reader.number("radius", 1.0, 1e-6, kWorldLimit);
        mesh.height = reader.number("height", 2.0, 1e-6, kWorldLimit);
    } else {
        mesh.kind = MeshKind::Icosphere;
        mesh.subdivisions = reader.integer("subdivisions", 2, 0, 8);
        mesh.radius = reader.number("radius", 1.0, 1e-6, kWorldLimit);
    }
    reader.finish();
    return mesh;
}

/// Methods that other issues build; naming one is an answer, not a spelling mistake.
void read_method(TableReader& reader, Object& object) {
    static const std::vector<std::string> kLater{"sweep", "patches", "tiles", "decal"};
    object.method = reader.text("method", "adaptive");
    if (object.method == "adaptive") return;
    if (std::find(kLater.begin(), kLater.end(), object.method) != kLater.end()) {
        reader.fail("method", "method \"" + object.method + "\" is not built yet", "\"adaptive\"");
        return;
    }
    const std::string near = nearest_word(object.method, {"adaptive"});
    reader.fail("method", "object.method is \"" + object.method + "\"", "\"adaptive\"",
                near.empty() ? "" : "did you mean \"" + near + "\"?");
}

/// Tables that belong to methods and units still to come.
void refuse_reserved(TableReader& reader) {
    for (const char* key : {"shade", "sweep", "patches", "tiles", "decal"}) {
        if (!reader.has(key)) continue;
        reader.fail(key, std::string("[object.") + key + "] is not built yet",
                    "an object without it");
    }
}

}  // namespace

Object read_object(const TomlValue& table, int index, ReadContext& context) {
    TableReader reader(table, "object", context);
    Object object;
    object.mark = reader.mark();
    object.name = reader.text("name", "object" + std::to_string(index + 1));
    if (object.name.empty()) reader.fail("name", "object.name is empty", "a name");
    read_method(reader, object);
    refuse_reserved(reader);
    reader.require("mesh", "a table [object.mesh]");
    reader.require("map", "a table [object.map]");
    reader.require("adaptive", "a table [object.adaptive] with at least one threshold");
    if (const TomlValue* mesh = reader.table("mesh"))
        object.mesh = read_mesh_source(*mesh, context);
    if (const TomlValue* map = reader.table("map")) object.map = read_map_source(*map, context);
    if (const TomlValue* adaptive = reader.table("adaptive")) {
        object.adaptive = read_adaptive(*adaptive, context);
    }
    if (const TomlValue* bump = reader.table("bump")) {
        object.bump = true;
        TableReader(*bump, "object.bump", context).finish();
    }
    reader.finish();
    return object;
}

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

    const char* const kAverageKey = "height_threshold_lsb";
    const char* const kSumKey = "height_threshold_lsb_texel2";
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

}  // namespace repousse::host
