// Voids, the samples of an elevation grid without an elevation: marked, refused, filled, and on
// their way through a scene; and maps that are bad in other ways.
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/map/voids.h"
#include "testbench/host/scene/assets.h"

namespace repousse::host {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ElevationGrid grid_of(int width, std::vector<double> samples) {
    ElevationGrid grid;
    grid.width = width;
    grid.height = static_cast<int>(samples.size()) / width;
    grid.samples = std::move(samples);
    measure_range(grid);
    return grid;
}

TEST(Voids, AMarkedValueLeavesTheMeasuredRange) {
    ElevationGrid grid = grid_of(2, {-32768, 10, 20, -32768});
    EXPECT_EQ(grid.low, -32768);
    mark_voids(grid, -32768);
    EXPECT_EQ(grid.low, 10);
    EXPECT_EQ(grid.high, 20);
    grid.measured = false;  // a declared range stays
    mark_voids(grid, 10);
    EXPECT_EQ(grid.low, 10);
}

TEST(Voids, AreFilledFromTheirRimWithMeans) {
    ElevationGrid grid = grid_of(5, {1, kNan, kNan, kNan, 9});
    const auto filled = fill_voids(grid, false, "m");
    ASSERT_TRUE(filled.ok());
    EXPECT_EQ(*filled, 3u);
    EXPECT_EQ(grid.samples, (std::vector<double>{1, 1, 5, 9, 9}));
    // Across the seam when the map wraps.
    for (const bool wrap : {false, true}) {
        grid = grid_of(3, {kNan, 3, 9});
        ASSERT_TRUE(fill_voids(grid, wrap, "m").ok());
        EXPECT_EQ(grid.samples, (std::vector<double>{wrap ? 6.0 : 3.0, 3, 9}));
    }
}

TEST(Voids, ABigHoleIsFilledWithinItsRimsHeightsAndNothingElseMoves) {
    constexpr int kSide = 200;
    std::vector<double> samples;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide - 90, y = i / kSide - 110;
        samples.push_back(x * x + y * y < 80 * 80 ? kNan : i % 7 + 100);
    }
    ElevationGrid grid = grid_of(kSide, samples);
    const auto filled = fill_voids(grid, false, "m");
    ASSERT_TRUE(filled.ok());
    std::size_t holes = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::isnan(samples[i])) {
            ++holes;
            EXPECT_GE(grid.samples[i], 100);
            EXPECT_LE(grid.samples[i], 106);
        } else {
            EXPECT_EQ(grid.samples[i], samples[i]);
        }
    }
    EXPECT_EQ(*filled, holes);
}

TEST(Voids, AllVoidsOrNoneAskedForAreErrors) {
    ElevationGrid grid = grid_of(2, {kNan, kNan});
    const auto filled = fill_voids(grid, true, "m.npz");
    ASSERT_FALSE(filled.ok());
    EXPECT_EQ(filled.error().message(),
              "m.npz: no texel has a height: all are voids, expected at least one finite height");
    EXPECT_EQ(quantise(grid).texels, (std::vector<std::uint16_t>{0, 0}));
    EXPECT_EQ(refuse_voids(grid_of(2, {1, 2, kNan, 3}), "m.npz").error().message(),
              "m.npz: texel (0, 1) is not finite, expected finite heights; fill_voids = true fills "
              "such texels");
}

/// The map of a scene whose file is `json`; `keys` go into its map table.
Result<HeightMap> scene_map(const std::string& json, const std::string& keys) {
    const std::string folder = testing::TempDir();
    std::ofstream(folder + "/m.json") << json;
    const auto scene = parse_scene(
        "[camera]\neye = [0.5, -1, 1]\ntarget = [0.5, 0.5, 0]\n[[object]]\n[object.mesh]\n"
        "kind = \"grid\"\n[object.map]\nfile = \"m.json\"\nrange = 1\n" +
            keys + "\n[object.adaptive]\nheight_threshold_lsb = 1\n",
        "s.toml", folder);
    if (!scene.ok()) return scene.error();
    return load_map(scene->objects[0], {});
}

TEST(Voids, ThroughAScene) {
    const std::string grid = R"({"width": 3, "height": 1, "values": [0, -32768, 100]})";
    const auto plain = scene_map(grid, "");
    ASSERT_TRUE(plain.ok()) << plain.error().message();
    EXPECT_EQ(plain->texels[1], 0);
    EXPECT_EQ(plain->elevation_low_m, -32768);
    const auto marked = scene_map(grid, "void_value = -32768");
    ASSERT_TRUE(marked.ok()) << marked.error().message();
    EXPECT_EQ(marked->texels, (std::vector<std::uint16_t>{0, 32768, 65535}));
    EXPECT_EQ(marked->filled_texels, 1u);
    EXPECT_EQ(marked->elevation_low_m, 0);
    const std::string hole = R"({"width": 3, "height": 1, "values": [0, null, 100]})";
    const auto refused = scene_map(hole, "");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message().find("m.json: texel (1, 0) is not finite"),
              std::string::npos);
    EXPECT_NE(refused.error().message().find("named at s.toml:8:8"), std::string::npos);
    const auto filled = scene_map(hole, "fill_voids = true");
    ASSERT_TRUE(filled.ok()) << filled.error().message();
    EXPECT_EQ(filled->texels, marked->texels);
    EXPECT_FALSE(scene_map(R"({"width": 1, "height": 1, "values": [null]})", "fill_voids = true"));
}

TEST(BadMaps, OneTexelAllEqualAndAllHighest) {
    const auto one = scene_map(R"({"width": 1, "height": 1, "values": [42]})", "");
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(one->texels, std::vector<std::uint16_t>{0});  // no range: the low end
    const auto equal = scene_map(R"({"width": 2, "height": 2, "values": [7, 7, 7, 7]})", "");
    ASSERT_TRUE(equal.ok());
    EXPECT_EQ(equal->texels, std::vector<std::uint16_t>(4, 0));
    const auto highest = scene_map(R"({"width": 2, "height": 1, "values": [65535, 65535]})",
                                   "sample_range = [0, 65535]");
    ASSERT_TRUE(highest.ok());
    EXPECT_EQ(highest->texels, std::vector<std::uint16_t>(2, 65535));
}

}  // namespace
}  // namespace repousse::host
