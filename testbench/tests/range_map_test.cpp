// Range maps: a mesh as a cylindrical scanner sees it.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "testbench/host/map/range_map.h"
#include "testbench/host/mesh/procedural_mesh.h"

namespace repousse::host {
namespace {

double at(const ElevationGrid& grid, int x, int y) {
    return grid.samples[std::size_t(y) * std::size_t(grid.width) + std::size_t(x)];
}

// A sphere of radius 2: at height h the distance is sqrt(4 - h^2), a facet's sag less.
TEST(RangeMap, ASphereIsRound) {
    const Mesh sphere = make_icosphere(5, 2.0);
    const ElevationGrid grid = range_map(sphere, {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}}, 48, 20);
    ASSERT_EQ(grid.samples.size(), 48u * 20u);
    for (int y = 0; y < 20; ++y) {
        const double h = (y + .5) / 10 - 1;
        for (int x = 0; x < 48; ++x) {
            EXPECT_LE(at(grid, x, y), std::sqrt(4 - h * h) + 1e-9);
            EXPECT_GE(at(grid, x, y), std::sqrt(4 - h * h) - 3e-3);
        }
    }
    EXPECT_DOUBLE_EQ(grid.low, *std::min_element(grid.samples.begin(), grid.samples.end()));
    EXPECT_DOUBLE_EQ(grid.high, *std::max_element(grid.samples.begin(), grid.samples.end()));
}

// A square prism: u = 0 is the front, and u grows counter-clockwise.
TEST(RangeMap, TheFrontIsWhereItWasAskedFor) {
    Mesh box = make_cylinder(4, 1, std::sqrt(2.0), 2.0);  // corners at azimuth 0, 90, 180, 270
    for (glm::dvec3& p : box.positions) p.x += p.x > 1 ? 1.0 : 0.0;
    // The corner at azimuth 0 stands out. Seen from y, it comes three quarters of a turn later.
    const ElevationGrid x = range_map(box, {{0, 0, 0}, {0, 0, 2}, {1, 0, 0}}, 64, 4);
    const ElevationGrid y = range_map(box, {{0, 0, 0}, {0, 0, 2}, {0, 1, 0}}, 64, 4);
    EXPECT_GT(at(x, 0, 1), 2.0);
    EXPECT_GT(at(x, 63, 1), 2.0);
    for (int i = 0; i < 64; ++i) EXPECT_NEAR(at(y, (i + 48) % 64, 2), at(x, i, 2), 1e-9);
    // Turned over, the turn runs the other way.
    const ElevationGrid down = range_map(box, {{0, 0, 2}, {0, 0, 0}, {1, 0, 0}}, 64, 4);
    for (int i = 0; i < 64; ++i) EXPECT_NEAR(at(down, 63 - i, 1), at(x, i, 2), 1e-9);
}

TEST(RangeMap, TheOutermostSurfaceCounts) {
    Mesh shells = make_icosphere(3, 1.0);
    const Mesh outer = make_icosphere(3, 3.0);
    const auto first = static_cast<std::uint32_t>(shells.positions.size());
    shells.positions.insert(shells.positions.end(), outer.positions.begin(), outer.positions.end());
    for (const auto& t : outer.triangles) {
        shells.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    const ElevationGrid grid = range_map(shells, {{0, 0, -.5}, {0, 0, .5}, {1, 0, 0}}, 32, 8);
    EXPECT_GT(grid.low, 2.8);
}

// Above the mesh there is nothing to hit: the nearest row stands in. A wedge leaves columns empty.
TEST(RangeMap, HolesTakeTheNearestRow) {
    const Mesh cylinder = make_cylinder(64, 1, 1.0, 1.0);
    const ElevationGrid grid = range_map(cylinder, {{0, 0, -1}, {0, 0, 2}, {1, 0, 0}}, 16, 30);
    for (int x = 0; x < 16; ++x) {
        for (int y = 0; y < 10; ++y) EXPECT_EQ(at(grid, x, y), at(grid, x, 10));
        for (int y = 20; y < 30; ++y) EXPECT_EQ(at(grid, x, y), at(grid, x, 19));
    }
    Mesh wedge;
    wedge.positions = {{1, -.1, 0}, {1, .1, 0}, {1, 0, 2}};
    wedge.triangles = {{0, 1, 2}};
    const ElevationGrid part = range_map(wedge, {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, 90, 4);
    EXPECT_GT(at(part, 0, 0), 0.99);
    EXPECT_EQ(at(part, 45, 0), 0.0);
}

}  // namespace
}  // namespace repousse::host
