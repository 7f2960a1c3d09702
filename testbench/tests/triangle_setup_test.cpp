// triangle_setup: rounding, main directions, the plane, the halves, and exact differences.

#include "datapath/units/triangle_setup.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using test::GridTriangle;

SweepTriangle set_up(const GridTriangle& points) {
    SweepTriangle out;
    TriangleSetup unit;
    unit(test::corners_of(points), out);
    return out;
}

TEST(TriangleSetup, SlotsRoundHalfUp) {
    TriangleSetup unit;
    EXPECT_EQ(unit.slot({31, 32, 33}), (std::array<int32_t, 3>{0, 1, 1}));
    EXPECT_EQ(unit.slot({-31, -32, -33}), (std::array<int32_t, 3>{0, 0, -1}));
    EXPECT_EQ(unit.counters().clamped, 0u);
}

TEST(TriangleSetup, SlotsAreOffsetInDepthAndClampedToTheGuardBand) {
    TriangleSetup unit;
    unit.configure({300, 4976});
    EXPECT_EQ(unit.slot({301 * 64, -500 * 64, 4976 * 64}), (std::array<int32_t, 3>{300, -300, 0}));
    EXPECT_EQ(unit.slot({300 * 64, -300 * 64, 5276 * 64}),
              (std::array<int32_t, 3>{300, -300, 300}));
    EXPECT_EQ(unit.counters().clamped, 1u);
    unit.configure({});
    EXPECT_EQ(unit.slot({(1 << 21) - 1, -(1 << 21), 0}),
              (std::array<int32_t, 3>{kGridLimit, -kGridLimit, 0}));
    unit.reset();
    EXPECT_EQ(unit.counters().clamped, 0u);
}

TEST(TriangleSetup, TiesGoToTheLowerAxisAndTheLowerEdge) {
    const SweepTriangle cube = set_up({{{0, 0, 0}, {4, 4, 4}, {4, 0, 0}}});
    EXPECT_EQ(cube.sweep_axis, 0);
    EXPECT_EQ(cube.side_axis, 1) << "both planes show the same area";
    EXPECT_EQ(cube.primary, 0) << "edges 0 and 1 have four steps, and so has edge 2";
    const SweepTriangle depth = set_up({{{0, 0, 0}, {1, 2, 3}, {0, 1, 0}}});
    EXPECT_EQ(depth.sweep_axis, 2);
    EXPECT_EQ(depth.primary, 0);
}

TEST(TriangleSetup, FormsOfATriangle) {
    EXPECT_EQ(set_up({{{0, 0, 0}, {9, 0, 0}, {4, 5, 0}}}).form, SweepCase::Roof);
    EXPECT_EQ(set_up({{{0, 0, 0}, {9, 8, 0}, {4, 5, 0}}}).form, SweepCase::Increasing);
    EXPECT_EQ(set_up({{{0, 8, 0}, {9, 0, 0}, {4, 7, 0}}}).form, SweepCase::Decreasing);
    // Mirrored, C is above the primary edge.
    const SweepTriangle below = set_up({{{0, 0, 0}, {9, 0, 0}, {4, -5, 0}}});
    EXPECT_EQ(below.form, SweepCase::Roof);
    EXPECT_EQ(below.mirror, -1);
    EXPECT_EQ(below.determinant, 45);
}

TEST(TriangleSetup, TheLargestDeterminantFits) {
    const SweepTriangle t = set_up({{{-4096, -4096, 0}, {4096, -4096, 0}, {-4096, 4096, 0}}});
    EXPECT_EQ(t.determinant, 1 << 26);
    EXPECT_EQ(t.primary_steps, 8192);
    EXPECT_EQ(t.halves[0].edge.row.modulus, 16384) << "u15";
}

TEST(TriangleSetup, DegenerateTrianglesAreCounted) {
    TriangleSetup unit;
    SweepTriangle out;
    unit(test::corners_of({{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}}), out);
    EXPECT_TRUE(out.single);
    unit(test::corners_of({{{0, 0, 0}, {2, 2, 2}, {5, 5, 5}}}), out);
    EXPECT_FALSE(out.single);
    EXPECT_EQ(out.determinant, 0);
    unit(test::corners_of({{{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}}), out);
    EXPECT_EQ(unit.counters().single, 1u);
    EXPECT_EQ(unit.counters().collinear, 1u);
    EXPECT_EQ(unit.counters().items, 3u);
    EXPECT_EQ(unit.counters().divisions, 2u * 65u);
}

// The primary edge is the longest, C lies within its range and above it, edges rise as they are
// walked: what the sweep line takes for granted.
RC_GTEST_PROP(TriangleSetup, TheSweepLinesAssumptionsHold, ()) {
    GridTriangle points;
    const int limit = *rc::gen::element(3, 20, 4096);
    for (auto& p : points) {
        for (int& x : p) x = *rc::gen::inRange(-limit, limit + 1);
    }
    const SweepTriangle t = set_up(points);
    if (t.single) return;
    RC_ASSERT(t.determinant >= 0 && t.determinant <= 1 << 26);
    int columns = 0;
    for (const SubTriangle& half : t.halves) {
        RC_ASSERT(half.columns <= half.edge.steps || half.columns == 0);
        RC_ASSERT(half.edge.steps <= t.primary_steps);
        RC_ASSERT(half.edge.row_step.quotient >= 0 && half.edge.row_step.quotient <= 1);
        RC_ASSERT(half.column_step.quotient >= 0 && half.column_step.quotient <= 1);
        RC_ASSERT(!(half.other_left && half.other_right));
        columns += half.columns;
    }
    RC_ASSERT(columns == t.primary_steps);
}

// From A, the gradients lead to B and C exactly; along an edge, its difference leads to the end.
RC_GTEST_PROP(TriangleSetup, ExactDifferencesLeadFromCornerToCorner, ()) {
    GridTriangle points;
    const int limit = *rc::gen::element(3, 60, 4096);
    for (auto& p : points) {
        for (int& x : p) x = *rc::gen::inRange(-limit, limit + 1);
    }
    auto corners = test::corners_of(points);
    for (auto& corner : corners) corner.data.fill(*rc::gen::arbitrary<int32_t>());
    SweepTriangle t;
    TriangleSetup unit;
    unit(corners, t);
    if (t.single || t.determinant == 0) return;
    __extension__ using Wide = __int128;
    const auto times_modulus = [](const SweepVector& d, Wide n) {
        return n * (Wide(d.value[0]) * d.modulus + d.remainder[0]);
    };
    const auto from = t.walks[0].edge.from, to = t.walks[0].edge.to;
    for (const uint8_t corner : {to, static_cast<uint8_t>(3 - from - to)}) {
        const auto &p = corners[from].slot, &q = corners[corner].slot;
        const Wide reached =
            times_modulus(t.sweep_difference, q[t.sweep_axis] - p[t.sweep_axis]) +
            times_modulus(t.side_difference, t.mirror * (q[t.side_axis] - p[t.side_axis]));
        const Wide expected =
            (Wide(corners[corner].data[0]) - corners[from].data[0]) * t.sweep_difference.modulus;
        RC_ASSERT(reached == expected);
    }
    for (const SubTriangle& half : t.halves) {
        const EdgeWalk& e = half.edge;
        const Wide expected =
            (Wide(corners[e.to].data[0]) - corners[e.from].data[0]) * e.difference.modulus;
        RC_ASSERT(times_modulus(e.difference, e.steps) == expected);
        RC_ASSERT(e.difference.remainder[0] < e.difference.modulus);
    }
}

// The canonical kind rounds an edge's difference once, whichever way it is walked, and arrives
// where the other way starts.
TEST(TriangleSetup, CanonicalDifferencesDoNotDependOnTheDirection) {
    const GridTriangle points = {{{0, 0, 0}, {7, 0, 0}, {3, 5, 0}}};
    for (const bool reversed : {false, true}) {
        auto corners = test::corners_of(points);
        corners[0].data.fill(1);
        corners[1].data.fill(12);  // 11/7 rounds to 2, so the walk ends 3 too far
        if (reversed) std::swap(corners[0].id, corners[1].id);
        SweepTriangle t;
        TriangleSetup unit({AdderKind::Canonical, 0, 13});
        unit(corners, t);
        const EdgeWalk &there = t.walks[0].edge, &back = t.walks[1].edge;
        EXPECT_EQ(there.difference.value[0], 2);
        EXPECT_EQ(back.difference.value[0], -2);
        EXPECT_EQ(there.start.value[0], reversed ? -2 : 1);
        EXPECT_EQ(back.start.value[0], reversed ? 12 : 15);
        EXPECT_NE(there.name_step, back.name_step);
    }
}

}  // namespace
}  // namespace repousse
