// The Summed Height Test against sums taken texel by texel, and its hard cases by name.

#include "datapath/units/height_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>
#include <tuple>
#include <vector>

#include "datapath/numbers/policy.h"
#include "testbench/reference/height_oracle.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using reference::HeightOracle;

constexpr int kOne = 256;  // a texel in the default profile's UV

/// A map with its table, the unit and the oracle on it.
struct Bench {
    Bench(int width, int height, const std::function<uint32_t(int, int)>& texel)
        : profile(*shipped_profile("default")), unit(profile) {
        registers.width = oracle.width = width;
        registers.height = oracle.height = height;
        oracle.frac = profile.uv.frac;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) oracle.heights.push_back(texel(x, y));
        }
        table.assign(std::size_t(width + 1) * std::size_t(height + 1), 0);
        const auto at = [&](int x, int y) -> uint64_t& {
            return table[std::size_t(y) * std::size_t(width + 1) + std::size_t(x)];
        };
        const uint64_t mask = (uint64_t{1} << profile.sat_width) - 1;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const uint64_t h = oracle.heights[std::size_t(y * width + x)];
                at(x + 1, y + 1) = (at(x, y + 1) + at(x + 1, y) - at(x, y) + h) & mask;
            }
        }
    }

    void configure(bool wrap, BoxKind box, HeightMode mode, uint64_t threshold) {
        registers.wrap = oracle.wrap = wrap;
        registers.box = box;
        registers.mode = mode;
        registers.threshold = oracle.threshold = threshold;
        oracle.literal = box == BoxKind::Literal;
        oracle.sum = mode == HeightMode::Sum;
        ASSERT_TRUE(unit.check(registers, table.size()).ok())
            << unit.check(registers, table.size()).error().message();
        unit.configure(registers, table);
    }

    bool operator()(Uv u1, Uv u2) {
        return unit(u1, u2, {(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1}, stats);
    }

    /// Unit and oracle agree, and do so from both sides of the edge.
    void expect_agreement(Uv u1, Uv u2) {
        const Uv u12{(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
        ASSERT_TRUE(unit.accepts(u1, u2, u12));
        const bool expected = oracle({u1.x, u1.y}, {u2.x, u2.y}, {u12.x, u12.y});
        EXPECT_EQ((*this)(u1, u2), expected) << u1.x << ',' << u1.y << " to " << u2.x << ',' << u2.y
                                             << ", threshold " << registers.threshold;
        EXPECT_EQ((*this)(u2, u1), expected) << "not symmetric";
    }

    Profile profile;
    HeightTest unit;
    HeightTestRegisters registers;
    HeightTestStats stats;
    HeightOracle oracle;
    std::vector<uint64_t> table;
};

Bench noise(int width, int height) {
    std::mt19937 random(1);
    return Bench(width, height, [&](int, int) { return random() & 0xffff; });
}

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
        Bench bench = noise(width, height);
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
    Bench bench = noise(16, 16);
    configure(bench, 100);
    for (int32_t d = 0; d <= 16 * kOne; d += 37) {
        bench.expect_agreement({0, 5 * kOne}, {d, 5 * kOne});
        bench.expect_agreement({3 * kOne, 0}, {3 * kOne, d});
    }
}

TEST_P(HeightTestKinds, CornersAtTheBordersAndOneLsbBesideThem) {
    Bench bench = noise(16, 16);
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
    Bench bench = noise(16, 16);
    configure(bench, 50);
    for (int32_t x = -9; x <= 9; ++x) {
        bench.expect_agreement({x, -x}, {x + 5 * kOne + 1, 7 * kOne - x});
        bench.expect_agreement({-3 * kOne + x, -1}, {3 * kOne, x});
    }
}

TEST_P(HeightTestKinds, DegenerateEdge) {
    Bench bench = noise(16, 16);
    configure(bench, 0);
    for (const int32_t x : {-1, 0, 100, 16 * kOne - 1, 16 * kOne})
        bench.expect_agreement({x, x}, {x, x});
}

TEST_P(HeightTestKinds, ThresholdMaximumNeverFires) {
    Bench bench = noise(16, 16);
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
    Bench bench = noise(16, 16);
    bench.configure(false, BoxKind::Literal, HeightMode::Sum, 0);
    EXPECT_FALSE(bench({0, 5 * kOne}, {16 * kOne, 5 * kOne}));
    bench.configure(false, BoxKind::Square, HeightMode::Sum, 0);
    EXPECT_TRUE(bench({0, 5 * kOne}, {16 * kOne, 5 * kOne}));
}

TEST(HeightTest, SeamsAgree) {
    // On a periodic map the same edge one period on gives the same answer.
    Bench bench = noise(16, 16);
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

TEST(HeightTest, ReadsGrowWhereABoxCrossesASeam) {
    Bench bench = noise(16, 16);
    bench.configure(true, BoxKind::Square, HeightMode::Average, 10);
    const auto reads = [&](Uv u1, Uv u2) {
        return bench.unit.reads(u1, u2, {(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1});
    };
    const int t = kOne;
    EXPECT_EQ(reads({4 * t, 4 * t}, {8 * t, 8 * t}).entries, (std::array<int, 3>{4, 4, 4}));
    EXPECT_EQ(reads({4 * t, 4 * t}, {8 * t, 8 * t}).beats, 4);
    EXPECT_EQ(reads({0, 4 * t}, {8 * t, 4 * t}).entries, (std::array<int, 3>{6, 4, 4}));
    EXPECT_EQ(reads({0, 4 * t}, {8 * t, 4 * t}).beats, 6);
    EXPECT_EQ(reads({0, 0}, {8 * t, 4 * t}).entries, (std::array<int, 3>{9, 4, 4}));
    EXPECT_EQ(reads({0, 0}, {8 * t, 4 * t}).beats, 9);
    // One box crosses in x, another in y: nine beats, but no more entries than needed.
    EXPECT_EQ(reads({0, 4 * t}, {8 * t, 0}).entries, (std::array<int, 3>{6, 6, 4}));
    EXPECT_EQ(reads({0, 4 * t}, {8 * t, 0}).beats, 9);
    bench({0, 0}, {8 * t, 4 * t});
    EXPECT_EQ(bench.stats.reads, 17U);
    EXPECT_EQ(bench.stats.beats, 9U);
}

TEST(HeightTest, EdgesOutsideItsDomainAreRefusedAndCounted) {
    Bench bench = noise(8, 8);
    bench.configure(true, BoxKind::Square, HeightMode::Average, 0);
    EXPECT_EQ(bench.unit.max_edge(), 16);
    EXPECT_FALSE(bench({-4 * kOne - 1, 0}, {0, 4 * kOne}));
    EXPECT_FALSE(bench({0, 12 * kOne + 1}, {0, 4 * kOne}));
    EXPECT_EQ(bench.stats.refused, 2U);
    bench.configure(false, BoxKind::Square, HeightMode::Average, 0);
    EXPECT_EQ(bench.unit.max_edge(), 4096);
    EXPECT_TRUE(bench.unit.accepts({-100 * kOne, 0}, {0, 100 * kOne}, {0, 0}));
    EXPECT_FALSE(bench.unit.accepts({0, 0}, {4096 * kOne + 1, 0}, {0, 0}));
}

TEST(HeightTest, RegistersAreChecked) {
    Bench bench = noise(8, 8);
    const auto error = [&](const char* where) {
        const Status status = bench.unit.check(bench.registers, bench.table.size());
        ASSERT_FALSE(status.ok());
        EXPECT_EQ(status.error().where, where) << status.error().message();
    };
    bench.registers.threshold = 0x10000;
    error("threshold");
    bench.registers.mode = HeightMode::Sum;
    EXPECT_TRUE(bench.unit.check(bench.registers, bench.table.size()).ok());
    bench.registers.threshold = uint64_t{1} << bench.profile.sat_width;
    error("threshold");
    bench.registers.threshold = 0;
    bench.registers.width = 4097;
    error("map");
    bench.registers.width = 7;
    error("map");
    bench.registers.width = 0;
    error("map");
    bench.profile.sat_width = 40;
    bench.registers.width = 8;
    EXPECT_FALSE(HeightTest(bench.profile).check(bench.registers, bench.table.size()).ok());
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
    Bench bench = noise(16, 16);
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

TEST(HeightTest, RunSkipsDecidedEdgesAndThoseTheNormalTestHasFound) {
    Bench bench = noise(16, 16);
    bench.configure(false, BoxKind::Square, HeightMode::Average, 0);
    std::vector<Vertex<Fixed>> ends(2);
    ends[1].uv = {8 * kOne, 8 * kOne};
    const auto make_edges = [&] {
        std::vector<Edge<Fixed>> edges(3);
        for (Edge<Fixed>& e : edges) {
            e.v1 = &ends[0];
            e.v2 = &ends[1];
            e.mid.uv = {4 * kOne, 4 * kOne};
        }
        edges[1].nt = true;
        edges[2].undecided = false;
        return edges;
    };
    std::vector<Edge<Fixed>> edges = make_edges();
    bench.unit.run(Span<Edge<Fixed>>(edges), false);
    EXPECT_TRUE(edges[0].sht);
    EXPECT_FALSE(edges[1].sht || edges[2].sht);
    EXPECT_EQ(bench.unit.counters().items, 3U);
    EXPECT_EQ(bench.unit.counters().tests, 1U);
    EXPECT_EQ(bench.unit.stats().reads, 12U);

    bench.unit.reset();
    edges = make_edges();
    bench.unit.run(Span<Edge<Fixed>>(edges), true);
    EXPECT_TRUE(edges[1].sht && edges[2].sht);
    EXPECT_EQ(bench.unit.counters().tests, 3U);
}

TEST(HeightTest, TransactionsSurvivePacking) {
    const HeightTestIn in{true, {-1, 2}, {3, -4}, {-5, 6}};
    EXPECT_EQ(HeightTestIn::unpack(in.pack().data()).pack(), in.pack());
    Bench bench = noise(8, 8);
    bench.configure(false, BoxKind::Square, HeightMode::Average, 0);
    EXPECT_FALSE(bench.unit(in, bench.stats).sht);
    EXPECT_EQ(bench.stats.reads, 0U) << "a skipped item reads nothing";
}

}  // namespace
}  // namespace repousse
