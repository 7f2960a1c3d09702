// The Summed Height Test as a unit: what it reads, which edges and registers it refuses, what it
// skips, its transactions.

#include "datapath/units/height_test.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "datapath/numbers/policy.h"
#include "testbench/tests/support/height_bench.h"

namespace repousse {
namespace {

using test::kOne;
using Bench = test::HeightBench;

TEST(HeightTest, ReadsGrowWhereABoxCrossesASeam) {
    Bench bench = test::noise_map(16, 16);
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
    Bench bench = test::noise_map(8, 8);
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
    Bench bench = test::noise_map(8, 8);
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

TEST(HeightTest, RunSkipsDecidedEdgesAndThoseTheNormalTestHasFound) {
    Bench bench = test::noise_map(16, 16);
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
    Bench bench = test::noise_map(8, 8);
    bench.configure(false, BoxKind::Square, HeightMode::Average, 0);
    EXPECT_FALSE(bench.unit(in, bench.stats).sht);
    EXPECT_EQ(bench.stats.reads, 0U) << "a skipped item reads nothing";
}

}  // namespace
}  // namespace repousse
