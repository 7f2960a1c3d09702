#include <algorithm>

#include <glm/geometric.hpp>

#include "testbench/host/files.h"
#include "testbench/host/scene/object_reader.h"

namespace repousse::host {
namespace {

constexpr double kWorldLimit = 1e6;

const std::vector<std::string>& kinds() {
    static const std::vector<std::string> names{"donut", "constant", "ramp", "checker", "fbm"};
    return names;
}

void read_fbm(TableReader& reader, FbmSettings& fbm) {
    fbm.seed = static_cast<std::uint64_t>(reader.integer("seed", 1, 0, 2147483647));
    const std::vector<int> cells = reader.integers("cells", 2, 1, 256);
    if (!cells.empty()) fbm.cells_x = cells[0], fbm.cells_y = cells[1];
    fbm.octaves = reader.integer("octaves", 7, 1, 12);
    fbm.gain_percent = reader.integer("gain_percent", 50, 10, 90);
    fbm.ridged = reader.boolean("ridged", false);
}

/// The axis of a scanner. Its keys are required with a range map: no default fits a mesh.
void read_axis(TableReader& reader, MapRecipe& recipe) {
    reader.require("axis", "[x, y, z, x, y, z]: the axis from v = 0 to v = 1, in mesh units");
    reader.require("front", "an array of 3 numbers: what lies at u = 0");
    const std::vector<double> axis = reader.numbers("axis", 6, -kWorldLimit, kWorldLimit);
    RangeAxis& range = recipe.axis;
    if (!axis.empty()) {
        range.low = {axis[0], axis[1], axis[2]};
        range.high = {axis[3], axis[4], axis[5]};
    }
    range.front = reader.vector3("front", range.front, -kWorldLimit, kWorldLimit);
    const glm::dvec3 along = range.high - range.low;
    if (along == glm::dvec3(0.0)) {
        reader.fail("axis", "object.map.axis has no length", "two different points");
    } else if (!(glm::length(glm::cross(along, range.front)) >
                 1e-9 * glm::length(along) * glm::length(range.front))) {
        reader.fail("front", "object.map.front is zero or runs along the axis",
                    "a direction across it");
    }
    const std::vector<int> size = reader.integers("size_texels", 2, 1, 4096);
    recipe.width = size.empty() ? 512 : size[0];
    recipe.height = size.empty() ? 512 : size[1];
}

/// `file` of a map, or of the mesh that a range map scans: found, or replaced by `fallback`, or
/// refused.
void read_map_file(TableReader& reader, const TomlValue& table, MapSource& map,
                   ReadContext& context, bool is_range) {
    static const std::vector<std::string> kTypes{".npz", ".json", ".nc",   ".cdf",
                                                 ".png", ".tif",  ".tiff", ".exr"};
    static const std::vector<std::string> kMeshTypes{".obj", ".off", ".ply"};
    const std::string file = reader.text("file", "");
    const std::vector<std::string>& types = is_range ? kMeshTypes : kTypes;
    if (std::find(types.begin(), types.end(), extension_of(file)) == types.end()) {
        reader.fail("file", "map file \"" + file + "\" is of an unknown type",
                    is_range ? "a mesh: a name that ends in .obj, .off or .ply"
                             : "a name that ends in .npz, .json, .nc, .cdf, .png, .tif or .exr");
    }
    // The fallback is read even when it is not needed: a mistake in it must not hide until then.
    std::optional<MapRecipe> fallback;
    if (const TomlValue* other = reader.table("fallback")) {
        TableReader inner(*other, "object.map.fallback", context);
        fallback = read_recipe(inner, MapKind::Fbm);
        inner.finish();
    }
    map.recipe.kind = is_range ? MapKind::Range : MapKind::File;
    map.recipe.mark = reader.mark("file");
    map.recipe.file = resolve_file(file, context.folder);
    if (!map.recipe.file.empty()) return;
    if (!fallback) {
        reader.fail("file", "map file \"" + file + "\" does not exist",
                    "a file beside the scene or below the working directory, or a fallback");
        return;
    }
    map.recipe = *fallback;
    map.used_fallback = true;
    map.missing_file = file;
    context.notes.push_back(reader.mark("file").text() + ": map file \"" + file +
                            "\" is absent; the procedural fallback \"" +
                            kinds()[static_cast<std::size_t>(map.recipe.kind) - 1] + "\" (line " +
                            std::to_string(table.find("fallback")->line) + ") stands in");
}

glm::dvec2 read_range(TableReader& reader, const TomlValue& table) {
    reader.require("range", "world units of displacement: high, or [low, high]");
    if (!reader.has("range")) return {0.0, 1.0};
    glm::dvec2 range(0.0, 1.0);
    if (table.find("range")->kind == TomlValue::Kind::Array) {
        range = reader.vector2("range", range, -kWorldLimit, kWorldLimit);
    } else {
        range.y = reader.number("range", 1.0, 0.0, kWorldLimit);
    }
    if (!(range.x < range.y)) {
        reader.fail(
            "range",
            "object.map.range is [" + number_text(range.x) + ", " + number_text(range.y) + "]",
            "low below high");
    }
    return range;
}

/// Crop and resampling, and that the crop fits a procedural map (a file's is checked on loading).
void read_cut(TableReader& reader, MapSource& map) {
    const std::vector<int> crop = reader.integers("crop_texels", 4, 0, kMaxMapSide);
    if (!crop.empty()) {
        map.crop = TexelBox{crop[0], crop[1], crop[2], crop[3]};
        if (crop[2] == 0 || crop[3] == 0) {
            reader.fail("crop_texels", "object.map.crop_texels has no texels",
                        "[x, y, width, height] with width and height at least 1");
        }
        const MapRecipe& recipe = map.recipe;
        if (recipe.kind != MapKind::File && !map.used_fallback &&
            (crop[0] + crop[2] > recipe.width || crop[1] + crop[3] > recipe.height)) {
            reader.fail("crop_texels", "object.map.crop_texels is not inside the map",
                        "a part of " + std::to_string(recipe.width) + " x " +
                            std::to_string(recipe.height) + " texels");
        }
    }
    const std::vector<int> size = reader.integers("resample_texels", 2, 1, kMaxMapSide);
    if (!size.empty()) map.resample = glm::ivec2(size[0], size[1]);
}

/// How heights are read, and of which filter levels. One without the other would have no effect.
void read_filter(TableReader& reader, MapSource& map) {
    static const std::vector<std::string> kFilters{"nearest", "bilinear", "maximum", "average"};
    const int levels = reader.choice("levels", {"none", "average", "maximum", "variational"}, 0);
    switch (levels) {
        case 1:
            map.levels = LevelFilter::Average;
            break;
        case 2:
            map.levels = LevelFilter::BoxMaximum;
            break;
        case 3:
            map.levels = LevelFilter::Variational;
            break;
        default:
            break;
    }
    const int usual = static_cast<int>(map.levels ? HeightFilter::Maximum : HeightFilter::Nearest);
    map.filter = static_cast<HeightFilter>(reader.choice("filter", kFilters, usual));
    const std::string name = kFilters[static_cast<std::size_t>(map.filter)];
    if (reads_levels(map.filter) && !map.levels) {
        reader.fail("filter", "filter = \"" + name + "\" without filter levels",
                    "levels = \"maximum\", \"average\" or \"variational\"");
    } else if (map.levels && !reads_levels(map.filter)) {
        reader.fail("levels", "filter levels that filter = \"" + name + "\" does not read",
                    "filter = \"maximum\" or \"average\"");
    }
    map.finer_levels = reader.integer("finer_levels", 0, 0, kMostFiner);
    if (map.finer_levels > 0 && map.filter != HeightFilter::Maximum) {
        reader.fail("finer_levels",
                    "finer_levels = " + std::to_string(map.finer_levels) + " with filter = \"" +
                        name + "\"",
                    "filter = \"maximum\", or finer_levels = 0");
    }
}

}  // namespace

MapRecipe read_recipe(TableReader& reader, MapKind fallback_kind) {
    MapRecipe recipe;
    recipe.mark = reader.mark();
    const int first = static_cast<int>(MapKind::Donut);
    recipe.kind = static_cast<MapKind>(
        first + reader.choice("kind", kinds(), static_cast<int>(fallback_kind) - first));
    // 4096^2 is the largest map whose summed-area arithmetic is proven.
    const std::vector<int> size = reader.integers("size_texels", 2, 1, 4096);
    if (!size.empty()) recipe.width = size[0], recipe.height = size[1];
    switch (recipe.kind) {
        case MapKind::Constant:
            recipe.value = reader.integer("value_lsb", 0, 0, 65535);
            break;
        case MapKind::Ramp: {
            recipe.start = reader.integer("start_lsb", 0, -65535, 65535);
            const auto slope = reader.integers("slope_lsb_per_texel", 2, -65535, 65535);
            if (!slope.empty()) recipe.slope_x = slope[0], recipe.slope_y = slope[1];
            break;
        }
        case MapKind::Checker: {
            recipe.square = reader.integer("square_texels", 16, 1, kMaxMapSide);
            const auto heights = reader.integers("heights_lsb", 2, 0, 65535);
            if (!heights.empty()) recipe.low = heights[0], recipe.high = heights[1];
            break;
        }
        case MapKind::Fbm:
            read_fbm(reader, recipe.fbm);
            break;
        case MapKind::Donut:
        case MapKind::File:
        case MapKind::Range:
            break;
    }
    return recipe;
}

MapSource read_map_source(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "object.map", context);
    MapSource map;
    map.mark = reader.mark();
    const TomlValue* kind = table.find("kind");
    const bool is_range =
        kind != nullptr && kind->kind == TomlValue::Kind::String && kind->string == "range";
    if (is_range) {
        reader.text("kind", "");
        reader.require("file", "the mesh that is scanned: .obj, .off or .ply");
        read_axis(reader, map.recipe);
    }
    if (is_range || reader.has("file")) {
        if (reader.has("file")) read_map_file(reader, table, map, context, is_range);
        if (reader.has("sample_range")) {
            const glm::dvec2 range = reader.vector2("sample_range", {0.0, 1.0}, -1e9, 1e9);
            if (!(range.x < range.y)) {
                reader.fail("sample_range", "object.map.sample_range is empty", "[low, high]");
            }
            map.samples = range;
        }
        if (!is_range) {
            map.void_value = reader.optional_number("void_value", -1e300, 1e300);
            map.fill_voids = reader.boolean("fill_voids", false);
        }
    } else {
        reader.require("kind",
                       "file = \"...\", or \"donut\", \"constant\", \"ramp\", \"checker\", "
                       "\"fbm\" or \"range\"");
        map.recipe = read_recipe(reader, MapKind::Constant);
    }
    read_cut(reader, map);
    map.flip_rows = reader.boolean("flip_rows", false);
    map.range = read_range(reader, table);
    map.wrap = reader.boolean("wrap", false);
    read_filter(reader, map);
    map.uv = static_cast<UvSpan>(reader.choice("uv", {"edges", "centres", "turn"}, 0));
    if (map.wrap && map.uv == UvSpan::Centres) {
        reader.fail("uv", "uv = \"centres\" on a map that wraps",
                    "\"edges\" or \"turn\": one turn of a periodic map spans all its texels");
    }
    map.recipe.fbm.wrap = map.wrap;
    reader.finish();
    return map;
}

}  // namespace repousse::host
