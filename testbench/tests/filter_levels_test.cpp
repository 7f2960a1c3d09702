// Filter levels: block means and maxima, the level's surface and volume against their definitions,
// and what the variational descent promises on maps of every size and on bad ones.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/procedural_map.h"

namespace repousse::host {
namespace {

HeightMap noise(int width, int height, std::uint64_t seed, bool wrap) {
    FbmSettings settings;
    settings.seed = seed;
    settings.wrap = wrap;
    HeightMap map = make_fbm_map(width, height, settings);
    map.wrap = wrap;
    return map;
}

/// The volume as it is defined: every texel centre, its four vertices found by floor, in double.
double volume_by_definition(const HeightMap& map, const HeightMap& level, int k) {
    const auto vertex = [&](int i, int j) {
        const auto place = [&](int v, int size) {
            return map.wrap ? (v % size + size) % size : std::clamp(v, 0, size - 1);
        };
        return static_cast<double>(level.at(place(i, level.width), place(j, level.height)));
    };
    double volume = 0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const double u = std::ldexp(x + 0.5, -k) - 0.5;
            const double v = std::ldexp(y + 0.5, -k) - 0.5;
            const int i = static_cast<int>(std::floor(u));
            const int j = static_cast<int>(std::floor(v));
            const double s = u - i;
            const double t = v - j;
            volume += std::abs((1 - t) * ((1 - s) * vertex(i, j) + s * vertex(i + 1, j)) +
                               t * ((1 - s) * vertex(i, j + 1) + s * vertex(i + 1, j + 1)) -
                               map.at(x, y));
        }
    }
    return volume;
}

TEST(LevelSize, IsTheHalfRoundedUpAgainAndAgain) {
    for (const int size : {1, 2, 3, 5, 64, 65, 87, 403, 2161, 16384}) {
        int half = size;
        for (int level = 0; level <= kMaxFilterLevel; ++level) {
            EXPECT_EQ(level_size(size, level), half) << size << " level " << level;
            half = (half + 1) / 2;
        }
    }
    EXPECT_EQ(level_count(1, 1), 0);
    EXPECT_EQ(level_count(2, 1), 1);
    EXPECT_EQ(level_count(403, 344), 9);
    EXPECT_EQ(level_count(kMaxMapSide, 1), kMaxFilterLevel);
}

TEST(LevelAxis, VerticesStandAtTheirBlocksCentres) {
    const LevelAxis axis = level_axis(16, 2, false);  // vertices at 2, 6, 10, 14
    ASSERT_EQ(axis.vertices, 4);
    ASSERT_EQ(axis.cells.size(), 5u);
    EXPECT_EQ(axis.cells[0].end, 2);
    EXPECT_EQ(axis.cells[0].upper, 0);
    EXPECT_EQ(axis.fraction[1], 0.0);
    EXPECT_EQ(axis.fraction[2], 0.125);  // centre 2.5, half a texel after vertex 0
    EXPECT_EQ(axis.fraction[5], 0.875);
    EXPECT_EQ(axis.cells[4].begin, 14);
    EXPECT_EQ(axis.cells[4].lower, 3);
    EXPECT_EQ(axis.cells[4].upper, 3);
    const LevelAxis round = level_axis(16, 2, true);
    EXPECT_EQ(round.cells[0].lower, 3);
    EXPECT_EQ(round.cells[0].upper, 0);
    EXPECT_EQ(round.fraction[0], 0.625);
    EXPECT_EQ(round.cells[4].upper, 0);
    EXPECT_EQ(level_axis(5, 3, true).cells.size(), 1u);  // one vertex, level all round
}

TEST(Blocks, MeanAndMaximumOfTheTexelsInsideTheMap) {
    HeightMap map = make_ramp_map(5, 3, 0, 10, 100);
    const HeightMap mean = average_level(map, 1);
    ASSERT_EQ(mean.width, 3);
    ASSERT_EQ(mean.height, 2);
    EXPECT_EQ(mean.texels, (std::vector<std::uint16_t>{55, 75, 90, 205, 225, 240}));
    EXPECT_EQ(maximum_level(map, 1).texels,
              (std::vector<std::uint16_t>{110, 130, 140, 210, 230, 240}));
    EXPECT_EQ(average_level(map, 3).texels, std::vector<std::uint16_t>{120});
    map.texels.assign(15, 65535);
    EXPECT_EQ(average_level(map, 2).texels, (std::vector<std::uint16_t>{65535, 65535}));
}

TEST(Blocks, LevelsKeepTheMapsDescription) {
    HeightMap map = noise(33, 20, 1, true);
    map.range_low = -2;
    map.range_high = 7;
    map.has_elevation = true;
    map.elevation_low_m = 5;
    map.elevation_high_m = 9;
    const auto levels = filter_levels(map, LevelFilter::Average);
    ASSERT_EQ(levels.size(), 6u);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const HeightMap& level = levels[k];
        EXPECT_EQ(level.width, level_size(33, static_cast<int>(k) + 1));
        EXPECT_EQ(level.height, level_size(20, static_cast<int>(k) + 1));
        EXPECT_EQ(level.texels.size(), static_cast<std::size_t>(level.width * level.height));
        EXPECT_TRUE(level.wrap && level.has_elevation);
        EXPECT_EQ(level.range_low, -2);
        EXPECT_EQ(level.range_high, 7);
        EXPECT_EQ(level.elevation_low_m, 5);
        EXPECT_EQ(level.elevation_high_m, 9);
    }
    EXPECT_EQ(filter_level(map, 0, LevelFilter::Variational).texels, map.texels);
}

class AnyMap : public testing::TestWithParam<std::tuple<int, int, bool>> {
protected:
    HeightMap map() const {
        const auto [width, height, wrap] = GetParam();
        return noise(width, height, 7, wrap);
    }
};

TEST_P(AnyMap, VolumeIsAsDefined) {
    const HeightMap full = map();
    for (int k = 0; k <= level_count(full.width, full.height); ++k) {
        for (const LevelFilter kind : {LevelFilter::Average, LevelFilter::BoxMaximum}) {
            const HeightMap level = filter_level(full, k, kind);
            const double volume = difference_volume(full, level, k);
            // Both sums are exact: weights are dyadic and the maps small.
            EXPECT_EQ(volume, volume_by_definition(full, level, k)) << "level " << k;
            EXPECT_TRUE(k > 0 || volume == 0.0);
        }
    }
}

TEST_P(AnyMap, TheDescentNeverRises) {
    const HeightMap full = map();
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

TEST_P(AnyMap, HatSumsAreTheTransposeOfTheSurface) {
    const HeightMap full = map();
    const HeightMap other = noise(full.width, full.height, 8, full.wrap);
    for (int k = 0; k <= level_count(full.width, full.height); ++k) {
        const LevelGrid grid(full, k);
        const HeightMap level = average_level(full, k);
        const std::vector<double> heights(level.texels.begin(), level.texels.end());
        const std::vector<double> values(other.texels.begin(), other.texels.end());
        const std::vector<double> surface = surface_of(grid, heights);
        const std::vector<double> sums = hat_sums(grid, values);
        double left = 0;
        double right = 0;
        for (std::size_t i = 0; i < surface.size(); ++i) left += surface[i] * values[i];
        for (std::size_t i = 0; i < sums.size(); ++i) right += sums[i] * heights[i];
        EXPECT_NEAR(left, right, 1e-12 * (1 + left)) << "level " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, AnyMap,
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
