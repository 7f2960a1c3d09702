// Filter levels: block means and maxima, the level's surface and volume against their definitions,
// on maps of every size.
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/tests/support/level_volume.h"

namespace repousse::host {
namespace {

using test::noise;
using test::volume_by_definition;

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

}  // namespace
}  // namespace repousse::host
