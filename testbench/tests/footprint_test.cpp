// footprint: half steps against long double, levels against their definition, and the edge
// constraint at every kind of adder.

#include "datapath/units/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "datapath/units/triangle_setup.h"
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

    void configure(int width, int height, int last_level, int finer = 0) {
        unit_.configure({width, height, last_level, finer, {}});
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
    std::array<int, 15> seen{};
    for (int i = 0; i < 150'000; ++i) {
        const int finer = i % (kMostFiner + 1);
        configure(1024, 1024, 10, finer);
        const auto kind = dice_.flip() ? NameKind::Edge : NameKind::Interior;
        // Half of two steps, so that no reach is limited to the map.
        const LevelRead read = unit_(vertex(kind, 1024, 1024, std::exp2(dice_.real(-4, 9.9))));
        const int64_t side = 2 * int64_t{std::max(read.reach_x, read.reach_y)};
        int level = 0;
        while ((int64_t{one()} << level) < side) ++level;
        ASSERT_EQ(read.level, std::clamp(level - finer, 0, 10));
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
        unit_.configure({1, 1, 0, 0, eye});
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

}  // namespace
}  // namespace repousse
