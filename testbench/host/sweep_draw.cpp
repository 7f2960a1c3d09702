#include "testbench/host/sweep_draw.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "testbench/host/clip_registers.h"
#include "testbench/host/encoder.h"
#include "testbench/host/map/displacement_bound.h"
#include "testbench/host/shade_registers.h"
#include "testbench/host/z_table.h"

namespace repousse::host {
namespace {

/// The least and the greatest w of a mesh's vertices, not below w_min.
struct Depths {
    double least = std::numeric_limits<double>::max();
    double greatest = 0.0;
};

Depths depths_of(const DrawInputs& inputs, double w_min) {
    Depths depths;
    for (const glm::dvec3& p : inputs.mesh->positions) {
        const double w = std::max(w_min, glm::dot(inputs.view.forward, p - inputs.view.eye));
        depths.least = std::min(depths.least, w);
        depths.greatest = std::max(depths.greatest, w);
    }
    return depths;
}

/// max |D| in world units of a map with its filter levels. A level may be higher than all that it
/// replaces under a triangle, since its texels reach beyond the triangle, so it is one for all.
template <class P>
double most_of_levels(const Profile& profile, const DrawInputs& inputs, const SweepDraw<P>& draw) {
    const HeightMap& map = *inputs.map;
    const auto [least, greatest] =
        std::minmax_element(draw.tables.heights.begin(), draw.tables.heights.end());
    const double scale =
        (map.range_high - map.range_low) / static_cast<double>(profile.height.max_raw());
    return std::max(std::abs(map.range_low + *least * scale),
                    std::abs(map.range_low + *greatest * scale)) +
           stored_height_slack(profile, map);
}

template <class P>
Status set_triangles(const Profile& profile, const DrawInputs& inputs, SweepDraw<P>& draw) {
    const DisplacementBound bound(*inputs.map, stored_height_slack(profile, *inputs.map));
    const double of_levels =
        reads_levels(inputs.filter) ? most_of_levels(profile, inputs, draw) : 0.0;
    for (const auto& corners : inputs.mesh->triangles) {
        SweepBase<P> triangle;
        triangle.vertices = corners;
        triangle.direct = inputs.method == Method::Direct;
        if (!triangle.direct) {
            const double most =
                reads_levels(inputs.filter)
                    ? of_levels
                    : bound.of_triangle({draw.vertices[corners[0]].uv, draw.vertices[corners[1]].uv,
                                         draw.vertices[corners[2]].uv},
                                        profile.uv.frac);
            const auto value = max_displacement_register<P>(profile, most);
            if (!value) return value.error();
            triangle.max_displacement = *value;
        }
        draw.triangles.push_back(triangle);
    }
    return done();
}

}  // namespace

template <class P>
Result<SweepDraw<P>> make_sweep_draw(const Profile& profile, const DrawInputs& inputs) {
    const SweepSettings& s = inputs.sweep;
    if (inputs.bump && profile.components < kSweepComponents) {
        return Error{ErrorKind::Input,
                     {},
                     "displaced normals need a tangent at every vertex, and the profile has " +
                         std::to_string(profile.components) + " components",
                     "components = 13",
                     "leave out [object.bump] or choose a wider profile"};
    }
    const bool weighs =
        inputs.filter == HeightFilter::Bilinear || inputs.filter == HeightFilter::Average;
    if (weighs && profile.uv.frac == 0) {
        return Error{ErrorKind::Input,
                     {},
                     "heights of several texels are weighed by fractions of a texel",
                     "at least one fraction bit of uv",
                     "read the nearest or the highest texel or choose a wider uv"};
    }
    SweepDraw<P> draw;
    Encoder<P> encode(profile);
    draw.vertices = encode.vertices(inputs);
    encode.map(inputs, inputs.bump, draw.map, draw.tables);
    draw.camera = encode.camera(inputs.view);
    SweepRegisters<P>& r = draw.registers;
    r.use_bump = inputs.bump;
    if (inputs.shade) {
        const Result<ShadeRegisters<P>> shade = make_shade_registers<P>(profile, inputs);
        if (!shade) return shade.error();
        r.use_shade = true;
        r.shade = *shade;
    }
    r.use_clip = inputs.method == Method::Sweep && s.clip;

    const double w_min = s.w_min.value_or(inputs.camera.near);
    const Depths depths = depths_of(inputs, w_min);
    // The uniform table needs some length, also for an object that is flat across the view.
    const double far = std::max(depths.greatest, 1.001 * inputs.view.near);
    const GridCamera camera{inputs.view, s.coarseness_px, w_min, depths.least, far};
    const Result<GridRegisters<P>> grid = make_grid_registers<P>(profile, camera, draw.z_table);
    if (!grid) return grid.error();
    r.grid = *grid;
    r.clip = make_clip_registers<P>(profile, inputs.camera, inputs.viewport);
    r.setup.guard = s.guard_grid;
    // Depths are logarithms: the geometric mean is in their middle.
    r.setup.z_offset = static_cast<int32_t>(
        std::lround(grid_depth(camera, std::sqrt(depths.least * depths.greatest))));
    const Status fits = encode.status();
    if (!fits) return fits.error();
    if (const Status set = set_triangles(profile, inputs, draw); !set) return set.error();
    return draw;
}

template Result<SweepDraw<Fixed>> make_sweep_draw(const Profile&, const DrawInputs&);
template Result<SweepDraw<Real>> make_sweep_draw(const Profile&, const DrawInputs&);

}  // namespace repousse::host
