// The Summed Height Test against sums taken texel by texel, and its hard cases by name.

#include "datapath/units/height_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "testbench/reference/height_oracle.h"
#include "testbench/tests/support/height_bench.h"

namespace repousse {
namespace {

using reference::HeightOracle;
using test::kOne;
using Bench = test::HeightBench;

using Kind = std::tuple<bool, BoxKind, HeightMode>;

class HeightTestKinds : public testing::TestWithParam<Kind> {
protected:
    bool wrap() const { return std::get<0>(GetParam()); }
    void configure(Bench& bench, uint64_t threshold) const {
        bench.configure(wrap(), std::get<1>(GetParam()), std::get<2>(GetParam()), threshold);
    }
    uint64_t some_threshold(std::mt19937& random) const {
        const bool sums = std::get<2>(GetParam()) == HeightMode::Sum;
        return sums ? random() >> (random() % 32) : random() % 8000;
    }
};

INSTANTIATE_TEST_SUITE_P(
    All, HeightTestKinds,
    testing::Combine(testing::Bool(), testing::Values(BoxKind::Square, BoxKind::Literal),
                     testing::Values(HeightMode::Average, HeightMode::Sum)),
    [](const testing::TestParamInfo<Kind>& kind) {
        return std::string(std::get<0>(kind.param) ? "Wrap" : "Clamp") +
               (std::get<1>(kind.param) == BoxKind::Square ? "Square" : "Literal") +
               (std::get<2>(kind.param) == HeightMode::Average ? "Average" : "Sum");
    });

TEST_P(HeightTestKinds, RandomEdgesAgreeWithTexelByTexelSums) {
    std::mt19937 random(2);
    for (const auto& [width, height] : {std::pair{13, 9}, {16, 16}, {1, 1}, {5, 20}}) {
        Bench bench = test::noise_map(width, height);
        for (int i = 0; i < 2000; ++i) {
            configure(bench, some_threshold(random));
            const int shortest = std::min(width, height) * kOne;
            const auto coordinate = [&](int size) {
                return int32_t(random() % uint32_t(2 * size * kOne + 1)) - size * kOne / 2;
            };
            const Uv u1{coordinate(width), coordinate(height)};
            Uv u2{coordinate(width), coordinate(height)};
            if (std::abs(u1.x - u2.x) > 2 * shortest) u2.x = u1.x;
            if (std::abs(u1.y - u2.y) > 2 * shortest) u2.y = u1.y;
            if (random() % 4 == 0) u2.y = u1.y;
            bench.expect_agreement(u1, u2);
        }
    }
}

TEST_P(HeightTestKinds, AxisAlignedEdges) {
    Bench bench = test::noise_map(16, 16);
    configure(bench, 100);
    for (int32_t d = 0; d <= 16 * kOne; d += 37) {
        bench.expect_agreement({0, 5 * kOne}, {d, 5 * kOne});
        bench.expect_agreement({3 * kOne, 0}, {3 * kOne, d});
    }
}

TEST_P(HeightTestKinds, CornersAtTheBordersAndOneLsbBesideThem) {
    Bench bench = test::noise_map(16, 16);
    configure(bench, 50);
    for (const int32_t border : {0, 16 * kOne}) {
        for (int32_t off = -2; off <= 2; ++off) {
            bench.expect_agreement({border + off, border + off}, {8 * kOne, 8 * kOne});
            bench.expect_agreement({border + off, 3}, {border + off, 4 * kOne});
            bench.expect_agreement({border + off, border}, {border + off, border});
        }
    }
}

TEST_P(HeightTestKinds, NegativeCoordinatesAndOddSums) {
    Bench bench = test::noise_map(16, 16);
    configure(bench, 50);
    for (int32_t x = -9; x <= 9; ++x) {
        bench.expect_agreement({x, -x}, {x + 5 * kOne + 1, 7 * kOne - x});
        bench.expect_agreement({-3 * kOne + x, -1}, {3 * kOne, x});
    }
}

TEST_P(HeightTestKinds, DegenerateEdge) {
    Bench bench = test::noise_map(16, 16);
    configure(bench, 0);
    for (const int32_t x : {-1, 0, 100, 16 * kOne - 1, 16 * kOne})
        bench.expect_agreement({x, x}, {x, x});
}

TEST_P(HeightTestKinds, ThresholdMaximumNeverFires) {
    Bench bench = test::noise_map(16, 16);
    const bool sums = std::get<2>(GetParam()) == HeightMode::Sum;
    configure(bench, sums ? (uint64_t{1} << bench.profile.sat_width) - 1 : 0xffff);
    for (int32_t d = 0; d <= 16 * kOne; d += 100) EXPECT_FALSE(bench({0, 0}, {d, 16 * kOne}));
}

TEST(HeightTest, ConstantMapNeverFiresWithAverages) {
    for (const uint32_t h : {0U, 1U, 30000U, 65535U}) {
        Bench bench(8, 8, [h](int, int) { return h; });
        for (const bool wrap : {false, true}) {
            bench.configure(wrap, BoxKind::Square, HeightMode::Average, 0);
            for (int32_t i = 0; i < 2000; ++i) {
                EXPECT_FALSE(bench({i, 7 * i % 2048}, {2048 - i, 3 * i % 2048}));
            }
        }
    }
}

TEST(HeightTest, LiteralBoxesOfAxisAlignedEdgesAreEmpty) {
    Bench bench = test::noise_map(16, 16);
    bench.configure(false, BoxKind::Literal, HeightMode::Sum, 0);
    EXPECT_FALSE(bench({0, 5 * kOne}, {16 * kOne, 5 * kOne}));
    bench.configure(false, BoxKind::Square, HeightMode::Sum, 0);
    EXPECT_TRUE(bench({0, 5 * kOne}, {16 * kOne, 5 * kOne}));
}

TEST(HeightTest, SeamsAgree) {
    // On a periodic map the same edge one period on gives the same answer.
    Bench bench = test::noise_map(16, 16);
    std::mt19937 random(3);
    for (const HeightMode mode : {HeightMode::Average, HeightMode::Sum}) {
        for (int i = 0; i < 3000; ++i) {
            bench.configure(true, BoxKind::Square, mode, random() % 4000);
            const int32_t period = 16 * kOne;
            const auto near_seam = [&] { return int32_t(random() % 1024) - 512; };
            const Uv u1{near_seam(), near_seam()};
            const Uv u2{near_seam(), near_seam()};
            EXPECT_EQ(bench(u1, u2), bench({u1.x + period, u1.y}, {u2.x + period, u2.y}));
            EXPECT_EQ(bench(u1, u2), bench({u1.x, u1.y + period}, {u2.x, u2.y + period}));
        }
    }
}

/// The paper's shift applied to the signed difference: half-extents of opposite sign for the two
/// directions of an edge round differently.
bool signed_shift_mutant(const HeightOracle& oracle, Uv u1, Uv u2) {
    const auto part = [](int32_t d, int k) { return std::abs(int64_t{d >> k}); };
    const int32_t du = u2.x - u1.x;
    const int32_t dv = u2.y - u1.y;
    const HeightOracle::Point end{part(du, 3), part(dv, 3)};
    const HeightOracle::Point mid{part(du, 2), part(dv, 2)};
    const auto b1 = oracle.box({u1.x, u1.y}, end);
    const auto b2 = oracle.box({u2.x, u2.y}, end);
    const auto b12 = oracle.box({(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1}, mid);
    const int64_t d =
        int64_t(b12.total * (b1.texels + b2.texels)) - int64_t((b1.total + b2.total) * b12.texels);
    return uint64_t(std::abs(d)) > oracle.threshold * b12.texels * (b1.texels + b2.texels);
}

TEST(HeightTest, ShiftingTheSignedDifferenceBreaksTheSymmetryOfLiteralBoxes) {
    Bench bench = test::noise_map(16, 16);
    bench.configure(false, BoxKind::Literal, HeightMode::Average, 2000);
    std::mt19937 random(4);
    int mutant_asymmetric = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto c = [&] { return int32_t(random() % (16 * kOne + 1)); };
        const Uv u1{c(), c()}, u2{c(), c()};
        EXPECT_EQ(bench(u1, u2), bench(u2, u1));
        mutant_asymmetric +=
            signed_shift_mutant(bench.oracle, u1, u2) != signed_shift_mutant(bench.oracle, u2, u1);
    }
    EXPECT_GT(mutant_asymmetric, 0) << "the mistake must be visible, or this test shows nothing";
}

}  // namespace
}  // namespace repousse
