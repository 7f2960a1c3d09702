// What the variational descent promises, on maps of every size and on bad ones.
#include <algorithm>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/map/variational_level.h"
#include "testbench/tests/support/level_volume.h"

namespace repousse::host {
namespace {

using test::noise;
using test::volume_by_definition;

class Descent : public testing::TestWithParam<std::tuple<int, int, bool>> {};

TEST_P(Descent, NeverRises) {
    const auto [width, height, wrap] = GetParam();
    const HeightMap full = noise(width, height, 7, wrap);
    for (int k = 1; k <= level_count(full.width, full.height); ++k) {
        const VariationalLevel fit = variational_level(full, k);
        const HeightMap average = average_level(full, k);
        ASSERT_FALSE(fit.volumes.empty());
        EXPECT_EQ(fit.volumes.front(), difference_volume(full, average, k));
        EXPECT_TRUE(std::is_sorted(fit.volumes.rbegin(), fit.volumes.rend())) << "level " << k;
        EXPECT_EQ(fit.volume, volume_by_definition(full, fit.map, k));
        EXPECT_LE(fit.volume, fit.volumes.front());
        // Rounding to 16 bits moves no texel of the surface by more than half an LSB.
        EXPECT_LE(fit.volume, fit.volumes.back() + 0.5 * static_cast<double>(full.texels.size()));
        EXPECT_EQ(fit.map.width, average.width);
        EXPECT_EQ(fit.map.texels.size(), average.texels.size());
        EXPECT_EQ(fit.map.texels, variational_level(full, k).map.texels) << "not repeatable";
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Descent,
                         testing::Combine(testing::Values(1, 2, 7, 32), testing::Values(1, 5, 33),
                                          testing::Bool()));

TEST(Variational, AConstantMapStaysAndHasNoVolume) {
    for (const int height : {0, 12345, 65535}) {
        for (const bool wrap : {false, true}) {
            HeightMap map = make_constant_map(13, 9, static_cast<std::uint16_t>(height));
            map.wrap = wrap;
            for (int k = 1; k <= 4; ++k) {
                const VariationalLevel fit = variational_level(map, k);
                EXPECT_EQ(fit.volumes, std::vector<double>{0.0});
                EXPECT_EQ(fit.volume, 0.0);
                for (const std::uint16_t h : fit.map.texels) EXPECT_EQ(h, height);
                EXPECT_EQ(maximum_level(map, k).texels, fit.map.texels);
            }
        }
    }
}

TEST(Variational, HeightsStayWithin16BitsBesideBothEnds) {
    const HeightMap checker = make_checker_map(64, 64, 5, 0, 65535);
    for (int k = 1; k <= 6; ++k) {
        const VariationalLevel fit = variational_level(checker, k);
        EXPECT_LE(fit.volume, fit.volumes.front()) << k;
        EXPECT_EQ(fit.volume, volume_by_definition(checker, fit.map, k));
    }
}

TEST(Variational, ALinearRampIsMetInsideTheBorder) {
    const HeightMap ramp = make_ramp_map(64, 48, 100, 300, 500);
    for (int k = 1; k <= 3; ++k) {
        const std::vector<double> surface = [&] {
            const HeightMap level = variational_level(ramp, k).map;
            return surface_of(LevelGrid(ramp, k), {level.texels.begin(), level.texels.end()});
        }();
        const int margin = 2 << k;  // the border's level rim pulls at the vertices beside it
        for (int y = margin; y < ramp.height - margin; ++y) {
            for (int x = margin; x < ramp.width - margin; ++x) {
                EXPECT_NEAR(surface[static_cast<std::size_t>(y * ramp.width + x)], ramp.at(x, y), 2)
                    << k << ": " << x << ", " << y;
            }
        }
    }
}

TEST(Variational, AStrokeOfOneTexelIsNotWidened) {
    // The best level under a single spike is the plain without it: the mean would keep 1/16.
    HeightMap map = make_constant_map(32, 32, 1000);
    map.texels[16 * 32 + 16] = 60000;
    const VariationalLevel fit = variational_level(map, 2);
    for (const std::uint16_t h : fit.map.texels) EXPECT_NEAR(h, 1000, 50);
    EXPECT_LE(fit.volume, 59000.0 * 1.01);
    EXPECT_EQ(maximum_level(map, 2).at(4, 4), 60000);
}

/// The least volume there is, by trying: one vertex of a tiny level at a time over every height at
/// which the volume has a kink, again and again from many starts.
double least_volume(const HeightMap& map, int k, std::uint64_t seed) {
    const LevelGrid grid(map, k);
    double best = 1e300;
    for (int start = 0; start < 40; ++start) {
        std::vector<double> heights(grid.vertices());
        for (double& h : heights) {
            seed = seed * 6364136223846793005ull + 1442695040888963407ull;
            h = static_cast<double>(seed >> 48);
        }
        double volume = difference_volume(map, grid, heights);
        for (bool fell = true; fell;) {
            fell = false;
            for (std::size_t i = 0; i < heights.size(); ++i) {
                const double old = heights[i];
                double at = old;
                std::vector<double> hat(heights.size());
                hat[i] = 1;
                const std::vector<double> weight = surface_of(grid, hat);
                const std::vector<double> surface = surface_of(grid, heights);
                for (std::size_t p = 0; p < weight.size(); ++p) {
                    if (weight[p] == 0) continue;
                    heights[i] = old + (map.texels[p] - surface[p]) / weight[p];
                    const double now = difference_volume(map, grid, heights);
                    if (now < volume - 1e-9) volume = now, at = heights[i], fell = true;
                }
                heights[i] = at;
            }
        }
        best = std::min(best, volume);
    }
    return best;
}

TEST(Variational, ComesNearTheLeastVolumeOfSmallMaps) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const HeightMap map = noise(9, 6, seed, seed % 2 == 0);
        const double least = least_volume(map, 2, seed);
        const VariationalLevel fit = variational_level(map, 2);
        EXPECT_LE(fit.volume, 1.03 * least) << seed;
        EXPECT_GE(fit.volume, least - 0.5 * 54) << seed;
    }
}

}  // namespace
}  // namespace repousse::host
