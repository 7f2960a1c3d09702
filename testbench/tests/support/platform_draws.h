#pragma once

#include <cstdio>
#include <random>

#include "testbench/host/draw.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/sweep_draw.h"

namespace repousse::test {

/// A ring on a square seen from above, 160 pixels wide, for both methods.
inline host::DrawInputs inputs_for(const host::Mesh& mesh, bool bump) {
    static const host::HeightMap map = host::make_donut_map(64, 64);
    host::DrawInputs inputs;
    inputs.mesh = &mesh;
    inputs.map = &map;
    inputs.bump = bump;
    inputs.texel_size = glm::dvec2(1.0 / 64);
    inputs.camera.eye = {.5, -.6, .5};
    inputs.camera.target = {.5, .5, 0};
    inputs.viewport = {160, 120};
    inputs.view = host::view_frame(inputs.camera, inputs.viewport);
    return inputs;
}

inline const host::Mesh& grid() {
    static const host::Mesh mesh = host::make_grid(5, 5);
    return mesh;
}

inline SweepDraw<Fixed> sweep_draw(const Profile& profile, bool bump = false,
                                   double coarseness_px = 1) {
    host::DrawInputs inputs = inputs_for(grid(), bump);
    inputs.method = host::Method::Sweep;
    inputs.sweep.coarseness_px = coarseness_px;
    auto draw = host::make_sweep_draw<Fixed>(profile, inputs);
    if (!draw) std::fprintf(stderr, "%s\n", draw.error().message().c_str());
    return *draw;
}

/// The same from filter levels, 6 pixels a grid unit.
inline SweepDraw<Fixed> level_draw(const Profile& profile, host::LevelFilter levels,
                                   HeightFilter filter = HeightFilter::Maximum,
                                   int finer_levels = 0) {
    host::DrawInputs inputs = inputs_for(grid(), false);
    inputs.method = host::Method::Sweep;
    inputs.sweep.coarseness_px = 6;
    inputs.levels = levels;
    inputs.filter = filter;
    inputs.finer_levels = finer_levels;
    auto draw = host::make_sweep_draw<Fixed>(profile, inputs);
    if (!draw) std::fprintf(stderr, "%s\n", draw.error().message().c_str());
    return *draw;
}

inline AdaptiveDraw<Fixed> adaptive_draw(const Profile& profile) {
    host::DrawInputs inputs = inputs_for(grid(), false);
    inputs.settings.height_threshold = 4096;
    inputs.settings.view_threshold_px = 8;
    auto draw = host::make_draw<Fixed>(profile, inputs);
    if (!draw) std::fprintf(stderr, "%s\n", draw.error().message().c_str());
    return *draw;
}

// Base triangles that are not displaced, among the others.
inline SweepDraw<Fixed> with_direct_ones(SweepDraw<Fixed> draw, unsigned percent) {
    std::mt19937 random(11);
    for (SweepBase<Fixed>& triangle : draw.triangles) triangle.direct = random() % 100 < percent;
    return draw;
}

}  // namespace repousse::test
