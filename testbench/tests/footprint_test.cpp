// footprint: half steps against long double, levels against their definition, the edge constraint
// at every kind of adder, and that the texels that displace reads cover the footprint.

#include "datapath/units/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "datapath/units/displace.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/host/map/level_table.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;

constexpr uint64_t kSeed = 47;

class FootprintUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
    Footprint<Fixed> unit_{profile_};
    Dice dice_{kSeed};

    void configure(int width, int height, int last_level) {
        unit_.configure({width, height, last_level, {}});
    }
    int32_t one() const { return 1 << profile_.uv.frac; }
    // A vertex of a map of this size, with steps of up to `texels` texels.
    FootprintIn<Fixed> vertex(NameKind kind, int width, int height, double texels) {
        FootprintIn<Fixed> in;
        in.kind = kind;
        in.u = {int32_t(dice_.integer(0, int64_t{width} * one())),
                int32_t(dice_.integer(0, int64_t{height} * one()))};
        const double c = std::exp(dice_.real(std::log(0.01), 0.0));
        in.c = test::to_raw(c, profile_.inverse_w);
        for (TexelStep<int32_t>& step : in.steps) {
            const double dc = c * dice_.real(-0.05, 0.05);
            const auto data = [&](int32_t u) {
                const double du = texels * dice_.real(-1, 1);
                return test::to_raw(du * c + std::ldexp(u, -profile_.uv.frac) * dc,
                                    profile_.sweep_data);
            };
            step = {data(in.u.x), data(in.u.y), test::to_raw(dc, profile_.inverse_w)};
        }
        return in;
    }
    // Half a step in texels, without rounding.
    long double half_step(int32_t step, int32_t u, int32_t step_c, int32_t c) const {
        const long double du = std::ldexp((long double)step, -profile_.sweep_data.frac);
        const long double dc = std::ldexp((long double)step_c, -profile_.inverse_w.frac);
        const long double w = std::ldexp((long double)c, -profile_.inverse_w.frac);
        return std::abs(du - std::ldexp((long double)u, -profile_.uv.frac) * dc) / w / 2;
    }
};

// Half an LSB of `uv` for the quotient, half an LSB of `sweep_data` divided by c for what is turned
// by the change of c, and the reciprocal's error.
TEST_P(FootprintUnit, HalfStepsAreWithinTheirRounding) {
    configure(400, 300, 9);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
        const auto in = vertex(NameKind::Interior, 400, 300, 20);
        const LevelRead read = unit_(in);
        const auto exact = [&](auto step, int32_t u) {
            return half_step(in.steps[0].*step, u, in.steps[0].c, in.c) +
                   half_step(in.steps[1].*step, u, in.steps[1].c, in.c);
        };
        const double w = std::ldexp(in.c, -profile_.inverse_w.frac);
        const auto check = [&](int32_t found, long double half) {
            const double bound = std::ldexp(1.0, -profile_.uv.frac) +
                                 0.5 * std::ldexp(1.0, -profile_.sweep_data.frac) / w +
                                 double(half) * std::ldexp(1.0, -profile_.reciprocal_bits);
            const double error = std::abs(std::ldexp(found, -profile_.uv.frac) - double(half));
            worst = std::max(worst, error / bound);
        };
        check(read.reach_x, exact(&TexelStep<int32_t>::u, in.u.x));
        check(read.reach_y, exact(&TexelStep<int32_t>::v, in.u.y));
    }
    EXPECT_LE(worst, 1.0);
    EXPECT_GT(worst, 0.5);
    EXPECT_EQ(unit_.counters().items, 200'000u);
}

TEST_P(FootprintUnit, LevelIsTheLeastWhoseTexelsAreNoSmaller) {
    configure(1024, 1024, 10);
    std::array<int, 15> seen{};
    for (int i = 0; i < 100'000; ++i) {
        const auto kind = dice_.flip() ? NameKind::Edge : NameKind::Interior;
        const LevelRead read = unit_(vertex(kind, 1024, 1024, std::exp2(dice_.real(-4, 11))));
        const int64_t side = 2 * int64_t{std::max(read.reach_x, read.reach_y)};
        int level = 0;
        while ((int64_t{one()} << level) < side) ++level;
        ASSERT_EQ(read.level, std::min(level, 10));
        ++seen[read.level];
        if (kind == NameKind::Edge) {
            ASSERT_EQ(read.reach_x, read.reach_y);
        }
    }
    for (int level = 0; level <= 10; ++level) EXPECT_GT(seen[std::size_t(level)], 100) << level;
}

TEST_P(FootprintUnit, CornersReadTheirTexelAlone) {
    configure(1024, 1024, 10);
    for (int i = 0; i < 1000; ++i) {
        const LevelRead read = unit_(vertex(NameKind::Corner, 1024, 1024, 500));
        ASSERT_EQ(read.reach_x, 0);
        ASSERT_EQ(read.reach_y, 0);
        ASSERT_EQ(read.level, 0);
    }
}

// Exact: products of 33 and 16 bits, their sign by long double's 64.
TEST_P(FootprintUnit, BackIsTheSignOfAnExactSum) {
    int close = 0;
    for (int i = 0; i < 100'000; ++i) {
        Vec3<int32_t> eye{dice_.raw(profile_.position), dice_.raw(profile_.position),
                          dice_.raw(profile_.position)};
        FootprintIn<Fixed> in;
        in.p = {dice_.raw(profile_.position), dice_.raw(profile_.position),
                dice_.raw(profile_.position)};
        in.n = {dice_.raw(profile_.normal), dice_.raw(profile_.normal), dice_.raw(profile_.normal)};
        if (i % 2 == 0) {  // nearly across the view
            in.n.z = 0;
            in.p = {eye.x / 2 + in.n.y, eye.y / 2 - in.n.x, 0};
            eye = {eye.x / 2, eye.y / 2, int32_t(dice_.integer(-1, 1))};
        }
        unit_.configure({1, 1, 0, eye});
        const long double along = ((long double)in.p.x - eye.x) * in.n.x +
                                  ((long double)in.p.y - eye.y) * in.n.y +
                                  ((long double)in.p.z - eye.z) * in.n.z;
        close += along == 0;
        ASSERT_EQ(unit_(in).back, along > 0);
    }
    EXPECT_GT(close, 1000);
}

TEST_P(FootprintUnit, HardCases) {
    const auto most = int32_t(profile_.sweep_data.max_raw());
    const auto least = int32_t(profile_.sweep_data.min_raw());
    const auto most_c = int32_t(profile_.inverse_w.max_raw());
    const auto least_c = int32_t(profile_.inverse_w.min_raw());
    for (const auto& [width, height, last] :
         {std::array{1, 1, 0}, std::array{3, 2, 2}, std::array{1000, 1, 10}}) {
        configure(width, height, last);
        for (const int32_t c : {least_c, -1, 0, 1, 2, most_c}) {  // w at its clamp and far beyond
            for (const int32_t step : {least, -1, 0, 1, most}) {
                for (const int32_t step_c : {least_c, 0, most_c}) {
                    FootprintIn<Fixed> in = vertex(NameKind::Interior, width, height, 1);
                    in.c = c;
                    in.steps = {{{step, -1 - step, step_c}, {step, step, step_c}}};
                    const LevelRead read = unit_(in);
                    ASSERT_GE(read.reach_x, 0);
                    ASSERT_LE(read.reach_x, (width - 1) * one());
                    ASSERT_LE(read.reach_y, (height - 1) * one());
                    ASSERT_LE(read.level, last);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Profile, FootprintUnit, testing::Values("default", "narrow"));

// Two triangles on one edge, their corners in any order and either way round: the same steps to
// the bit, whatever the adders.
TEST(EdgeConstraint, BothTrianglesHaveTheSameStepsAlongAnEdge) {
    Dice dice(kSeed + 1);
    std::size_t negative_ties = 0;
    for (const AdderKind adder : {AdderKind::Exact, AdderKind::Canonical, AdderKind::Plain}) {
        TriangleSetup setup({adder, adder == AdderKind::Exact ? 0 : 4, kPlainComponents, true});
        for (int n = 0; n < 20'000; ++n) {
            std::array<SweepCorner, 4> v;
            for (uint32_t i = 0; i < 4; ++i) {
                v[i].id = i;
                for (int32_t& s : v[i].slot) s = int32_t(dice.integer(-20, 20));
                for (int32_t& d : v[i].data) d = int32_t(dice.integer(-100'000, 100'000));
            }
            std::swap(v[0].id, v[std::size_t(dice.integer(0, 3))].id);
            const auto steps_between = [&](std::size_t third, bool turned, std::size_t first) {
                std::array<std::size_t, 3> order{0, 1, third};
                if (turned) std::swap(order[0], order[1]);
                std::rotate(order.begin(), order.begin() + first, order.end());
                SweepTriangle triangle;
                setup({v[order[0]], v[order[1]], v[order[2]]}, triangle);
                for (std::size_t e = 0; e < 3; ++e) {
                    if (order[e] + order[(e + 1) % 3] == 1) return triangle.texel_steps.edges[e];
                }
                return TexelStep<int32_t>{};
            };
            const auto a = steps_between(2, false, std::size_t(dice.integer(0, 2)));
            const auto b = steps_between(3, true, std::size_t(dice.integer(0, 2)));
            ASSERT_EQ(a.u, b.u);
            ASSERT_EQ(a.v, b.v);
            ASSERT_EQ(a.c, b.c);
            negative_ties += a.u < 0;
        }
    }
    EXPECT_GT(negative_ties, 1000u);
}

// A map with its levels, read through both units, against the highest texel under the footprint.
class Cover : public testing::TestWithParam<bool> {
protected:
    const Profile profile_ =
        test::profile_with("default", {{"displacement", "s17.8 SC_RND SC_SAT"}});
    const int frac_ = profile_.uv.frac;
    host::HeightMap map_;
    host::LevelTable table_;
    MapView<Fixed> view_;
    Displace<Fixed> displace_{profile_};

    void random_map(Dice& dice) {
        map_.width = int(dice.integer(1, dice.flip() ? 9 : 70));
        map_.height = int(dice.integer(1, dice.flip() ? 9 : 70));
        map_.wrap = GetParam();
        map_.texels.resize(std::size_t(map_.width) * std::size_t(map_.height));
        for (auto& h : map_.texels) h = uint16_t(dice.integer(0, 65535));
        table_ = host::make_level_table(map_, host::LevelFilter::BoxMaximum);
        view_.width = map_.width;
        view_.height = map_.height;
        view_.wrap = map_.wrap;
        view_.filter = HeightFilter::Maximum;
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
        return displace_.displacement(u, read) >> profile_.displacement.frac;
    }
};

TEST_P(Cover, NoTexelUnderTheFootprintIsHigherThanTheMaximum) {
    Dice dice(kSeed + 2);
    Footprint<Fixed> unit(profile_);
    uint64_t footprints = 0, texels = 0, beside = 0;
    for (int m = 0; m < 400; ++m) {
        random_map(dice);
        unit.configure({map_.width, map_.height, table_.last_level, {}});
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
        "%s: %llu footprints, %llu texels under them, none missed; the corners of the "
        "parallelogram alone miss a higher texel in %.1f %% of them\n",
        GetParam() ? "periodic" : "clamped", (unsigned long long)footprints,
        (unsigned long long)texels, 100.0 * double(beside) / double(footprints));
    EXPECT_GT(beside, 0u);
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

INSTANTIATE_TEST_SUITE_P(Borders, Cover, testing::Bool());

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

}  // namespace
}  // namespace repousse
