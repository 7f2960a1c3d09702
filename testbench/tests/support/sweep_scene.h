#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "datapath/pipelines/sweep.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse::test {

/// Looks along -z from the origin; 64 grid units in x or y for each unit of x/w or y/w.
struct SweepScene {
    host::Mesh mesh;
    host::CameraSettings camera;
    host::SweepSettings sweep;
    double displacement = 0.02;
    std::optional<int32_t> z_offset;  // instead of the host's choice

    SweepScene() {
        camera.eye = {0, 0, 0};
        camera.target = {0, 0, -1};
        camera.up = {0, 1, 0};
        camera.fov_deg = 90;
        camera.near = 1;
        camera.far = 1000;
    }
    host::DrawInputs inputs(const host::HeightMap& map) const {
        host::DrawInputs inputs;
        inputs.mesh = &mesh;
        inputs.map = &map;
        inputs.method = host::Method::Sweep;
        inputs.sweep = sweep;
        inputs.camera = camera;
        inputs.viewport = {128, 128};
        inputs.view = host::view_frame(camera, inputs.viewport);
        return inputs;
    }
};

inline constexpr uint32_t kTetrahedron[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

inline host::Mesh tetrahedron(const std::array<glm::dvec3, 4>& corners) {
    host::Mesh mesh;
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.positions.push_back(corners[i]);
        mesh.uv.push_back({0.1 + 0.2 * double(i), 0.9 - 0.1 * double(i * i)});
    }
    for (const auto& t : kTetrahedron) mesh.triangles.push_back({t[0], t[1], t[2]});
    EXPECT_TRUE(host::complete_mesh(mesh, host::UvProjection::None, "tetrahedron"));
    return mesh;
}

/// The grid as this camera has it: where a vertex must lie to fall on a grid point. Depth 0 is at
/// w = 2^5, far from the rounding of positions.
inline constexpr double kMiddle = 5;
inline double steps_per_octave() { return std::log(2.0) / std::log1p(1.0 / 64); }
inline glm::dvec3 place(double x, double y, double z) {
    const double w = std::exp2(kMiddle + z / steps_per_octave());
    return {x * w / 64, -y * w / 64, -w};  // rows run downwards
}

/// A tetrahedron of which a base triangle and the fourth corner lie on given grid points.
inline SweepScene on_grid(const GridTriangle& t, const GridPoint& fourth) {
    SweepScene scene;
    std::array<glm::dvec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const GridPoint& p = i < 3 ? t[i] : fourth;
        corners[i] = place(p[0] + 0.1 * double(i), p[1], p[2]);  // no two in one place
    }
    scene.mesh = tetrahedron(corners);
    scene.z_offset = static_cast<int32_t>(std::lround(kMiddle * steps_per_octave()));
    return scene;
}

/// What the pipeline makes of a scene.
template <class P>
struct SweepOutcome {
    host::SweepInvariants invariants;
    SweepCounters counters;
    SweepMesh<P> mesh;
    std::array<std::array<int32_t, 3>, 4> slots{};  // of the first four vertices
};

template <class P>
SweepOutcome<P> remesh(const SweepScene& scene, const Profile& profile) {
    const host::HeightMap map = [&] {
        host::HeightMap waves = host::make_checker_map(64, 64, 8, 9000, 60000);
        waves.range_low = -scene.displacement;
        waves.range_high = scene.displacement;
        return waves;
    }();
    SweepOutcome<P> outcome;
    auto draw = host::make_sweep_draw<P>(profile, scene.inputs(map));
    EXPECT_TRUE(draw) << draw.error().message();
    if (!draw) return outcome;
    if (scene.z_offset) draw->registers.setup.z_offset = *scene.z_offset;
    SweepPipeline<P> pipeline(profile, *draw);
    EXPECT_TRUE(pipeline.run(outcome.mesh));
    outcome.counters = pipeline.counters();
    outcome.invariants = host::SweepJudge<P>(profile, *draw, scene.mesh).judge(outcome.mesh);

    VertexTransform<P> transform(profile);
    GridTransform<P> grid(profile);
    TriangleSetup setup;
    transform.configure(draw->camera);
    grid.configure(draw->registers.grid);
    setup.configure(draw->registers.setup);
    for (std::size_t i = 0; i < 4 && i < draw->vertices.size(); ++i) {
        outcome.slots[i] = setup.slot(grid(transform.eye(draw->vertices[i].position)).position);
    }
    return outcome;
}

template <class P>
void expect_sound(const SweepOutcome<P>& outcome, const std::string& what) {
    EXPECT_GT(outcome.mesh.triangles.size(), 0u) << what;
    EXPECT_EQ(outcome.invariants.open_edges, 0u) << what;
    EXPECT_EQ(outcome.invariants.cracked, 0u) << what;
    EXPECT_EQ(outcome.invariants.seam_cracked, 0u) << what;
    EXPECT_EQ(outcome.invariants.degenerate, 0u) << what;
    EXPECT_EQ(outcome.invariants.uncovered, 0u) << what;
    EXPECT_EQ(outcome.counters.sweep_line.runaways, 0u) << what;
    EXPECT_EQ(outcome.counters.strip.bad_refs, 0u) << what;
}

/// Two lanes, one lane, canonical adders, every form of the depth table, and level ref; what they
/// make of the case besides is for `also`.
inline void expect_sound_at_every_level(
    const SweepScene& scene,
    const std::function<void(const SweepOutcome<Fixed>&)>& also = nullptr) {
    using Changes = std::vector<std::pair<std::string, std::string>>;
    for (const Changes& changes :
         {Changes{}, Changes{{"column_depth", "0"}}, Changes{{"adder_kind", "1"}},
          Changes{{"z_table_kind", "2"}, {"z_table_index_bits", "4"}, {"column_depth", "3"}},
          Changes{{"sweep_data", "s15.8 SC_RND SC_SAT"}}}) {
        const Profile profile = profile_with("default", changes);
        const auto outcome = remesh<Fixed>(scene, profile);
        expect_sound(outcome, changes.empty() ? "default" : changes[0].first);
        if (also) also(outcome);
    }
    const Profile profile = host::reference_profile(profile_with("default", {}));
    expect_sound(remesh<Real>(scene, profile), "ref");
}

}  // namespace repousse::test
