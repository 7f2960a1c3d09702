// The hard cases of sweep-line remeshing by name, through the whole pipeline at every level of
// arithmetic: closed meshes stay closed to the bit, base triangles are covered exactly once.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <random>

#include "datapath/pipelines/sweep.h"
#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/study/sweep_mesh.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using test::GridTriangle;

// Looks along -z from the origin; 64 grid units in x or y for each unit of x/w or y/w.
struct Scene {
    host::Mesh mesh;
    host::CameraSettings camera;
    host::SweepSettings sweep;
    double displacement = 0.02;
    std::optional<int32_t> z_offset;  // instead of the host's choice

    Scene() {
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

constexpr uint32_t kTetrahedron[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};

host::Mesh tetrahedron(const std::array<glm::dvec3, 4>& corners) {
    host::Mesh mesh;
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.positions.push_back(corners[i]);
        mesh.uv.push_back({0.1 + 0.2 * double(i), 0.9 - 0.1 * double(i * i)});
    }
    for (const auto& t : kTetrahedron) mesh.triangles.push_back({t[0], t[1], t[2]});
    EXPECT_TRUE(host::complete_mesh(mesh, host::UvProjection::None, "tetrahedron"));
    return mesh;
}

// The grid as this camera has it: where a vertex must lie to fall on a grid point. Depth 0 is at
// w = 2^5, far from the rounding of positions.
constexpr double kMiddle = 5;
double steps_per_octave() { return std::log(2.0) / std::log1p(1.0 / 64); }
glm::dvec3 place(double x, double y, double z) {
    const double w = std::exp2(kMiddle + z / steps_per_octave());
    return {x * w / 64, -y * w / 64, -w};  // rows run downwards
}

Scene on_grid(const GridTriangle& t, const test::GridPoint& fourth) {
    Scene scene;
    std::array<glm::dvec3, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const test::GridPoint& p = i < 3 ? t[i] : fourth;
        corners[i] = place(p[0] + 0.1 * double(i), p[1], p[2]);  // no two in one place
    }
    scene.mesh = tetrahedron(corners);
    scene.z_offset = static_cast<int32_t>(std::lround(kMiddle * steps_per_octave()));
    return scene;
}

template <class P>
struct Outcome {
    host::SweepInvariants invariants;
    SweepCounters counters;
    SweepMesh<P> mesh;
    std::array<std::array<int32_t, 3>, 4> slots{};  // of the first four vertices
};

template <class P>
Outcome<P> remesh(const Scene& scene, const Profile& profile) {
    const host::HeightMap map = [&] {
        host::HeightMap waves = host::make_checker_map(64, 64, 8, 9000, 60000);
        waves.range_low = -scene.displacement;
        waves.range_high = scene.displacement;
        return waves;
    }();
    Outcome<P> outcome;
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
void expect_sound(const Outcome<P>& outcome, const std::string& what) {
    EXPECT_GT(outcome.mesh.triangles.size(), 0u) << what;
    EXPECT_EQ(outcome.invariants.open_edges, 0u) << what;
    EXPECT_EQ(outcome.invariants.cracked, 0u) << what;
    EXPECT_EQ(outcome.invariants.seam_cracked, 0u) << what;
    EXPECT_EQ(outcome.invariants.degenerate, 0u) << what;
    EXPECT_EQ(outcome.invariants.uncovered, 0u) << what;
    EXPECT_EQ(outcome.counters.sweep_line.runaways, 0u) << what;
    EXPECT_EQ(outcome.counters.strip.bad_refs, 0u) << what;
}

// Two lanes, one lane, canonical adders, every form of the depth table, and level ref; what they
// make of the case besides is for `also`.
void expect_sound_at_every_level(const Scene& scene,
                                 const std::function<void(const Outcome<Fixed>&)>& also = nullptr) {
    using Changes = std::vector<std::pair<std::string, std::string>>;
    for (const Changes& changes :
         {Changes{}, Changes{{"column_depth", "0"}}, Changes{{"adder_kind", "1"}},
          Changes{{"z_table_kind", "2"}, {"z_table_index_bits", "4"}, {"column_depth", "3"}},
          Changes{{"sweep_data", "s15.8 SC_RND SC_SAT"}}}) {
        const Profile profile = test::profile_with("default", changes);
        const auto outcome = remesh<Fixed>(scene, profile);
        expect_sound(outcome, changes.empty() ? "default" : changes[0].first);
        if (also) also(outcome);
    }
    const Profile profile = host::reference_profile(test::profile_with("default", {}));
    expect_sound(remesh<Real>(scene, profile), "ref");
}

// A triangle on given grid points, and three more that close it up.
void expect_grid_case(const GridTriangle& t, const test::GridPoint& fourth) {
    expect_sound_at_every_level(on_grid(t, fourth), [&](const Outcome<Fixed>& outcome) {
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(outcome.slots[i], i < 3 ? t[i] : fourth) << i;
    });
}

TEST(HardCase, SliversOfHeightOne) {
    for (const int n : {2, 7, 24, 40}) {
        for (const int k : {0, 1, n / 2, n - 1, n}) {
            expect_grid_case({{{0, 0, 0}, {n, 0, 0}, {k, 1, 0}}}, {k, 5, 2});
            expect_grid_case({{{-n, 1, 0}, {0, 1, n}, {k - n, 2, k}}}, {3, 1, 3});
        }
    }
}

TEST(HardCase, RoofWithTheSplitAtACorner) {
    expect_grid_case({{{0, 0, 0}, {9, 2, 0}, {0, 7, 3}}}, {4, 4, 9});
    expect_grid_case({{{0, 0, 0}, {9, 2, 0}, {9, 8, 3}}}, {4, 4, -9});
}

TEST(HardCase, ThreeEdgePointsInOneSlot) {
    expect_grid_case({{{6, 6, 3}, {6, 2, 0}, {1, 0, 4}}}, {12, 12, 0});
    expect_grid_case({{{1, 0, 2}, {0, 6, 1}, {4, 4, 2}}}, {-3, 2, 7});
}

TEST(HardCase, ThreeDifferentMainDirections) {
    expect_grid_case({{{0, 0, 0}, {10, 1, 2}, {7, 8, 9}}}, {3, -4, 12});
    expect_grid_case({{{0, 0, 0}, {-50, 10, 20}, {-7, 45, 9}}}, {-20, 20, -60});
}

// Edges whose points lie in the middle between two slots, and corners that do: half up.
TEST(HardCase, ExactHalfTies) {
    for (const int n : {2, 8, 30}) {
        for (const int odd : {1, n / 2, n - 1}) {
            expect_grid_case({{{0, 0, 0}, {n, odd, 0}, {n / 2, n + 1, 0}}}, {1, 1, 5});
            expect_grid_case({{{0, 0, 0}, {n, n / 2, odd}, {odd, -n, n / 2}}}, {-n, 0, -1});
        }
    }
    Scene scene;
    scene.camera.near = 0.5;
    const auto at = [](double x, double y) { return glm::dvec3{x / 64, -y / 64, -1}; };
    scene.mesh = tetrahedron({at(0.5, -0.5), at(7.5, 0.5), at(3.5, 9.5), at(-0.5, 4.5)});
    expect_sound_at_every_level(scene, [](const Outcome<Fixed>& outcome) {
        const int32_t expected[4][2] = {{1, 0}, {8, 1}, {4, 10}, {0, 5}};
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(outcome.slots[i][0], expected[i][0]) << i;
            EXPECT_EQ(outcome.slots[i][1], expected[i][1]) << i;
        }
    });
}

TEST(HardCase, CornersOnOneGridPoint) {
    expect_grid_case({{{5, 5, 5}, {5, 5, 5}, {6, 5, 5}}}, {5, 5, 6});
    expect_grid_case({{{5, 5, 5}, {5, 5, 5}, {-40, 17, 5}}}, {5, 6, 5});
    expect_grid_case({{{0, 0, 0}, {3, 3, 3}, {9, 9, 9}}}, {27, 27, 27});
    Scene scene = on_grid({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}}, {5, 5, 5});
    expect_sound_at_every_level(scene, [](const Outcome<Fixed>& outcome) {
        EXPECT_EQ(outcome.mesh.triangles.size(), 4u);
        EXPECT_EQ(outcome.counters.triangle_setup.single, 4u);
    });
}

// Far outside of the view, where the guard band holds them; thin, or they would be millions.
TEST(HardCase, CornersAtTheGuardBand) {
    Scene scene = on_grid({{{-9000, -9000, 0}, {9000, 9000, 0}, {9000, 4095, 0}}}, {4095, 9000, 0});
    scene.sweep.clip = false;
    expect_sound_at_every_level(scene, [](const Outcome<Fixed>& outcome) {
        EXPECT_EQ(outcome.slots[0], (test::GridPoint{-4096, -4096, 0}));
        EXPECT_EQ(outcome.slots[1], (test::GridPoint{4096, 4096, 0}));
        EXPECT_EQ(outcome.slots[2], (test::GridPoint{4096, 4095, 0}));
        EXPECT_GE(outcome.counters.triangle_setup.clamped, 3u);
        EXPECT_GT(outcome.mesh.triangles.size(), 4u * 4096);
    });
}

// The eye in the middle, on a face, on an edge, and in a corner; every face then goes through it or
// round it, and has corners with w <= 0.
TEST(HardCase, TriangleThroughTheEye) {
    const std::array<glm::dvec3, 4> corners = {
        glm::dvec3{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    const glm::dvec3 eyes[] = {{0, 0, 0},
                               (corners[0] + corners[1] + corners[2]) / 3.0,
                               (corners[0] + corners[2]) / 2.0,
                               corners[1]};
    for (const glm::dvec3& eye : eyes) {
        Scene scene;
        scene.camera.near = 0.05;
        scene.sweep.guard_grid = 64;
        scene.sweep.clip = false;
        auto moved = corners;
        for (glm::dvec3& corner : moved) corner -= eye;
        scene.mesh = tetrahedron(moved);
        expect_sound_at_every_level(scene, [](const Outcome<Fixed>& outcome) {
            EXPECT_GE(outcome.counters.grid_transform.w_clamped, 1u);
        });
    }
}

TEST(HardCase, WAtItsClamp) {
    const double lsb = std::ldexp(1.0, -16);
    Scene scene;
    scene.camera.near = 0.25;
    scene.sweep.w_min = 0.25;
    scene.sweep.guard_grid = 100;
    scene.sweep.clip = false;
    scene.mesh = tetrahedron(
        {glm::dvec3{0, 0, -0.25}, {0.2, 0, -0.25 + lsb}, {0, 0.2, -0.25 - lsb}, {0.1, 0.1, -0.5}});
    expect_sound_at_every_level(scene, [](const Outcome<Fixed>& outcome) {
        EXPECT_EQ(outcome.counters.grid_transform.w_clamped, 1u) << "one vertex is nearer";
        EXPECT_EQ(outcome.slots[0][2], outcome.slots[1][2]);
    });
}

// No clip plane may depend on near - d_max (equation 8 has a pole there): what is rejected must not
// be visible. Brute force: without the clip, no vertex of a rejected triangle is in the view.
TEST(HardCase, DisplacementLargerThanTheNearDistance) {
    const Profile profile = test::profile_with("default", {});
    std::mt19937_64 random(9);
    std::size_t rejected = 0;
    for (int n = 0; n < 40; ++n) {
        Scene scene;
        scene.mesh = host::make_icosphere(1, 1);
        scene.camera = study::random_camera(random, 1, n % 3 == 0);
        scene.camera.near = 0.05;
        scene.camera.far = 1 + double(n % 5);
        scene.displacement = n % 2 == 0 ? 0.2 : 0.1;
        scene.sweep.guard_grid = 40;
        const auto clipped = remesh<Fixed>(scene, profile);
        EXPECT_EQ(clipped.invariants.open_edges, 0u);
        EXPECT_EQ(clipped.invariants.cracked, 0u);
        scene.sweep.clip = false;
        const auto whole = remesh<Fixed>(scene, profile);
        std::vector<bool> kept(scene.mesh.triangles.size());
        for (const auto& triangle : clipped.mesh.triangles) kept[triangle.base] = true;
        const auto view = host::view_projection(scene.camera, {128, 128});
        for (const auto& triangle : whole.mesh.triangles) {
            if (kept[triangle.base]) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& p = whole.mesh.corner(triangle, k).displaced;
                const auto s = view.project(
                    {std::ldexp(p.x, -16), std::ldexp(p.y, -16), std::ldexp(p.z, -16)});
                const bool visible = s.w >= view.near && s.w <= view.far && s.x >= 0 &&
                                     s.x <= 128 && s.y >= 0 && s.y <= 128;
                EXPECT_FALSE(visible) << n << ", base triangle " << triangle.base;
            }
        }
        ASSERT_TRUE(clipped.counters.view_clip.has_value());
        rejected += clipped.counters.view_clip->rejected;
    }
    EXPECT_GT(rejected, 500u);
}

}  // namespace
}  // namespace repousse
