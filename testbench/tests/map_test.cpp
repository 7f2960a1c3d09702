// Height maps: the procedural ones, quantising, cutting, normals and the summed-area table.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/map/height_map.h"
#include "testbench/host/map/normal_map.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/map/summed_area_table.h"

namespace repousse::host {
namespace {

std::uint64_t fnv1a(const HeightMap& map) {
    std::uint64_t hash = 1469598103934665603ull;
    for (const std::uint16_t h : map.texels) {
        for (const int byte : {h & 0xFF, h >> 8}) {
            hash = (hash ^ static_cast<std::uint64_t>(byte)) * 1099511628211ull;
        }
    }
    return hash;
}

TEST(Procedural, DonutFollowsItsFormula) {
    const HeightMap map = make_donut_map(256, 256);
    EXPECT_EQ(map.range_high, 0.12);
    EXPECT_EQ(map.at(0, 0), 0);
    EXPECT_EQ(map.at(128, 128), 0);
    // On the crest, half a texel from rho = 0 at most.
    EXPECT_GT(map.at(204, 128), 65400);
    for (int y = 0; y < 256; y += 7) {
        for (int x = 0; x < 256; x += 5) {
            EXPECT_EQ(map.at(x, y), map.at(255 - x, y));
            EXPECT_EQ(map.at(x, y), map.at(y, x));
            const double rho = std::hypot((x + .5) / 256 - .5, (y + .5) / 256 - .5) - .3;
            const double d = std::sqrt(std::max(0.0, .0144 - rho * rho));
            EXPECT_NEAR(map.at(x, y), d / .12 * 65535, 0.5 + 1e-6);
        }
    }
}

TEST(Procedural, ConstantRampAndChecker) {
    EXPECT_EQ(make_constant_map(4, 3, 65535).texels, std::vector<std::uint16_t>(12, 65535));
    const HeightMap ramp = make_ramp_map(8, 4, 7, 100, 1000);
    EXPECT_EQ(ramp.at(0, 0), 7);
    EXPECT_EQ(ramp.at(7, 3), 7 + 700 + 3000);
    EXPECT_EQ(make_ramp_map(4, 1, 65000, 400, 0).at(3, 0), 65535);  // saturates
    EXPECT_EQ(make_ramp_map(4, 1, 10, -10, 0).at(3, 0), 0);
    const HeightMap checker = make_checker_map(8, 8, 2, 5, 9);
    EXPECT_EQ(checker.at(1, 1), 5);
    EXPECT_EQ(checker.at(2, 1), 9);
    EXPECT_EQ(checker.at(2, 2), 5);
}

TEST(Procedural, FbmIsTheSameOnEveryMachineAndFillsTheRange) {
    FbmSettings settings;
    settings.seed = 7;
    const HeightMap map = make_fbm_map(96, 64, settings);
    EXPECT_EQ(*std::min_element(map.texels.begin(), map.texels.end()), 0);
    EXPECT_EQ(*std::max_element(map.texels.begin(), map.texels.end()), 65535);
    EXPECT_EQ(fnv1a(map), 16985376017344993916ull);
    settings.seed = 8;
    EXPECT_NE(fnv1a(make_fbm_map(96, 64, settings)), fnv1a(map));
}

TEST(Procedural, FbmIsContinuousAcrossItsSeamWhenItWraps) {
    FbmSettings settings;
    settings.octaves = 3;
    auto worst = [&](bool wrap) {
        settings.wrap = wrap;
        const HeightMap map = make_fbm_map(256, 256, settings);
        int inside = 0;
        int seam = 0;
        for (int y = 0; y < 256; ++y) {
            inside = std::max(inside, std::abs(map.at(100, y) - map.at(101, y)));
            seam = std::max(seam, std::abs(map.at(255, y) - map.at(0, y)));
        }
        return std::make_pair(seam, inside);
    };
    EXPECT_LT(worst(true).first, 2 * worst(true).second);
    EXPECT_GT(worst(false).first, 4 * worst(false).second);  // and not otherwise
}

TEST(HeightMap, QuantisesAsTheReferenceDoes) {
    ElevationGrid grid{4, 1, {236, 1076, 656, 237}, 236, 1076, true};
    const HeightMap map = quantise(grid);
    EXPECT_EQ(map.at(0, 0), 0);
    EXPECT_EQ(map.at(1, 0), 65535);
    EXPECT_EQ(map.at(2, 0), 32768);  // 32767.5 rounds up
    EXPECT_EQ(map.at(3, 0), static_cast<int>(std::floor(65535.0 / 840 + .5)));
    EXPECT_EQ(map.elevation_low_m, 236.0);
    EXPECT_EQ(map.elevation_high_m, 1076.0);
    grid.samples = {5, 5, 5, 5};
    measure_range(grid);
    EXPECT_EQ(quantise(grid).texels, std::vector<std::uint16_t>(4, 0));
    ElevationGrid words{65536 / 256, 256, {}, 0, 65535, false};
    for (int i = 0; i < 65536; ++i) words.samples.push_back(i);
    const HeightMap same = quantise(words);
    for (int i = 0; i < 65536; ++i) ASSERT_EQ(same.texels[static_cast<std::size_t>(i)], i);
}

TEST(HeightMap, CropsAndFlips) {
    HeightMap map = make_ramp_map(8, 6, 0, 1, 100);
    const auto part = crop(map, 2, 1, 3, 4);
    ASSERT_TRUE(part.ok());
    EXPECT_EQ(part->width, 3);
    EXPECT_EQ(part->at(0, 0), 102);
    EXPECT_EQ(part->at(2, 3), 404);
    for (const auto& [x, y, w, h] : {std::array{6, 0, 3, 1},
                                     {0, 5, 1, 2},
                                     {-1, 0, 1, 1},
                                     {0, 0, 0, 1},
                                     {2000000000, 0, 2000000000, 1}}) {
        EXPECT_FALSE(crop(map, x, y, w, h).ok());
    }
    flip_rows(map);
    EXPECT_EQ(map.at(3, 0), 503);
    EXPECT_EQ(map.at(3, 5), 3);
}

TEST(HeightMap, ResamplesByExactArea) {
    const HeightMap four = make_ramp_map(4, 2, 0, 10, 1);
    const HeightMap two = resample(four, 2, 1);
    EXPECT_EQ(two.at(0, 0), 6);  // (0 + 10 + 1 + 11) / 4 = 5.5, up
    EXPECT_EQ(two.at(1, 0), 26);
    EXPECT_EQ(resample(four, 4, 2).texels, four.texels);
    // 3 -> 2: each new texel covers one and a half old ones.
    HeightMap three = make_constant_map(3, 1, 0);
    three.texels = {300, 600, 1500};
    EXPECT_EQ(resample(three, 2, 1).texels, (std::vector<std::uint16_t>{400, 1200}));
    const HeightMap full = make_constant_map(403, 344, 65535);
    EXPECT_EQ(resample(full, 64, 64).texels, std::vector<std::uint16_t>(4096, 65535));
    EXPECT_EQ(resample(make_constant_map(3, 3, 77), 7, 5).texels,
              std::vector<std::uint16_t>(35, 77));
}

TEST(NormalMap, CentralInsideOneSidedAtBordersWrappedWhenPeriodic) {
    HeightMap map = make_ramp_map(8, 8, 0, 1000, 0);
    map.range_high = 65.535;  // an LSB is 0.001 world units: slope 1 per texel of width 1
    std::vector<glm::dvec3> normals = normal_map(map, 1.0, 1.0);
    const double half = std::sqrt(0.5);
    for (const glm::dvec3& n : normals) {
        EXPECT_NEAR(n.x, -half, 1e-12);
        EXPECT_EQ(n.y, 0.0);
        EXPECT_NEAR(n.z, half, 1e-12);
    }
    map.wrap = true;
    normals = normal_map(map, 1.0, 1.0);
    EXPECT_NEAR(normals[0].x / normals[0].z, 3.0, 1e-12);  // (7 - 1) / 2 downhill
    normals = normal_map(map, 0.5, 1.0);
    EXPECT_NEAR(normals[1].x / normals[1].z, -2.0, 1e-12);
    const HeightMap dot = make_constant_map(1, 1, 9);
    EXPECT_EQ(normal_map(dot, 1.0, 1.0)[0], glm::dvec3(0.0, 0.0, 1.0));
}

std::uint64_t box_sum(const std::vector<std::uint64_t>& table, int width, int x0, int y0, int x1,
                      int y1, std::uint64_t mask) {
    auto at = [&](int x, int y) { return table[static_cast<std::size_t>(y * (width + 1) + x)]; };
    return (at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0)) & mask;
}

TEST(SummedAreaTable, BoxSumsAreExactModularAndOneBitFewerFails) {
    const int side = 512;
    EXPECT_EQ(summed_area_bits(512, 512), 32);
    EXPECT_EQ(summed_area_bits(4096, 4096), 38);
    const HeightMap map = make_constant_map(side, side, 65535);
    const auto full = summed_area_table(map, 64);
    EXPECT_EQ(full.size(), 513u * 513u);
    EXPECT_EQ(full.back(), 65535ull * 512 * 512);
    int wrong[2] = {0, 0};
    std::mt19937 random(5);
    for (const int bits : {32, 31}) {
        const auto table = summed_area_table(map, bits);
        const std::uint64_t mask = (1ull << bits) - 1;
        for (int i = 0; i < 20000; ++i) {
            const int w = i == 0 ? 256 : static_cast<int>(random() % 257);
            const int h = i == 0 ? 256 : static_cast<int>(random() % 257);
            const int x = static_cast<int>(random() % (513u - static_cast<unsigned>(w)));
            const int y = static_cast<int>(random() % (513u - static_cast<unsigned>(h)));
            const std::uint64_t exact =
                65535ull * static_cast<unsigned>(w) * static_cast<unsigned>(h);
            wrong[32 - bits] += box_sum(table, side, x, y, x + w, y + h, mask) != exact;
        }
    }
    EXPECT_EQ(wrong[0], 0);
    EXPECT_GT(wrong[1], 0);
}

TEST(SummedAreaTable, MatchesDirectSums) {
    FbmSettings settings;
    const HeightMap map = make_fbm_map(37, 29, settings);
    const auto table = summed_area_table(map, 44);
    std::mt19937 random(3);
    for (int i = 0; i < 500; ++i) {
        int x0 = static_cast<int>(random() % 38), x1 = static_cast<int>(random() % 38);
        int y0 = static_cast<int>(random() % 30), y1 = static_cast<int>(random() % 30);
        if (x0 > x1) std::swap(x0, x1);
        if (y0 > y1) std::swap(y0, y1);
        std::uint64_t direct = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) direct += map.at(x, y);
        }
        EXPECT_EQ(box_sum(table, 37, x0, y0, x1, y1, ~0ull), direct);
    }
}

}  // namespace
}  // namespace repousse::host
