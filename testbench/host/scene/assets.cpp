#include "testbench/host/scene/assets.h"

#include <cmath>

#include <glm/common.hpp>

#include "testbench/host/files.h"
#include "testbench/host/map/json_reader.h"
#include "testbench/host/map/netcdf_reader.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/map/range_map.h"
#include "testbench/host/map/voids.h"
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
    using Reader = Result<ElevationGrid> (*)(const std::string&, const std::string&);
    const std::string type = extension_of(path);
    const Reader reader = type == ".npz"                    ? read_npz
                          : type == ".json"                 ? read_json_grid
                          : type == ".nc" || type == ".cdf" ? read_netcdf
                                                            : nullptr;
    if (reader != nullptr) {
        Result<std::string> bytes = read_file(path);
        if (!bytes.ok()) return bytes.error();
        Result<ElevationGrid> grid = reader(*bytes, path);
        if (grid.ok() && source.samples) {
            grid->low = source.samples->x;
            grid->high = source.samples->y;
            grid->measured = false;
        }
        return grid;
    }
    if (!image_reader) {
        return Error{ErrorKind::Environment, path, "this program was built without image reading",
                     "an .npz, .json, .nc or .cdf map", ""};
    }
    return image_reader(path, source.samples);
}

/// Voids are filled if the scene asks for it, and refused otherwise.
Result<HeightMap> quantise_file(ElevationGrid grid, const MapSource& source) {
    if (source.void_value) mark_voids(grid, *source.void_value);
    std::size_t filled = 0;
    if (source.fill_voids || source.void_value) {
        const Result<std::size_t> count = fill_voids(grid, source.wrap, source.recipe.file);
        if (!count.ok()) return count.error();
        filled = *count;
    } else {
        const Status status = refuse_voids(grid, source.recipe.file);
        if (!status.ok()) return status.error();
    }
    HeightMap map = quantise(grid);
    map.filled_texels = filled;
    return map;
}

Result<ElevationGrid> scan_mesh(const MapSource& source) {
    const MapRecipe& recipe = source.recipe;
    const Result<Mesh> mesh = read_mesh(recipe.file);
    if (!mesh.ok()) return mesh.error();
    ElevationGrid grid = range_map(*mesh, recipe.axis, recipe.width, recipe.height);
    if (source.samples) {
        grid.low = source.samples->x;
        grid.high = source.samples->y;
    }
    return grid;
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
        case MapKind::Range:
            break;
    }
    return make_constant_map(w, h, static_cast<std::uint16_t>(recipe.value));
}

Result<Mesh> make_mesh(const MeshSource& source) {
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

// Equal positions stay equal, so that the sides of a seam still meet.
void place(Mesh& mesh, const MeshSource& source) {
    if (source.turn_deg != 0.0) {
        const double angle = source.turn_deg * 3.14159265358979323846 / 180.0;
        const double c = std::cos(angle), s = std::sin(angle);
        for (auto* vectors : {&mesh.positions, &mesh.normals, &mesh.tangents}) {
            for (glm::dvec3& v : *vectors) v = {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
        }
    }
    for (glm::dvec3& p : mesh.positions) p += source.translation;
}

}  // namespace

Result<Mesh> load_mesh(const Object& object) {
    Result<Mesh> mesh = make_mesh(object.mesh);
    if (mesh.ok()) place(*mesh, object.mesh);
    return mesh;
}

Result<HeightMap> load_map(const Object& object, const ImageReader& image_reader) {
    const MapSource& source = object.map;
    HeightMap map;
    const MapKind kind = source.recipe.kind;
    if (kind == MapKind::File || kind == MapKind::Range) {
        Result<ElevationGrid> grid = kind == MapKind::Range
                                         ? scan_mesh(source)
                                         : read_grid(source.recipe.file, source, image_reader);
        if (!grid.ok()) return named_by(source.recipe.mark, grid.error());
        Result<HeightMap> heights = quantise_file(std::move(*grid), source);
        if (!heights.ok()) return named_by(source.recipe.mark, heights.error());
        map = std::move(*heights);
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

namespace {

/// By axis: whether uv 0..1 spans borders instead of centres.
glm::bvec2 spans_edges(UvSpan span) { return {span != UvSpan::Centres, span == UvSpan::Edges}; }

}  // namespace

glm::dvec2 texel_coordinate(glm::dvec2 uv, const HeightMap& map, UvSpan span) {
    const glm::dvec2 size{map.width, map.height};
    return glm::mix(uv * (size - 1.0) + 0.5, uv * size, spans_edges(span));
}

glm::dvec2 map_uv(glm::dvec2 texel, const HeightMap& map, UvSpan span) {
    const glm::dvec2 size{map.width, map.height};
    return glm::mix((texel - 0.5) / glm::max(size - 1.0, glm::dvec2(1.0)), texel / size,
                    spans_edges(span));
}

glm::dvec2 texel_size(const Mesh& mesh, const HeightMap& map, UvSpan span) {
    const glm::bvec2 edges = spans_edges(span);
    // A map one texel wide has no distance between texels; its slope is 0 whatever the divisor.
    const double columns = map.width > 1 ? map.width - (edges.x ? 0.0 : 1.0) : 1.0;
    const double rows = map.height > 1 ? map.height - (edges.y ? 0.0 : 1.0) : 1.0;
    return {mesh.world_per_uv.x / columns, mesh.world_per_uv.y / rows};
}

}  // namespace repousse::host
