#include "testbench/host/scene/assets.h"

#include "testbench/host/files.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/procedural_mesh.h"

namespace repousse::host {
namespace {

/// The error of a file, with the scene line that names the file.
Error named_by(const SceneMark& mark, Error error) {
    error.advice += (error.advice.empty() ? "" : "; ") + ("named at " + mark.text());
    return error;
}

Result<ElevationGrid> read_grid(const std::string& path, const MapSource& source,
                                const ImageReader& image_reader) {
    if (extension_of(path) == ".npz") {
        Result<std::string> bytes = read_file(path);
        if (!bytes.ok()) return bytes.error();
        Result<ElevationGrid> grid = read_npz(*bytes, path);
        if (grid.ok() && source.samples) {
            grid->low = source.samples->x;
            grid->high = source.samples->y;
        }
        return grid;
    }
    if (!image_reader) {
        return Error{ErrorKind::Environment, path, "this program was built without image reading",
                     "an .npz map", ""};
    }
    return image_reader(path, source.samples);
}

HeightMap make_map(const MapRecipe& recipe) {
    const int w = recipe.width;
    const int h = recipe.height;
    switch (recipe.kind) {
        case MapKind::Donut:
            return make_donut_map(w, h);
        case MapKind::Ramp:
            return make_ramp_map(w, h, recipe.start, recipe.slope_x, recipe.slope_y);
        case MapKind::Checker:
            return make_checker_map(w, h, recipe.square, static_cast<std::uint16_t>(recipe.low),
                                    static_cast<std::uint16_t>(recipe.high));
        case MapKind::Fbm:
            return make_fbm_map(w, h, recipe.fbm);
        case MapKind::Constant:
        case MapKind::File:
            break;
    }
    return make_constant_map(w, h, static_cast<std::uint16_t>(recipe.value));
}

}  // namespace

Result<Mesh> load_mesh(const Object& object) {
    const MeshSource& source = object.mesh;
    switch (source.kind) {
        case MeshKind::Grid:
            return make_grid(source.columns, source.rows, source.size);
        case MeshKind::Cylinder:
            return make_cylinder(source.columns, source.rows, source.radius, source.height);
        case MeshKind::Icosphere:
            return make_icosphere(source.subdivisions, source.radius);
        case MeshKind::File:
            break;
    }
    Result<Mesh> mesh = read_mesh(source.file);
    if (!mesh.ok()) return named_by(source.mark, mesh.error());
    const Status status = complete_mesh(*mesh, source.projection, source.file);
    if (!status.ok()) return named_by(source.mark, status.error());
    return mesh;
}

Result<HeightMap> load_map(const Object& object, const ImageReader& image_reader) {
    const MapSource& source = object.map;
    HeightMap map;
    if (source.recipe.kind == MapKind::File) {
        Result<ElevationGrid> grid = read_grid(source.recipe.file, source, image_reader);
        if (!grid.ok()) return named_by(source.recipe.mark, grid.error());
        map = quantise(*grid);
    } else {
        map = make_map(source.recipe);
    }
    // A fallback has its final size already: a crop of the absent file means nothing to it.
    if (source.crop && !source.used_fallback) {
        const TexelBox& box = *source.crop;
        Result<HeightMap> part = crop(map, box.x, box.y, box.width, box.height);
        if (!part.ok()) {
            Error error = part.error();
            error.where = source.mark.text();
            return error;
        }
        map = std::move(*part);
    }
    if (source.resample) map = resample(map, source.resample->x, source.resample->y);
    if (source.flip_rows) flip_rows(map);
    map.wrap = source.wrap;
    map.range_low = source.range.x;
    map.range_high = source.range.y;
    return map;
}

glm::dvec2 texel_coordinate(glm::dvec2 uv, const HeightMap& map, UvSpan span) {
    if (span == UvSpan::Edges) return {uv.x * map.width, uv.y * map.height};
    return {uv.x * (map.width - 1) + 0.5, uv.y * (map.height - 1) + 0.5};
}

glm::dvec2 texel_size(const Mesh& mesh, const HeightMap& map, UvSpan span) {
    const double off = span == UvSpan::Centres ? 1.0 : 0.0;
    // A map one texel wide has no distance between texels; its slope is 0 whatever the divisor.
    const double columns = map.width > 1 ? map.width - off : 1.0;
    const double rows = map.height > 1 ? map.height - off : 1.0;
    return {mesh.world_per_uv.x / columns, mesh.world_per_uv.y / rows};
}

}  // namespace repousse::host
