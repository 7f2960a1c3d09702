// The units' RTL against their datapaths: hard cases and random transactions, the narrow profile,
// every transaction of a tiny one, and in Icarus.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "testbench/cosim/table_pool.h"
#include "testbench/tests/support/rtl_engine.h"

namespace repousse::cosim {
namespace {

class RtlEquivalence : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Units, RtlEquivalence,
                         testing::Values("texcoord_test", "view_test", "normal_test", "displace",
                                         "height_test", "grid_transform", "view_clip",
                                         "perspective", "strip", "shade", "normalise", "footprint",
                                         "mid_vertex"),
                         [](const auto& unit) { return unit.param; });

TEST_P(RtlEquivalence, HardCasesAndRandomOnesInVerilator) {
    const auto model = model_of(GetParam());
    const Outcome outcome = run_verilator(*model, 200'000);
    EXPECT_GE(outcome.cases, 200'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(RtlEquivalence, NarrowProfile) {
    const auto model = model_of(GetParam(), "narrow");
    const Outcome outcome = run_verilator(*model, 50'000);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(RtlEquivalence, EveryTransactionOfATinyProfile) {
    const auto model = model_of(GetParam());
    const auto tiny = model->with(model->tiny_profile());
    if (tiny->exhaustive(0).inputs.empty()) GTEST_SKIP() << "a unit with a memory";
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    EXPECT_GE(outcome.cases, uint64_t{1} << 24);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    RecordProperty("cases", std::to_string(outcome.cases));
}

TEST_P(RtlEquivalence, HardCasesAndRandomOnesInIcarus) {
    const auto model = model_of(GetParam());
    expect_equal_in_icarus(*model, 5'000);
}

TEST_P(RtlEquivalence, TheNumberOfJobsDoesNotMatter) {
    const auto model = model_of(GetParam());
    const Engine engine = engine_of(*model);
    Effort two = effort(50'000);
    two.jobs = 2;
    const Outcome a = run_random(*model, engine, {}, effort(50'000), {});
    const Outcome b = run_random(*model, engine, {}, two, {});
    EXPECT_EQ(a.cases, b.cases);
    EXPECT_EQ(a.mismatches + b.mismatches, 0U);
}

TEST(HeightTestRtl, LargestMap) {
    // 4096 x 4096 texels at the maximum: table entries wrap around 2^38, edges are 4096 texels.
    const auto model = model_of("height_test");
    const auto table = prefix_sums(4096, 4096, model->profile().sat_width,
                                   [](int, int) { return uint64_t{65535}; });
    const Engine engine = engine_of(*model);
    std::vector<Scenario> scenarios;
    for (int kind = 0; kind < 8; ++kind) {
        const int64_t threshold = kind & 4 ? (int64_t{1} << 37) - 1 : 0;
        scenarios.push_back({"largest map",
                             {4096, 4096, kind & 1, kind >> 1 & 1, kind >> 2 & 1, threshold},
                             table,
                             {}});
        Random random(9, static_cast<uint64_t>(kind));
        for (int i = 0; i < 2'000; ++i) {
            const auto c = [&] { return random.between(0, 4096 << 8); };
            const int64_t x1 = c(), y1 = c(), x2 = c(), y2 = c();
            for (const int64_t word :
                 {int64_t{0}, x1, y1, x2, y2, (x1 + x2) >> 1, (y1 + y2) >> 1}) {
                scenarios.back().inputs.push_back(word);
            }
        }
    }
    const Outcome outcome = run_random(*model, engine, scenarios, effort(0), {});
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST(StripRtl, FifosOfAnyDepth) {
    // Three are full and empty all the time, and no whole row of banks; 0 is no FIFO at all.
    for (const int depth : {0, 1, 3, 8}) {
        Profile profile = *shipped_profile("default");
        profile.column_depth = depth;
        const auto model = make_unit_model("strip", profile);
        const Outcome outcome = run_verilator(*model, 50'000);
        EXPECT_EQ(outcome.mismatches, 0U) << depth << ": " << outcome.first_mismatch;
    }
}

}  // namespace
}  // namespace repousse::cosim
