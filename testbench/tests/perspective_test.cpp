// Perspective correction against doubles, its error bound, and its hard cases.

#include "datapath/units/perspective.h"

#include <gtest/gtest.h>

#include <cmath>

#include "testbench/cosim/random.h"
#include "testbench/tests/support/profiles.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using cosim::Random;
using test::profile_with;
using Data = Perspective<Fixed>::Data;

Profile default_profile() { return *shipped_profile("default"); }

/// A random vertex with |position| < 64, |uv| < 4096, and c = c_raw * 2^-inverse_w.frac.
Data random_data(Random& random, const Profile& profile, int32_t c) {
    const double c_value = std::ldexp(c, -profile.inverse_w.frac);
    const auto times_c = [&](double v) {
        return static_cast<int32_t>(
            std::floor(std::ldexp(v * c_value, profile.sweep_data.frac) + 0.5));
    };
    const auto unit = [&] { return std::ldexp(double(random.between(-65536, 65536)), -16); };
    Data data{};
    for (std::size_t k = 0; k < 3; ++k) {
        data[k] = times_c(64 * unit());
        data[3 + k] = times_c(unit());
        data[9 + k] = times_c(unit());
    }
    data[6] = times_c(4096 * unit());
    data[7] = times_c(4096 * unit());
    data[8] = c;
    data[12] = times_c(random.percent(50) ? 1 : -1);
    return data;
}

TEST(Perspective, IsWithinItsBound) {
    // |error| <= half an LSB of the result + |v| 2^-reciprocal_bits, for every c.
    for (const char* name : {"default", "narrow"}) {
        const Profile profile = *shipped_profile(name);
        Perspective<Fixed> unit(profile);
        unit.configure(true);
        Random random(1);
        const double relative = std::ldexp(1.0, -profile.reciprocal_bits);
        double worst = 0;
        for (int i = 0; i < 200'000; ++i) {
            const int bits = profile.inverse_w.frac;
            const auto c = static_cast<int32_t>(1 + (random.next() >> (64 - bits)));
            const Data data = random_data(random, profile, c);
            const CorrectedVertex<Fixed> out = unit.correct(data);
            const auto check = [&](int32_t v_c, int64_t result, const Format& format) {
                const double exact =
                    std::ldexp(double(v_c) / c, profile.inverse_w.frac - profile.sweep_data.frac);
                if (std::abs(std::ldexp(exact, format.frac)) >= double(format.max_raw())) return;
                const double error = std::abs(std::ldexp(double(result), -format.frac) - exact);
                const double bound = std::ldexp(0.5, -format.frac) + std::abs(exact) * relative;
                worst = std::max(worst, error / bound);
            };
            check(data[0], out.position.x, profile.position);
            check(data[1], out.position.y, profile.position);
            check(data[2], out.position.z, profile.position);
            check(data[3], out.normal.x, profile.unnormalised);
            check(data[5], out.normal.z, profile.unnormalised);
            check(data[6], out.uv.x, profile.uv);
            check(data[7], out.uv.y, profile.uv);
            EXPECT_EQ(out.left_handed, profile.components == 13 && data[12] < 0);
        }
        EXPECT_LE(worst, 1.0 + 1e-9) << name;
        EXPECT_GT(worst, 0.5) << name;
    }
}

TEST(Perspective, AtTheReferenceDistanceDataPassUnchanged) {
    // c = 1: a corner at w_scale gets back the very bits that the host sent.
    const Profile profile = default_profile();
    Perspective<Fixed> unit(profile);
    Data data{};
    data[0] = -123456, data[1] = 1, data[2] = (1 << 30) + 12345;
    data[4] = 1 << 16;
    data[6] = 1000 << 8, data[7] = -(77 << 8);  // uv has 8 fraction bits, sweep_data 16
    data[8] = 1 << profile.inverse_w.frac;
    FineVertex<Fixed> out;
    unit(data, {NameKind::Interior, 0, -5, 7}, out);
    EXPECT_EQ(out.position, (Vec3<int32_t>{-123456, 1, (1 << 30) + 12345}));
    EXPECT_EQ(out.normal, (Vec3<int32_t>{0, 1 << 14, 0}));
    EXPECT_EQ(out.uv, (Uv{1000, -77}));
    EXPECT_EQ(out.handedness, 1);
    EXPECT_TRUE((out.name == VertexName{NameKind::Interior, 0, -5, 7}));
    EXPECT_EQ(unit.counters().overflows, 0U);
}

TEST(Perspective, CornersComeBackAtAnyDistance) {
    // Attributes are rounded once, after the multiplication by c; half a unit of that over c and
    // the reciprocal's error is all that may be lost.
    const Profile profile = default_profile();
    Perspective<Fixed> unit(profile);
    Random random(4);
    for (int i = 0; i < 50'000; ++i) {
        const double c = std::ldexp(1.0, -int(random.below(7))) * (0.5 + random.below(1000) / 2e3);
        const auto raw = static_cast<int32_t>(std::ldexp(c, profile.inverse_w.frac));
        const double u = double(random.between(-4096, 4096));
        Data data{};
        data[6] = static_cast<int32_t>(
            std::floor(std::ldexp(u * std::ldexp(raw, -30), profile.sweep_data.frac) + 0.5));
        data[8] = raw;
        const CorrectedVertex<Fixed> out = unit.correct(data);
        // 2^-17 / c and 4096 * 2^-24 are less than half a unit of uv, 2^-9.
        EXPECT_EQ(out.uv.x, static_cast<int32_t>(u) * 256) << "c = " << c;
    }
}

TEST(Perspective, TextureCoordinatesAreRoundedNotFloored) {
    const Profile profile = default_profile();
    Perspective<Fixed> unit(profile);
    Data data{};
    data[8] = 1 << profile.inverse_w.frac;
    data[6] = (5 << 16) - 1;  // a hair below texel 5
    EXPECT_EQ(unit.correct(data).uv.x, 5 << 8);
}

TEST(Perspective, ANonPositiveCIsTheLeastOne) {
    const Profile profile = default_profile();
    Perspective<Fixed> unit(profile);
    Data least{};
    least[0] = 3, least[1] = -2, least[8] = 1;
    const CorrectedVertex<Fixed> expected = unit.correct(least);
    EXPECT_FALSE(expected.clamped);
    EXPECT_EQ(unit.counters().overflows, 1U) << "-2 * 2^14 is the least position";
    for (const int32_t c : {0, -1, static_cast<int32_t>(profile.inverse_w.min_raw())}) {
        Data data = least;
        data[8] = c;
        const CorrectedVertex<Fixed> out = unit.correct(data);
        EXPECT_TRUE(out.clamped);
        EXPECT_EQ(out.position, expected.position);
    }
    EXPECT_EQ(unit.counters().clamped, 3U);
}

TEST(Perspective, WhatLeavesItsFormatSaturates) {
    const Profile profile = default_profile();
    Perspective<Fixed> unit(profile);
    Data data{};
    data[0] = static_cast<int32_t>(profile.sweep_data.max_raw());
    data[1] = static_cast<int32_t>(profile.sweep_data.min_raw());
    data[6] = data[0], data[7] = data[1];
    data[8] = 1;
    const CorrectedVertex<Fixed> out = unit.correct(data);
    EXPECT_EQ(out.position.x, profile.position.max_raw());
    EXPECT_EQ(out.position.y, profile.position.min_raw());
    EXPECT_EQ(out.uv, (Uv{static_cast<int32_t>(profile.uv.max_raw()),
                          static_cast<int32_t>(profile.uv.min_raw())}));
    EXPECT_EQ(unit.counters().overflows, 4U);
}

TEST(Perspective, TangentsOnlyWhereThereAreSome) {
    const Profile nine = profile_with("default", {{"components", "9"}});
    Perspective<Fixed> plain(nine);
    plain.configure(true);
    Perspective<Fixed> full(default_profile());
    Data data{};
    data[8] = 1 << 30;
    data[5] = data[9] = 1 << 16;
    data[12] = -1;
    FineVertex<Fixed> out;
    plain(data, {}, out);
    EXPECT_EQ(out.tangent, (Vec3<int32_t>{}));
    EXPECT_EQ(out.handedness, 1);
    full(data, {}, out);  // not configured
    EXPECT_EQ(out.handedness, 1);
    full.configure(true);
    full(data, {}, out);
    EXPECT_EQ(out.tangent, (Vec3<int32_t>{1 << 14, 0, 0}));
    EXPECT_EQ(out.handedness, -1);
}

TEST(Perspective, NormalsAreNormalisedAfterInterpolation) {
    // Half way between x and y the interpolated normal is 0.7 long (equation 1).
    Perspective<Fixed> unit(default_profile());
    Data data{};
    data[3] = data[4] = 1 << 14;  // (0.5, 0.5, 0) * c, c = 1/2
    data[8] = 1 << 29;
    FineVertex<Fixed> out;
    unit(data, {}, out);
    const auto expected = static_cast<int32_t>(std::lround(std::sqrt(0.5) * (1 << 14)));
    EXPECT_EQ(out.normal, (Vec3<int32_t>{expected, expected, 0}));
    data[3] = data[4] = 0;
    unit(data, {}, out);
    EXPECT_EQ(out.normal, (Vec3<int32_t>{}));
    EXPECT_EQ(unit.normalise_counters().items, 2U);
    EXPECT_EQ(unit.normalise_counters().degenerate, 1U);
}

TEST(Perspective, RealIsTheQuotient) {
    Perspective<Real> unit(default_profile());
    unit.configure(true);
    Perspective<Real>::Data data{};
    const double c = 0.3;
    data[0] = 7.0 * c, data[1] = -3.0 * c, data[2] = 0.5 * c;
    data[3] = 0.5 * c, data[4] = 0.5 * c;
    data[6] = 100.25 * c, data[7] = -3.5 * c;
    data[8] = c;
    data[11] = 0.9 * c, data[12] = -c;
    FineVertex<Real> out;
    unit(data, {}, out);
    EXPECT_NEAR(out.position.x, 7.0, 1e-14);
    EXPECT_NEAR(out.position.y, -3.0, 1e-14);
    EXPECT_NEAR(out.normal.x, std::sqrt(0.5), 1e-14);
    EXPECT_EQ(out.uv, (Uv{25664, -896}));
    EXPECT_NEAR(out.tangent.z, 1.0, 1e-14);
    EXPECT_EQ(out.handedness, -1);
}

TEST(Normalise, IsWithinOneUnitAndCountsWhatHasNoDirection) {
    const Profile profile = default_profile();
    Normalise<Fixed> unit(profile);
    Random random(5);
    for (int i = 0; i < 100'000; ++i) {
        const auto component = [&] { return static_cast<int32_t>(random.between(-70000, 70000)); };
        const Vec3<int32_t> v{component(), component(), component()};
        const double length = std::hypot(double(v.x), double(v.y), double(v.z));
        const Vec3<int32_t> n = unit(v);
        EXPECT_NEAR(n.x, v.x / length * 16384, 0.502);
        EXPECT_NEAR(n.y, v.y / length * 16384, 0.502);
        EXPECT_NEAR(n.z, v.z / length * 16384, 0.502);
    }
    EXPECT_EQ(unit({0, 0, 0}), (Vec3<int32_t>{}));
    EXPECT_EQ(unit.counters().items, 100'001U);
    EXPECT_EQ(unit.counters().degenerate, 1U);
}

}  // namespace
}  // namespace repousse
