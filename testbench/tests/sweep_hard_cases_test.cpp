// The hard cases of sweep-line remeshing by name, through the whole pipeline at every level of
// arithmetic: closed meshes stay closed to the bit, base triangles are covered exactly once.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/study/closed_mesh.h"
#include "testbench/tests/support/sweep_scene.h"

namespace repousse {
namespace {

using test::expect_sound_at_every_level;
using test::GridTriangle;
using test::on_grid;
using test::place;
using test::remesh;
using test::tetrahedron;
using Outcome = test::SweepOutcome<Fixed>;
using Scene = test::SweepScene;

// A triangle on given grid points, and three more that close it up.
void expect_grid_case(const GridTriangle& t, const test::GridPoint& fourth) {
    expect_sound_at_every_level(on_grid(t, fourth), [&](const Outcome& outcome) {
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
    expect_sound_at_every_level(scene, [](const Outcome& outcome) {
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
    expect_sound_at_every_level(scene, [](const Outcome& outcome) {
        EXPECT_EQ(outcome.mesh.triangles.size(), 4u);
        EXPECT_EQ(outcome.counters.triangle_setup.single, 4u);
    });
}

// Far outside of the view, where the guard band holds them; thin, or they would be millions.
TEST(HardCase, CornersAtTheGuardBand) {
    Scene scene = on_grid({{{-9000, -9000, 0}, {9000, 9000, 0}, {9000, 4095, 0}}}, {4095, 9000, 0});
    scene.sweep.clip = false;
    expect_sound_at_every_level(scene, [](const Outcome& outcome) {
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
        expect_sound_at_every_level(scene, [](const Outcome& outcome) {
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
    expect_sound_at_every_level(scene, [](const Outcome& outcome) {
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
