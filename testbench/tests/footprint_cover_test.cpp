// What displace reads of filter levels covers the footprint, each texel once and row by row.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "datapath/texel_port.h"
#include "datapath/units/displace.h"
#include "datapath/units/footprint.h"
#include "testbench/host/map/level_table.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;

constexpr uint64_t kSeed = 47;

// A map with its levels, read through both units, against the highest texel under the footprint.
// Clamped or periodic, and how many levels finer.
class Cover : public testing::TestWithParam<std::tuple<bool, int>>, TexelPort {
protected:
    Cover() { displace_.attach(this); }
    void read(uint32_t place) override { places_.push_back(place); }

    const Profile profile_ =
        test::profile_with("default", {{"displacement", "s17.8 SC_RND SC_SAT"}});
    const int frac_ = profile_.uv.frac;
    host::HeightMap map_;
    host::LevelTable table_;
    MapView<Fixed> view_;
    Displace<Fixed> displace_{profile_};
    std::vector<uint32_t> places_;  // read for one height

    void random_map(Dice& dice) {
        map_.width = int(dice.integer(1, dice.flip() ? 9 : 70));
        map_.height = int(dice.integer(1, dice.flip() ? 9 : 70));
        map_.wrap = std::get<0>(GetParam());
        map_.texels.resize(std::size_t(map_.width) * std::size_t(map_.height));
        for (auto& h : map_.texels) h = uint16_t(dice.integer(0, 65535));
        table_ = host::make_level_table(map_, host::LevelFilter::BoxMaximum);
        view_.width = map_.width;
        view_.height = map_.height;
        view_.wrap = map_.wrap;
        view_.filter = HeightFilter::Maximum;
        view_.finer = std::get<1>(GetParam());
        view_.last_level = table_.last_level;
        view_.has_minima = table_.has_minima;
        view_.heights = table_.heights;
        view_.scale_mantissa = 1;  // D is the height itself
        displace_.configure(view_);
        EXPECT_EQ(height_table_size(view_), table_.heights.size());
    }
    int texel(int64_t x, int64_t y) const {
        const auto inside = [this](int64_t i, int size) {
            return int(map_.wrap ? (i % size + size) % size : std::clamp<int64_t>(i, 0, size - 1));
        };
        return map_.at(inside(x, map_.width), inside(y, map_.height));
    }
    int height(Uv u, const LevelRead& read) {
        places_.clear();
        return displace_.displacement(u, read) >> profile_.displacement.frac;
    }
};

TEST_P(Cover, NoTexelUnderTheFootprintIsHigherThanTheMaximum) {
    Dice dice(kSeed + 2);
    Footprint<Fixed> unit(profile_);
    uint64_t footprints = 0, texels = 0, beside = 0;
    std::size_t most_reads = 0;
    for (int m = 0; m < 400; ++m) {
        random_map(dice);
        unit.configure({map_.width, map_.height, table_.last_level, view_.finer, {}});
        for (int i = 0; i < 100; ++i) {
            FootprintIn<Fixed> in;
            in.kind = NameKind::Interior;
            in.c = 1 << profile_.inverse_w.frac;
            in.u = {int32_t(dice.integer(0, int64_t{map_.width} << frac_)),
                    int32_t(dice.integer(0, int64_t{map_.height} << frac_))};
            const double size = std::exp2(dice.real(-2, 7));
            for (auto& step : in.steps) {
                step.u = test::to_raw(size * dice.real(-1, 1), profile_.sweep_data);
                step.v = test::to_raw(size * dice.real(-1, 1), profile_.sweep_data);
            }
            LevelRead read = unit(in);
            const int highest = height(in.u, read);
            read.back = true;
            const int lowest = height(in.u, read);
            const int along = (1 << view_.finer) + 1;
            ASSERT_LE(places_.size(), std::size_t(along * along));
            most_reads = std::max(most_reads, places_.size());
            if (!map_.wrap) {  // row by row
                ASSERT_TRUE(std::is_sorted(places_.begin(), places_.end()));
            }
            std::sort(places_.begin(), places_.end());
            ASSERT_EQ(std::adjacent_find(places_.begin(), places_.end()), places_.end())
                << "a texel is read twice";
            // Every texel under the rectangle, which holds the parallelogram.
            const auto first = [&](int32_t u, int32_t reach) { return (u - reach) >> frac_; };
            const auto last = [&](int32_t u, int32_t reach) { return (u + reach) >> frac_; };
            for (int y = first(in.u.y, read.reach_y); y <= last(in.u.y, read.reach_y); ++y) {
                for (int x = first(in.u.x, read.reach_x); x <= last(in.u.x, read.reach_x); ++x) {
                    ASSERT_LE(texel(x, y), highest);
                    ASSERT_GE(texel(x, y), lowest);
                    ++texels;
                }
            }
            // The level's texels at the parallelogram's own corners alone, as the paper has them.
            int of_corners = 0, inside = 0;
            const double ax = std::ldexp(in.steps[0].u, -17), ay = std::ldexp(in.steps[0].v, -17);
            const double bx = std::ldexp(in.steps[1].u, -17), by = std::ldexp(in.steps[1].v, -17);
            const double u = std::ldexp(in.u.x, -frac_), v = std::ldexp(in.u.y, -frac_);
            for (int k = 0; k < 4; ++k) {
                const double s = k % 2 == 0 ? -1 : 1, t = k < 2 ? -1 : 1;
                Uv at{int32_t(std::ldexp(u + s * ax + t * bx, frac_)),
                      int32_t(std::ldexp(v + s * ay + t * by, frac_))};
                const auto within = [&](int32_t x, int side) {
                    const int32_t whole = side << frac_;
                    return map_.wrap ? (x % whole + whole) % whole : x;
                };
                at = {within(at.x, map_.width), within(at.y, map_.height)};
                of_corners = std::max(of_corners, height(at, {0, 0, read.level, false}));
            }
            for (int k = 0; k < 64; ++k) {
                const double s = dice.real(-1, 1), t = dice.real(-1, 1);
                inside = std::max(inside, texel(int64_t(std::floor(u + s * ax + t * bx)),
                                                int64_t(std::floor(v + s * ay + t * by))));
            }
            beside += inside > of_corners;
            ++footprints;
        }
    }
    std::printf(
        "%s, %d finer: %llu footprints, %llu texels under them, none missed, at most %zu reads; "
        "the corners of the parallelogram alone miss a higher texel in %.1f %% of them\n",
        map_.wrap ? "periodic" : "clamped", view_.finer, (unsigned long long)footprints,
        (unsigned long long)texels, most_reads, 100.0 * double(beside) / double(footprints));
    EXPECT_GT(beside, 0u);
    EXPECT_EQ(most_reads, view_.finer == 0 ? 4u : view_.finer == 1 ? 9u : 25u);
}

// Everything at the top, and an average of it.
TEST_P(Cover, FlatMapsStayFlat) {
    Dice dice(kSeed + 3);
    for (const int h : {0, 1, 65535}) {
        for (const auto kind : {host::LevelFilter::Average, host::LevelFilter::BoxMaximum,
                                host::LevelFilter::Variational}) {
            random_map(dice);
            map_.texels.assign(map_.texels.size(), uint16_t(h));
            table_ = host::make_level_table(map_, kind);
            view_.heights = table_.heights;
            view_.has_minima = table_.has_minima;
            for (const auto filter : {HeightFilter::Maximum, HeightFilter::Average}) {
                view_.filter = filter;
                displace_.configure(view_);
                for (int level = 0; level <= table_.last_level; ++level) {
                    const LevelRead read{(1 << frac_ << level) / 2 % (map_.width << frac_), 0,
                                         uint8_t(level), dice.flip()};
                    EXPECT_EQ(height({5, 5}, read), h);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Borders, Cover,
                         testing::Combine(testing::Bool(), testing::Values(0, 1, 2)));

TEST(SelectedHeights, AverageCountsEachCornerOnce) {
    const Profile profile = test::profile_with("default", {});
    host::HeightMap map;
    map.width = map.height = 2;
    map.texels = {100, 200, 400, 900};
    host::LevelTable table = host::make_level_table(map, host::LevelFilter::Average);
    MapView<Real> view;
    view.width = view.height = 2;
    view.heights = table.heights;
    view.last_level = table.last_level;
    view.scale_mantissa = 1;
    view.filter = HeightFilter::Average;
    Displace<Real> unit(profile);
    unit.configure(view);
    const int32_t one = 1 << profile.uv.frac;
    EXPECT_EQ(unit.displacement({one, one}, {one / 2, one / 2, 0, false}), 400);
    EXPECT_EQ(unit.displacement({one, one / 2}, {one / 2, 0, 0, false}), 150);
    EXPECT_EQ(unit.displacement({one / 2, one}, {0, one / 2, 0, false}), 250);
    EXPECT_EQ(unit.displacement({one, one}, {0, 0, 1, false}), 400);
    EXPECT_EQ(unit.counters().reads, 4u + 2 + 2 + 1);
    view.filter = HeightFilter::Maximum;
    unit.configure(view);
    EXPECT_EQ(unit.displacement({one, one}, {one / 2, one / 2, 0, false}), 900);
    EXPECT_EQ(unit.displacement({one, one}, {one / 2, one / 2, 0, true}), 100);
    EXPECT_EQ(unit.displacement({one, one / 2}, {one / 2, 0, 0, true}), 100);
}

struct Places : TexelPort {
    void read(uint32_t place) override { all.push_back(place); }
    std::vector<uint32_t> all;
};

// A summit beside the middle of five by five texels, under none of a footprint's corners.
TEST(SelectedHeights, FinerReadsAllTexelsUnderTheFootprint) {
    const Profile profile = test::profile_with("default", {});
    std::vector<uint16_t> heights(25, 7);
    heights[1 * 5 + 3] = 900;
    heights[2 * 5 + 2] = 400;
    MapView<Real> view;
    view.width = view.height = 5;
    view.heights = heights;
    view.scale_mantissa = 1;
    view.filter = HeightFilter::Maximum;
    Displace<Real> unit(profile);
    Places places;
    unit.attach(&places);
    const int32_t one = 1 << profile.uv.frac;
    const Uv middle{2 * one + one / 2, 2 * one + one / 2};
    for (const auto& [finer, height] : {std::pair{0, 7}, std::pair{1, 400}, std::pair{2, 900}}) {
        view.finer = finer;
        unit.configure(view);
        places.all.clear();
        EXPECT_EQ(unit.displacement(middle, {2 * one, 2 * one, 0, false}), height);
        std::vector<uint32_t> expected;
        const uint32_t step = 4u >> finer;
        for (uint32_t y = 0; y < 5; y += step) {
            for (uint32_t x = 0; x < 5; x += step) expected.push_back(5 * y + x);
        }
        EXPECT_EQ(places.all, expected) << finer;
    }
    // Two columns of one row: between its ends, each half a texel further, there is no third.
    places.all.clear();
    EXPECT_EQ(unit.displacement({2 * one, one / 2}, {one / 2, 0, 0, true}), 7);
    EXPECT_EQ(places.all, (std::vector<uint32_t>{1, 2}));
}

}  // namespace
}  // namespace repousse
