// grid_transform: x, y and c against doubles; vertex data times c; the host's registers. Its depth
// has a test of its own. Figures are printed.

#include "datapath/units/grid_transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "datapath/units/triangle_setup_desc.h"
#include "testbench/host/z_table.h"
#include "testbench/tests/support/grid_unit.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;

constexpr uint64_t kSeed = 77;

class GridTransformProfiles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Profile, GridTransformProfiles, testing::Values("default", "narrow"));

// x_grid: half an LSB of its own; and focal times the error of x/w, which is half an LSB of ndc and
// the reciprocal's 2^-bits. c: half an LSB and 2^-bits.
TEST_P(GridTransformProfiles, CoordinatesAndCAreWithinTheirRoundings) {
    const Profile profile = test::profile_with(GetParam(), {});
    const auto half_lsb = [](const Format& f) { return std::ldexp(0.5, -f.frac); };
    test::GridUnit unit(profile, test::grid_camera(1024, 60, 0.25, 60));
    unit.registers.w_scale = unit.raw_w(0.5);
    unit.configure();
    const double focal = std::ldexp(unit.registers.focal_x, -profile.focal.frac);
    const double reciprocal = std::ldexp(1.0, -profile.reciprocal_bits);
    Dice dice(kSeed);
    double worst_share = 0, worst = 0;
    for (int i = 0; i < 200'000; ++i) {
        const int32_t w = unit.raw_w(std::exp(dice.real(std::log(0.3), std::log(60.0))));
        const auto x = static_cast<int32_t>(w * dice.real(-0.7, 0.7));
        const auto y = static_cast<int32_t>(w * dice.real(-0.7, 0.7));
        const GridPoint<Fixed> point = unit.at(x, y, w);
        const double ratio[2] = {double(x) / w, double(y) / w};
        for (int axis = 0; axis < 2; ++axis) {
            const double exact = (axis == 0 ? focal : -focal) * ratio[axis];
            const double error = std::abs(
                std::ldexp(point.position[static_cast<std::size_t>(axis)], -kGridFractionBits) -
                exact);
            const double bound =
                std::ldexp(0.5, -kGridFractionBits) +
                focal * (half_lsb(profile.ndc) + std::abs(ratio[axis]) * reciprocal);
            ASSERT_LE(error, bound);
            worst = std::max(worst, error);
            worst_share = std::max(worst_share, error / bound);
        }
        const double c = std::min(1.0, double(unit.registers.w_scale) / w);
        ASSERT_LE(std::abs(std::ldexp(point.c, -profile.inverse_w.frac) - c),
                  half_lsb(profile.inverse_w) + c * reciprocal);
    }
    std::printf("%s, seed %llu: x_grid and y_grid within %.4f grid units, %.2f of the bound\n",
                GetParam(), (unsigned long long)kSeed, worst, worst_share);
    EXPECT_GT(worst_share, 0.8);
    EXPECT_EQ(unit->counters().ratio_saturated + unit->counters().grid_saturated, 0U);
}

TEST_P(GridTransformProfiles, HardCases) {
    const Profile profile = test::profile_with(GetParam(), {});
    test::GridUnit unit(profile, test::grid_camera(512, 90, 0.5, 50));
    const int32_t w_min = unit.registers.w_min;
    const int32_t one = int32_t{1} << profile.inverse_w.frac;

    // w at its clamp: a vertex through the eye or behind it goes where w_min puts it.
    const GridPoint<Fixed> clamp = unit.at(100, -100, w_min);
    EXPECT_EQ(unit->counters().w_clamped, 0U);
    EXPECT_EQ(clamp.position[2], 0);
    EXPECT_EQ(clamp.c, one);
    uint64_t clamped = 0;
    for (const int32_t w : {w_min - 1, 0, -1, -w_min}) {
        const GridPoint<Fixed> p = unit.at(100, -100, w);
        EXPECT_EQ(p.position, clamp.position);
        EXPECT_EQ(p.c, clamp.c);
        EXPECT_EQ(unit->counters().w_clamped, ++clamped);
    }
    // c is 1 at w_scale and nearer, and counted where it would be more.
    unit.registers.w_scale = 2 * w_min;
    unit.configure();
    EXPECT_EQ(unit.at(0, 0, 2 * w_min).c, one);
    EXPECT_EQ(unit->counters().c_saturated, 0U);
    EXPECT_EQ(unit.at(0, 0, 2 * w_min - 1).c, one);
    EXPECT_EQ(unit.at(0, 0, w_min).c, one);
    EXPECT_EQ(unit->counters().c_saturated, 2U);
    EXPECT_EQ(unit.at(0, 0, 4 * w_min).c, one / 2);

    // An exact half between two grid positions goes up, on both sides of the axis.
    unit.registers.focal_x = unit.registers.focal_y = int32_t{1} << profile.focal.frac;
    unit.configure();
    const int32_t w = int32_t{1} << profile.clip.frac;
    EXPECT_EQ(unit.at(w >> 7, -(w >> 7), w).position,
              (std::array<int32_t, 3>{1, 0, clamp.position[2] + unit.at(0, 0, w).position[2]}));
    EXPECT_EQ(unit.at(3 * (w >> 7), -3 * (w >> 7), w).position[0], 2);
    EXPECT_EQ(unit.at(3 * (w >> 7), -3 * (w >> 7), w).position[1], -1);

    // x / w beyond ndc, and beyond the grid.
    unit->reset();
    unit.registers.focal_x = static_cast<int32_t>(profile.focal.max_raw());
    unit.registers.focal_y = 0;
    unit.configure();
    const int32_t far_side = static_cast<int32_t>(profile.clip.max_raw());
    EXPECT_EQ(unit.at(far_side, 0, w_min).position[0], (1 << (kGridPositionBits - 1)) - 1);
    EXPECT_EQ(unit.at(-far_side, 0, w_min).position[0], -(1 << (kGridPositionBits - 1)));
    EXPECT_EQ(unit->counters().grid_saturated, 2U);
    EXPECT_EQ(
        unit->counters().ratio_saturated,
        std::ldexp(far_side, profile.ndc.frac) / w_min > double(profile.ndc.max_raw()) ? 2U : 0U);
    EXPECT_EQ(unit->counters().items, 2U);
}

TEST_P(GridTransformProfiles, DataAreAttributesTimesC) {
    const Profile profile = test::profile_with(GetParam(), {});
    GridTransform<Fixed> unit(profile);
    Dice dice(kSeed);
    const double half = std::ldexp(0.5, -profile.sweep_data.frac);
    const auto small = [&](const Format& f) {  // half the range of sweep_data at most
        const int bits =
            std::min(f.width, profile.sweep_data.width - profile.sweep_data.frac + f.frac - 1);
        return static_cast<int32_t>(
            dice.integer(-(int64_t{1} << (bits - 1)), (int64_t{1} << (bits - 1)) - 1));
    };
    for (int i = 0; i < 10'000; ++i) {
        Vertex<Fixed> v;
        v.position = {small(profile.position), small(profile.position), small(profile.position)};
        v.normal = {small(profile.normal), small(profile.normal), small(profile.normal)};
        v.tangent = {small(profile.normal), small(profile.normal), small(profile.normal)};
        v.uv = {small(profile.uv), small(profile.uv)};
        v.handedness = dice.flip() ? 1 : -1;
        const auto c = static_cast<int32_t>(dice.integer(0, int64_t{1} << profile.inverse_w.frac));
        std::array<int32_t, kSweepComponents> data;
        data.fill(-7);
        unit.scale(v, c, i % 2 == 0, data);
        const double c_real = std::ldexp(c, -profile.inverse_w.frac);
        const auto expect = [&](std::size_t at, double raw, const Format& f) {
            const double exact = std::ldexp(raw, -f.frac) * c_real;
            ASSERT_NEAR(std::ldexp(data[at], -profile.sweep_data.frac), exact, half) << at;
        };
        expect(0, v.position.x, profile.position);
        expect(2, v.position.z, profile.position);
        expect(4, v.normal.y, profile.normal);
        expect(6, v.uv.x, profile.uv);
        expect(7, v.uv.y, profile.uv);
        ASSERT_EQ(data[kInverseWComponent], c);
        ASSERT_EQ(data[1], unit.scale_position(v.position.y, c));
        if (i % 2 == 0) {
            expect(9, v.tangent.x, profile.normal);
            expect(12, v.handedness, Format{8, 0});
        } else {
            for (std::size_t at = kPlainComponents; at < data.size(); ++at) ASSERT_EQ(data[at], 0);
        }
    }
    EXPECT_EQ(unit.counters().data_saturated, 0U);
}

TEST(GridTransform, DataThatDoNotFitAreCounted) {
    const Profile profile = test::profile_with("default", {{"sweep_data", "s7.16 SC_RND SC_SAT"}});
    GridTransform<Fixed> unit(profile);
    const int32_t one = int32_t{1} << profile.inverse_w.frac;
    EXPECT_EQ(unit.scale_position(int32_t{1} << 23, one), profile.sweep_data.max_raw());
    EXPECT_EQ(unit.scale_position(-(int32_t{1} << 23), one), profile.sweep_data.min_raw());
    EXPECT_EQ(unit.counters().data_saturated, 1U) << "-128 fits";
}

TEST(GridTransformReal, IsThePlainFormula) {
    const host::GridCamera view = test::grid_camera(300, 90, 1, 100);
    std::vector<uint32_t> table;
    for (const auto kind : {ZTableKind::Uniform, ZTableKind::Linear}) {
        const Profile profile = test::with_table(kind, 4);
        const auto registers = host::make_grid_registers<Real>(profile, view, table);
        ASSERT_TRUE(registers.ok());
        EXPECT_TRUE(table.empty());
        GridTransform<Real> unit(profile);
        unit.configure(*registers);
        const GridPoint<Real> p = unit({10.0, -5.0, 50.0});
        EXPECT_EQ(p.position[0], 150 / 5 * 64);
        EXPECT_EQ(p.position[1], 150 / 10 * 64);
        EXPECT_EQ(p.position[2], std::floor(host::grid_depth(view, 50.0) * 64 + 0.5));
        EXPECT_DOUBLE_EQ(p.c, 1.0 / 50);
        EXPECT_DOUBLE_EQ(unit({0, 0, 0.5}).c, 1.0);
        EXPECT_EQ(unit.counters().w_clamped, 1U);

        Vertex<Real> v;
        v.position = {1, 2, 3};
        v.uv = {256, -512};
        std::array<double, kSweepComponents> data{};
        unit.scale(v, 0.5, true, data);
        EXPECT_EQ(data[2], 1.5);
        EXPECT_EQ(data[6], 0.5) << "texels";
        EXPECT_EQ(data[7], -1.0);
        EXPECT_EQ(data[8], 0.5);
        EXPECT_EQ(data[12], 0.5);
    }
}

TEST(GridRegistersFromACamera, FollowThePaper) {
    // Figure 7: near 1, far 100, 90 degrees, 300 lines.
    EXPECT_NEAR(host::grid_depth(test::grid_camera(300, 90, 1, 100), 100), 693.08, 0.005);
    // A voxel is as deep as a pixel is wide: z_grid(w (1 + s)) = z_grid(w) + 1.
    const host::GridCamera view = test::grid_camera(300, 90, 1, 100);
    const double s = 1.0 / view.view.focal.x;
    EXPECT_NEAR(host::grid_depth(view, 7 * (1 + s)) - host::grid_depth(view, 7), 1.0, 1e-9);
    // Coarser by a factor: all three coordinates.
    host::GridCamera coarse = view;
    coarse.coarseness = 20;
    const Profile profile = test::profile_with("default", {});
    std::vector<uint32_t> table;
    const auto fine = host::make_grid_registers<Real>(profile, view, table);
    const auto other = host::make_grid_registers<Real>(profile, coarse, table);
    ASSERT_TRUE(fine.ok() && other.ok());
    EXPECT_DOUBLE_EQ(other->focal_x * 20, fine->focal_x);
    EXPECT_DOUBLE_EQ(other->focal_y * 20, fine->focal_y);
    EXPECT_DOUBLE_EQ(other->steps_per_octave * 20, fine->steps_per_octave);
}

TEST(GridRegistersFromACamera, AnotherNearPlaneOrViewAngleIsTwoRegistersOrAWholeTable) {
    for (const auto kind : {ZTableKind::Linear, ZTableKind::Uniform}) {
        const Profile profile = test::with_table(kind, 12);
        std::vector<uint32_t> a_words, b_words;
        const auto a = host::make_grid_registers<Fixed>(
            profile, test::grid_camera(1080, 60, 0.5, 500), a_words);
        const auto b = host::make_grid_registers<Fixed>(
            profile, test::grid_camera(1080, 50, 0.4, 500), b_words);
        ASSERT_TRUE(a.ok() && b.ok());
        EXPECT_NE(a->steps_per_octave, b->steps_per_octave);
        EXPECT_NE(a->log2_near, b->log2_near);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < a_words.size(); ++i) changed += a_words[i] != b_words[i];
        std::printf("%s: a new camera changes 2 registers and %zu table words\n",
                    kind == ZTableKind::Linear ? "linear" : "uniform, 4096 intervals", changed);
        EXPECT_EQ(a_words.size(), kind == ZTableKind::Linear ? 0U : 4097U);
        EXPECT_GE(changed, kind == ZTableKind::Linear ? 0U : 4000U);
        EXPECT_TRUE(std::is_sorted(a_words.begin(), a_words.end()));
    }
}

TEST(GridRegistersFromACamera, WhatDoesNotFitIsAnError) {
    std::vector<uint32_t> table;
    const Profile narrow = test::profile_with("narrow", {});
    const auto made =
        host::make_grid_registers<Fixed>(narrow, test::grid_camera(4320, 20, 1, 100), table);
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().message().find("does not fit"), std::string::npos);
    // The least w is one LSB, whatever the scene says.
    const auto least =
        host::make_grid_registers<Fixed>(narrow, test::grid_camera(300, 90, 1e-9, 100), table);
    ASSERT_TRUE(least.ok()) << least.error().message();
    EXPECT_EQ(least->w_min, 1);
}

}  // namespace
}  // namespace repousse
