// Remeshed closed meshes stay closed when they are displaced from filter levels that change across
// the surface: every vertex has one name from all triangles around it, and every name one set of
// bits behind `displace`. Cameras stand outside and inside, so that both sides are seen; the map is
// noise, so that another level is another height.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

#include <glm/geometric.hpp>

#include "testbench/host/files.h"
#include "testbench/host/map/level_table.h"
#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/study/closed_mesh.h"
#include "testbench/study/sweep_mesh.h"
#include "testbench/tests/support/profiles.h"

namespace repousse::study {
namespace {

constexpr int kCameras = 16;

struct Case {
    const char* name;
    host::Mesh mesh;
    int height_px = 56;
};

/// A map of noise with its levels, a tenth of a world unit high.
struct Noise {
    host::LevelTable table;
    MapView<Fixed> view;

    Noise(int width, int height, bool wrap, host::LevelFilter kind, HeightFilter filter,
          int finer = 0) {
        std::mt19937_64 random(7);
        host::HeightMap map;
        map.width = width;
        map.height = height;
        map.wrap = wrap;
        map.texels.resize(std::size_t(width) * std::size_t(height));
        for (auto& h : map.texels) h = uint16_t(random());
        table = host::make_level_table(map, kind);
        view.width = width;
        view.height = height;
        view.wrap = wrap;
        view.filter = filter;
        view.finer = finer;
        view.last_level = table.last_level;
        view.has_minima = table.has_minima;
        view.heights = table.heights;
        view.scale_exponent = 43;
        view.scale_mantissa = int32_t(std::lround(std::ldexp(0.1 / 65535, 43)));
    }
    Noise(const Noise&) = delete;
    Noise& operator=(const Noise&) = delete;
};

struct Total {
    std::size_t triangles = 0, vertices = 0, edge_vertices = 0, open = 0, cracked = 0;
    std::size_t cracked_edge_vertices = 0, overflows = 0, clamped_w = 0;
    FootprintCounters footprints;
    std::array<uint64_t, kMostLevels + 1> jumps{}, corner_jumps{};
    uint64_t mixed = 0;

    /// Fine edges without a corner whose ends are at least so many levels apart.
    uint64_t apart(std::size_t levels) const {
        uint64_t count = 0;
        for (std::size_t k = levels; k < jumps.size(); ++k) count += jumps[k] - corner_jumps[k];
        return count;
    }
};

template <std::size_t n>
void add(std::array<uint64_t, n>& to, const std::array<uint64_t, n>& from) {
    for (std::size_t i = 0; i < n; ++i) to[i] += from[i];
}

Total run(const Case& c, const Noise& noise, bool edge_rule = true) {
    std::mt19937_64 random(3);
    MeshRemesher remesher(test::profile_with("default", {}), c.mesh);
    Total total;
    for (int n = 0; n < kCameras; ++n) {
        const auto camera = random_camera(random, 1, n % 4 == 3);
        MeshSetting setting;
        setting.adder = n % 2 == 0 ? AdderKind::Exact : AdderKind::Canonical;
        setting.data_frac = std::array{16, 12, 8, 16}[std::size_t(n) % 4];
        setting.column_depth = n % 5 == 0 ? 0 : 256;
        setting.guard_grid = c.height_px;
        setting.map = &noise.view;
        setting.edge_rule = edge_rule;
        const MeshFigures f = remesher.run(camera, {c.height_px * 4 / 3, c.height_px}, setting);
        total.triangles += f.mesh.triangles;
        total.vertices += f.mesh.vertices;
        total.edge_vertices += f.mesh.edge_vertices;
        total.open += f.mesh.open_edges;
        total.cracked += f.mesh.cracked;
        total.cracked_edge_vertices += f.mesh.cracked_edge_vertices;
        total.overflows += f.overflows;
        total.clamped_w += f.clamped_w;
        total.mixed += f.mixed;
        total.footprints.items += f.footprints.items;
        total.footprints.back += f.footprints.back;
        add(total.footprints.levels, f.footprints.levels);
        add(total.jumps, f.jumps);
        add(total.corner_jumps, f.corner_jumps);
    }
    return total;
}

void expect_watertight(const Case& c, const Noise& noise, const char* what) {
    ASSERT_EQ(host::mesh_check(c.mesh).boundary_edges, 0u) << c.name;
    const Total t = run(c, noise);
    const auto from_corners =
        std::accumulate(t.corner_jumps.begin() + 1, t.corner_jumps.end(), uint64_t{0});
    std::printf(
        "%s, %s: %zu fine triangles, %zu vertices, %zu on edges, %.0f %% seen from the "
        "back; fine edges with a jump of 1 level %llu, of 3 %llu, of 3 and more %llu, at "
        "corners %llu, from front to back %llu\n",
        c.name, what, t.triangles, t.vertices, t.edge_vertices,
        100.0 * double(t.footprints.back) / double(t.footprints.items),
        (unsigned long long)(t.apart(1) - t.apart(2)),
        (unsigned long long)(t.apart(3) - t.apart(4)), (unsigned long long)t.apart(3),
        (unsigned long long)from_corners, (unsigned long long)t.mixed);
    EXPECT_EQ(t.open, 0u) << c.name;
    EXPECT_EQ(t.cracked, 0u) << c.name << ": one name, two places";
    EXPECT_EQ(t.overflows, 0u);
    EXPECT_GT(t.edge_vertices, 10'000u);
    EXPECT_GT(t.clamped_w, 0u) << "no camera had a vertex behind it";
    EXPECT_GT(t.apart(1) - t.apart(2), 1000u) << "jumps of one level";
    EXPECT_GT(t.apart(3) - t.apart(4), 100u) << "jumps of three levels";
    EXPECT_GT(t.apart(3), 500u) << "jumps of three levels and more";
    EXPECT_GT(from_corners, 1000u);
    EXPECT_GT(t.mixed, 100u);
    EXPECT_GT(t.footprints.back, t.footprints.items / 10);
    EXPECT_LT(t.footprints.back, t.footprints.items * 19 / 20);
}

void expect_watertight_in_all_ways(const Case& c) {
    using host::LevelFilter;
    expect_watertight(c, {512, 512, false, LevelFilter::BoxMaximum, HeightFilter::Maximum},
                      "box maxima");
    expect_watertight(c, {512, 512, true, LevelFilter::BoxMaximum, HeightFilter::Maximum},
                      "box maxima, periodic");
    expect_watertight(c, {512, 512, true, LevelFilter::BoxMaximum, HeightFilter::Maximum, 1},
                      "box maxima one level finer, periodic");
    expect_watertight(c, {300, 417, false, LevelFilter::Average, HeightFilter::Maximum},
                      "averages, highest");
    expect_watertight(c, {300, 417, true, LevelFilter::Average, HeightFilter::Average},
                      "averages, average, periodic");
    expect_watertight(c, {128, 100, false, LevelFilter::Variational, HeightFilter::Maximum},
                      "variational");
    expect_watertight(c, {300, 417, false, LevelFilter::Variational, HeightFilter::Maximum, 2},
                      "variational two levels finer");
}

Case icosphere(int subdivisions) {
    return {"icosphere", welded(host::make_icosphere(subdivisions, 1))};
}

TEST(LevelsWatertight, Icosphere) { expect_watertight_in_all_ways(icosphere(2)); }

TEST(LevelsWatertight, CappedCylinder) {
    expect_watertight_in_all_ways({"capped cylinder", make_capped_cylinder(12, 6, 0.6, 1.6)});
}

TEST(LevelsWatertight, Bunny) {
    const char* const file = "inputs/bunny00.off";
    if (!host::is_file(file)) GTEST_SKIP() << file << " is absent: scenes/fetch.sh gets it";
    auto read = host::read_mesh(file);
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_TRUE(host::complete_mesh(*read, host::UvProjection::Spherical, file));
    Case c{"bunny00", welded(*read), 30};
    const host::MeshDiagnosis found = host::mesh_check(c.mesh);
    const glm::dvec3 centre = 0.5 * (found.low + found.high);
    double radius = 0;
    for (const auto& p : c.mesh.positions) radius = std::max(radius, glm::distance(p, centre));
    for (auto& p : c.mesh.positions) p = (p - centre) / radius;
    expect_watertight_in_all_ways(c);
}

// Negative control: with footprints of the sweep on edges too, which the two triangles at an edge
// do not share, vertices on edges are torn apart.
TEST(LevelsWatertight, SweepFootprintsOnEdgesCrack) {
    const Noise noise(512, 512, false, host::LevelFilter::BoxMaximum, HeightFilter::Maximum);
    for (const Case& c :
         {icosphere(2), Case{"capped cylinder", make_capped_cylinder(12, 6, 0.6, 1.6)}}) {
        const Total t = run(c, noise, false);
        std::printf("%s without the edge rule: %zu of %zu vertices on edges crack\n", c.name,
                    t.cracked_edge_vertices, t.edge_vertices);
        EXPECT_EQ(t.open, 0u) << "the triangles do not depend on the map";
        EXPECT_GT(t.cracked_edge_vertices, t.edge_vertices / 10) << c.name;
    }
}

// One texel, a map smaller than any footprint, and all at the top.
TEST(LevelsWatertight, SmallAndFlatMaps) {
    for (const auto& [width, height] : {std::array{1, 1}, std::array{2, 1}, std::array{3, 5}}) {
        for (const bool wrap : {false, true}) {
            for (int finer = 0; finer <= kMostFiner; ++finer) {
                const Noise noise(width, height, wrap, host::LevelFilter::BoxMaximum,
                                  HeightFilter::Maximum, finer);
                const Total t = run(icosphere(1), noise);
                EXPECT_EQ(t.open, 0u);
                EXPECT_EQ(t.cracked, 0u) << width << " x " << height << ", finer " << finer;
            }
        }
    }
    Noise top(64, 64, true, host::LevelFilter::BoxMaximum, HeightFilter::Maximum);
    top.table.heights.assign(top.table.heights.size(), 65535);
    const Total t = run(icosphere(1), top);
    EXPECT_EQ(t.cracked, 0u);
    EXPECT_EQ(t.overflows, 0u);
}

}  // namespace
}  // namespace repousse::study
