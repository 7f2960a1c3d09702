// displace: D(U) and P' against exact rationals (long double holds every product here exactly).

#include "datapath/units/displace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 31;

class DisplaceUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
    Displace<Fixed> unit_{profile_};
    std::vector<uint16_t> heights_;
    MapView<Fixed> map_;

    // A map of random heights whose scale register stands for `range` over all heights.
    void random_map(int width, int height, bool wrap, HeightFilter filter, double range) {
        Dice dice(kSeed);
        heights_.resize(std::size_t(width) * std::size_t(height));
        for (uint16_t& h : heights_) h = uint16_t(dice.integer(0, profile_.height.max_raw()));
        map_.width = width;
        map_.height = height;
        map_.wrap = wrap;
        map_.filter = filter;
        map_.heights = heights_;
        const double scale = range / double(profile_.height.max_raw());
        map_.scale_exponent = kScaleBits - 1 - std::ilogb(scale) - 1;
        map_.scale_mantissa = int32_t(std::lround(std::ldexp(scale, map_.scale_exponent)));
        unit_.configure(map_);
    }
    Uv at(double x, double y) const {
        return {int32_t(std::floor(std::ldexp(x, profile_.uv.frac))),
                int32_t(std::floor(std::ldexp(y, profile_.uv.frac)))};
    }
    int64_t texel(int x, int y) const {
        const auto inside = [this](int i, int size) {
            return map_.wrap ? (i % size + size) % size : std::clamp(i, 0, size - 1);
        };
        return heights_[std::size_t(inside(y, map_.height) * map_.width + inside(x, map_.width))];
    }
    // The height at U in LSB: exact.
    long double height(Uv u) const {
        const int one = 1 << profile_.uv.frac;
        const auto floor_of = [one](int v) { return int(std::floor(double(v) / one)); };
        if (map_.filter == HeightFilter::Nearest) return texel(floor_of(u.x), floor_of(u.y));
        const int i = floor_of(u.x - one / 2), j = floor_of(u.y - one / 2);
        const long double s = (long double)(u.x - one / 2 - i * one) / one;
        const long double t = (long double)(u.y - one / 2 - j * one) / one;
        return (texel(i, j) * (1 - s) + texel(i + 1, j) * s) * (1 - t) +
               (texel(i, j + 1) * (1 - s) + texel(i + 1, j + 1) * s) * t;
    }
    long double scale() const {
        return std::ldexp((long double)map_.scale_mantissa, -map_.scale_exponent);
    }
    double displacement(Uv u) {
        return std::ldexp(unit_.displacement(u), -profile_.displacement.frac);
    }
    double lsb(const Format& format) const { return std::ldexp(1.0, -format.frac); }
};

// D is rounded once with nearest reads: 1/2 LSB. A filtered height is rounded before: 1/2 LSB of
// that times the scale.
TEST_P(DisplaceUnit, DisplacementIsWithinItsRounding) {
    for (const auto filter : {HeightFilter::Nearest, HeightFilter::Bilinear}) {
        for (const bool wrap : {false, true}) {
            random_map(37, 23, wrap, filter, 0.7);
            const int filter_bits = profile_.filtered_height.frac - profile_.height.frac;
            const double bound =
                0.5 * lsb(profile_.displacement) +
                (filter == HeightFilter::Bilinear ? 0.5 * std::ldexp(double(scale()), -filter_bits)
                                                  : 0.0);
            Dice dice(kSeed + 1);
            double worst = 0;
            for (int i = 0; i < 100'000; ++i) {
                const Uv u = at(dice.real(-18, 55), dice.real(-11, 34));
                worst = std::max(worst, std::abs(displacement(u) - double(height(u) * scale())));
            }
            EXPECT_LE(worst, bound);
            EXPECT_GT(worst, 0.9 * 0.5 * lsb(profile_.displacement));
        }
    }
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

// P' = P + D N: 1/2 LSB of the position on top of the error of D, for a normal as long as one.
TEST_P(DisplaceUnit, PositionIsWithinHalfAnLsbAndTheErrorOfD) {
    random_map(37, 23, true, HeightFilter::Bilinear, 0.7);
    const Format& p = profile_.position;
    const double d_bound =
        0.5 * lsb(profile_.displacement) +
        0.5 * std::ldexp(double(scale()), profile_.height.frac - profile_.filtered_height.frac);
    Dice dice(kSeed + 2);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const Uv u = at(dice.real(-18, 55), dice.real(-11, 34));
        const auto n = to_raw(dice.direction(), profile_.normal);
        const Vec3<int32_t> base =
            to_raw({dice.real(-50, 50), dice.real(-50, 50), dice.real(-50, 50)}, p);
        const double d = double(height(u) * scale());
        const glm::dvec3 exact = to_real(base, p) + d * to_real(n, profile_.normal);
        worst = std::max(worst, test::farthest(to_real(unit_(base, n, u), p), exact));
    }
    std::printf("%s, seed %llu: P' within %.4f LSB (bound %.4f)\n", GetParam(),
                (unsigned long long)kSeed + 2, worst / lsb(p), 0.5 + d_bound * 1.001 / lsb(p));
    EXPECT_LE(worst, 0.5 * lsb(p) + d_bound * 1.001);
    EXPECT_GT(worst, 0.49 * lsb(p));
}

TEST_P(DisplaceUnit, BilinearIsExactAtTexelCentres) {
    random_map(16, 16, true, HeightFilter::Bilinear, 1.0);
    Displace<Fixed> nearest(profile_);
    MapView<Fixed> as_printed = map_;
    as_printed.filter = HeightFilter::Nearest;
    nearest.configure(as_printed);
    for (int y = -8; y < 24; ++y) {
        for (int x = -8; x < 24; ++x) {
            const Uv u = at(x + 0.5, y + 0.5);
            ASSERT_EQ(unit_.displacement(u), nearest.displacement(u)) << x << ", " << y;
        }
    }
    EXPECT_EQ(unit_.counters().reads, 4u * 32 * 32);
    EXPECT_EQ(nearest.counters().reads, 32u * 32);
}

TEST_P(DisplaceUnit, BilinearIsLinearOnARampAndFlatBeyondTheBorder) {
    random_map(16, 4, false, HeightFilter::Bilinear, 1.0);
    for (std::size_t i = 0; i < heights_.size(); ++i) heights_[i] = uint16_t(100 * (i % 16));
    const int one = 1 << profile_.uv.frac;
    for (int x = 0; x <= 16 * one; ++x) {
        const long double exact = std::clamp(100.0L * (x - one / 2) / one, 0.0L, 1500.0L);
        ASSERT_EQ(height({x, one}), exact);
        ASSERT_NEAR(displacement({x, one}), double(exact * scale()),
                    0.5 * lsb(profile_.displacement) + double(scale()) / 2);
    }
    EXPECT_EQ(unit_.displacement(at(-5, 1)), unit_.displacement(at(0.5, 1)));
    EXPECT_EQ(unit_.displacement(at(21, 1)), unit_.displacement(at(15.5, 1)));
}

// U = W is the last vertex of a base mesh: the last texel of a clamped map, the first of a
// periodic one.
TEST_P(DisplaceUnit, SeamReadsLastOrFirstTexel) {
    random_map(32, 32, false, HeightFilter::Nearest, 1.0);
    EXPECT_EQ(unit_.displacement(at(32, 32)), unit_.displacement(at(31, 31)));
    EXPECT_EQ(unit_.displacement(at(-1, 3)), unit_.displacement(at(0, 3)));
    for (const auto filter : {HeightFilter::Nearest, HeightFilter::Bilinear}) {
        random_map(32, 32, true, filter, 1.0);
        for (int k = 0; k < 32 << profile_.uv.frac; k += 3) {
            const Uv left{k / 2, k}, right{k / 2 + (32 << profile_.uv.frac), k};
            ASSERT_EQ(unit_.displacement(left), unit_.displacement(right));
        }
    }
}

TEST_P(DisplaceUnit, BrightestTexelAndNegativeBias) {
    random_map(4, 4, false, HeightFilter::Bilinear, 0.5);
    for (uint16_t& h : heights_) h = uint16_t(profile_.height.max_raw());
    map_.bias = to_raw(-0.25, profile_.displacement);
    unit_.configure(map_);
    // The scale has 24 bits: 2^-25 of the range, and D half an LSB.
    EXPECT_NEAR(displacement(at(1.3, 2.7)), 0.25,
                0.5 * lsb(profile_.displacement) + 0.5 * std::ldexp(1.0, -24) +
                    0.5 * lsb(profile_.filtered_height));
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

TEST_P(DisplaceUnit, UnitAxisMovesOneComponentOnly) {
    random_map(8, 8, false, HeightFilter::Nearest, 0.3);
    const Vec3<int32_t> base = to_raw({1.5, -2.25, 0.75}, profile_.position);
    const auto up = unit_(base, {0, 0, 1 << profile_.normal.frac}, at(3, 4));
    EXPECT_EQ(up.x, base.x);
    EXPECT_EQ(up.y, base.y);
    EXPECT_GE(up.z, base.z);
    EXPECT_EQ(unit_(base, {0, 0, 0}, at(3, 4)), base);  // no normal: not displaced
}

TEST_P(DisplaceUnit, LeavingTheFormatSaturatesAndIsCounted) {
    random_map(8, 8, false, HeightFilter::Nearest, 1.0);
    for (uint16_t& h : heights_) h = uint16_t(profile_.height.max_raw());
    const auto most = int32_t(profile_.position.max_raw());
    const auto p = unit_({0, 0, most - 5}, {0, 0, 1 << profile_.normal.frac}, at(1, 1));
    EXPECT_EQ(p.z, most);
    EXPECT_EQ(unit_.counters().overflows, 1u);
    EXPECT_EQ(unit_.counters().items, 1u);
}

TEST_P(DisplaceUnit, OnlySplitEdgesAreDisplaced) {
    random_map(8, 8, false, HeightFilter::Nearest, 1.0);
    Edge<Fixed> edges[5];
    edges[1].split = edges[4].split = true;
    for (Edge<Fixed>& edge : edges) edge.mid.normal = {0, 0, 1 << profile_.normal.frac};
    unit_.run(edges);
    EXPECT_EQ(unit_.counters().items, 2u);
    EXPECT_EQ(edges[0].mid.displaced, (Vec3<int32_t>{0, 0, 0}));
    EXPECT_GT(edges[1].mid.displaced.z, 0);
}

INSTANTIATE_TEST_SUITE_P(Profile, DisplaceUnit, testing::Values("default", "narrow"));

TEST(DisplaceReal, IsThePlainFormula) {
    const std::vector<uint16_t> heights = {0, 1000, 2000, 65535};
    MapView<Real> map;
    map.width = map.height = 2;
    map.heights = heights;
    map.scale_mantissa = 0.5 / 65535;
    map.bias = -0.125;
    map.filter = HeightFilter::Bilinear;
    Displace<Real> unit(test::profile_with("default", {}));
    unit.configure(map);
    EXPECT_DOUBLE_EQ(unit.displacement({256, 256}), 68535 / 4. * 0.5 / 65535 - 0.125);
    EXPECT_DOUBLE_EQ(unit.displacement({511, 511}), 0.375);
    const auto p = unit({1, 2, 3}, {0, 0.6, 0.8}, {511, 511});
    EXPECT_DOUBLE_EQ(p.y, 2 + 0.6 * 0.375);
    EXPECT_DOUBLE_EQ(p.z, 3 + 0.8 * 0.375);
}

}  // namespace
}  // namespace repousse
