// The RTL of edge_iter and split, whose items leave as several beats: random and hard triangles,
// all of a tiny profile, Icarus, every accept and departure cycle, and engines that are wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

class TessellationRtl : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Units, TessellationRtl, testing::Values("edge_iter", "split"),
                         [](const auto& unit) { return unit.param; });

TEST_P(TessellationRtl, HardCasesAndRandomOnes) {
    for (const char* profile : {"default", "narrow"}) {
        const auto model = model_of(GetParam(), profile);
        const Outcome outcome = run_verilator(*model, 200'000);
        EXPECT_GE(outcome.cases, 200'000U);
        EXPECT_EQ(outcome.mismatches, 0U) << profile << ": " << outcome.first_mismatch;
    }
}

TEST_P(TessellationRtl, EveryTransactionOfATinyProfile) {
    const auto model = model_of(GetParam());
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    // edge_iter has no more than 19 bits of inputs and registers.
    EXPECT_GE(outcome.cases, uint64_t{1} << (GetParam() == "edge_iter" ? 19 : 24));
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(TessellationRtl, InIcarus) {
    const auto model = model_of(GetParam());
    expect_equal_in_icarus(*model, 5'000);
}

/// A pipe of `latency - 1` stages (none for edge_iter) in front of rp_expand, with
///     A'(i+1) = max(V'(i+1), D(i, last)),  D(i,j) = max(previous D + 1, A'(i) + 1, R).
TEST_P(TessellationRtl, AcceptAndDepartureCyclesFollowTheRecurrence) {
    const auto model = model_of(GetParam());
    EngineInstance instance(engine_of(*model));
    Random random(3);
    constexpr std::size_t kCount = 20'000;
    const Scenario scenario = model->random(random, kCount);
    std::vector<int64_t> expected;
    model->evaluate(scenario, expected);
    const std::size_t beats = expected.size() / model->outputs();

    const std::vector<uint64_t> offer = random_cycles(random, kCount, 1, 16);
    const std::vector<uint64_t> ready = random_cycles(random, beats, 0, 12);
    instance.configure(scenario.config, nullptr, 1);
    const auto [out, accept, depart] = pass(instance, *model, scenario.inputs, offer, ready, beats);
    EXPECT_EQ(out, expected);

    const auto pipe = static_cast<std::size_t>(model->desc().latency - 1);
    std::vector<uint64_t> into(kCount);  // the cycle in which an item enters rp_expand
    std::size_t wrong = 0, beat = 0;
    uint64_t before = 0;  // the last departure
    for (std::size_t i = 0; i < kCount; ++i) {
        uint64_t a = offer[i];
        if (i > 0) a = std::max(a, accept[i - 1] + 1);
        if (i >= pipe && pipe > 0) a = std::max(a, into[i - pipe]);
        if (pipe == 0) a = std::max(a, before);
        wrong += accept[i] != a;
        into[i] = std::max(a + pipe, before);
        if (i > 0 && pipe > 0) into[i] = std::max(into[i], into[i - 1] + 1);
        uint64_t earliest = into[i] + 1;
        for (bool last = false; !last; ++beat) {
            const uint64_t d = std::max(earliest, ready[beat]);
            wrong += depart[beat] != d;
            earliest = d + 1;
            before = d;
            last = model->ends_item(&expected[beat * model->outputs()]);
        }
    }
    EXPECT_EQ(wrong, 0U);
}

TEST_P(TessellationRtl, CapacityAndInterval) {
    const auto model = model_of(GetParam());
    EngineInstance instance(engine_of(*model));
    // Items of the most children: nothing is above a cap, all edges are split.
    std::vector<int64_t> item(model->inputs(), 0);
    if (GetParam() == "split") std::fill_n(item.begin(), 5, 7);
    const std::size_t most = GetParam() == "split" ? 4 : 3;
    constexpr std::size_t kCount = 20;
    const std::size_t beats = kCount * most;
    instance.configure({1}, nullptr, 1);
    const std::vector<uint64_t> accept = pass(instance, *model, repeated(item, kCount), {},
                                              std::vector<uint64_t>(beats, 1000), beats)
                                             .accept;
    const auto capacity = static_cast<std::size_t>(model->desc().capacity);
    EXPECT_LT(accept[capacity - 1], 1000U);
    EXPECT_GE(accept[capacity], 1000U);
    EXPECT_EQ(accept[15] - accept[14], uint64_t(model->desc().interval));
}

class WrongTessellationRtl : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    IsFound, WrongTessellationRtl,
    testing::Values(Mutation{"EdgeIterTakesTheLowerEnd", "edge_iter", "units/edge_iter.sv",
                             "(a > b) ? a : b", "(a < b) ? a : b"},
                    Mutation{"EdgeIterForgetsWhatIsKnown", "edge_iter", "units/edge_iter.sv",
                             "may_split = ~unsplit &", "may_split = {unsplit[2], ~unsplit[1:0]} &"},
                    Mutation{"SplitNeedsASurfaceTest", "split", "units/split.sv",
                             "{3{~has_surface_test}}", "{2'b00, ~has_surface_test}"},
                    Mutation{"SplitPrefersTheSecondDiagonal", "split", "units/split.sv",
                             "length1 <= length2", "length1 < length2"},
                    Mutation{"SplitDoesNotSaturate", "split", "units/split_length.sv",
                             "(cut > HIGH)", "(1'b0)"},
                    Mutation{"SplitHalvesZ", "split", "units/split_length.sv",
                             "squares[4*DW +: 2*DW];", "(squares[4*DW +: 2*DW] >> 1);"},
                    Mutation{"SplitForgetsUnsplitEdges", "split", "units/split_child.sv",
                             "unsplit = 3'b010", "unsplit = 3'b000"},
                    Mutation{"SplitTurnsTheQuad", "split", "units/split_child.sv",
                             "shorter ? a : b", "shorter ? b : a"}),
    [](const auto& mutation) { return mutation.param.name; });

TEST_P(WrongTessellationRtl, InVerilator) {
    const Mutation& m = GetParam();
    const auto model = model_of(m.unit);
    const Mutant mutant(m);
    const Outcome outcome = run_verilator(*model, 50'000, mutant.root());
    EXPECT_GT(outcome.mismatches, 0U);
}

}  // namespace
}  // namespace repousse::cosim
