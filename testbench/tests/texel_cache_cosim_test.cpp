// The RTL of texel_cache: hard and random reads in many shapes, every state of tiny ones, Icarus,
// every accept and departure cycle, and engines that are wrong on purpose.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "datapath/units/texel_cache.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

struct Shape {
    int line_bits, set_bits, ways, replacement;
};

std::unique_ptr<UnitModel> model_of(const Shape& shape) {
    Profile profile = *shipped_profile("default");
    profile.cache_line_bits = shape.line_bits;
    profile.cache_set_bits = shape.set_bits;
    profile.cache_ways = shape.ways;
    profile.cache_replacement = shape.replacement;
    return make_texel_cache_model(profile);
}

std::string name_of(const Shape& s) {
    return "Lines" + std::to_string(s.line_bits) + "Sets" + std::to_string(s.set_bits) + "Ways" +
           std::to_string(s.ways) + (s.replacement == 0 ? "Oldest" : "LeastRecent");
}

class TexelCacheRtl : public testing::TestWithParam<Shape> {};

// The two shipped profiles', one word in all, direct-mapped, odd numbers of ways, one set, 8 ways
// of long lines, many sets.
INSTANTIATE_TEST_SUITE_P(Shapes, TexelCacheRtl,
                         testing::Values(Shape{3, 6, 4, 1}, Shape{2, 5, 2, 0}, Shape{0, 0, 1, 0},
                                         Shape{0, 6, 1, 1}, Shape{1, 2, 3, 1}, Shape{4, 0, 8, 1},
                                         Shape{5, 1, 5, 0}, Shape{0, 10, 2, 1}),
                         [](const auto& shape) { return name_of(shape.param); });

TEST_P(TexelCacheRtl, HardCasesAndRandomReads) {
    const auto model = model_of(GetParam());
    const Outcome outcome = run_verilator(*model, 200'000);
    EXPECT_GE(outcome.cases, 200'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(TexelCacheRtl, InIcarus) {
    const auto model = model_of(GetParam());
    expect_equal_in_icarus(*model, 2'000);
}

/// hit:  offer = A + 1
/// miss: a(0) = A + 1, a(j) = max(a(j-1) + 1, d(j-K) + 1), d(j) = a(j) + M + 1 for the words j of
///       the line, K = min(words, 8) of them in flight, a memory that answers after M cycles and
///       takes every request; offer = d(last) + 1
/// D = max(offer, R), A(next) = max(V, D)
/// With lines of one word, that is the recurrence of a direct-mapped cache in front of a client of
/// latency M + 1.
TEST_P(TexelCacheRtl, AcceptAndDepartureCyclesFollowTheRecurrence) {
    const auto model = model_of(GetParam());
    EngineInstance instance(engine_of(*model));
    Random random(3);
    constexpr std::size_t kCount = 20'000;
    for (const uint32_t latency : {1U, 3U, 9U}) {
        const Scenario scenario = model->random(random, kCount);
        std::vector<int64_t> expected;
        model->evaluate(scenario, expected);
        const std::vector<uint64_t> offer = random_cycles(random, kCount, 1, 16);
        const std::vector<uint64_t> ready = random_cycles(random, kCount, 0, 12);
        instance.configure(scenario.config, scenario.table.get(), latency);
        const auto [out, accept, depart] = pass(instance, *model, scenario.inputs, offer, ready);
        EXPECT_EQ(out, expected);

        const std::size_t words = std::size_t{1} << GetParam().line_bits;
        const std::size_t places = std::min<std::size_t>(words, 8);
        std::vector<uint64_t> d(words);
        std::size_t wrong = 0, misses = 0;
        for (std::size_t i = 0; i < kCount; ++i) {
            const uint64_t a = i == 0 ? offer[i] : std::max(offer[i], depart[i - 1]);
            uint64_t earliest = a + 1;
            if (expected[i * model->outputs() + 1] == 0) {
                ++misses;
                for (std::size_t j = 0; j < words; ++j) {
                    if (j >= places) earliest = std::max(earliest, d[j - places] + 1);
                    d[j] = earliest + latency + 1;
                    ++earliest;
                }
                earliest = d.back() + 1;
            }
            wrong += accept[i] != a || depart[i] != std::max(earliest, ready[i]);
        }
        EXPECT_EQ(wrong, 0U) << "memory latency " << latency;
        EXPECT_GT(misses, 1000U);
    }
}

TEST_P(TexelCacheRtl, HitsFollowEachOtherWithoutAGap) {
    const auto model = model_of(GetParam());
    EngineInstance instance(engine_of(*model));
    std::vector<int64_t> in;
    for (int i = 0; i < 100; ++i) in.insert(in.end(), {i == 0, 1234});
    const Scenario scenario = model->hard_cases().front();
    instance.configure(scenario.config, scenario.table.get(), 1);
    const auto [out, accept, depart] = pass(instance, *model, in);
    const auto words = uint64_t{1} << GetParam().line_bits;
    if (words <= 8) {
        EXPECT_EQ(depart[0] - accept[0], words + 3);  // M = 1
    }
    for (std::size_t i = 1; i < 100; ++i) {
        EXPECT_EQ(depart[i] - accept[i], uint64_t(model->desc().latency));
        EXPECT_EQ(depart[i] - depart[i - 1], uint64_t(model->desc().interval));
    }
}

class TinyTexelCacheRtl : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Shapes, TinyTexelCacheRtl,
                         testing::Values(Shape{1, 1, 2, 1}, Shape{1, 1, 2, 0}, Shape{1, 2, 1, 0},
                                         Shape{0, 0, 3, 1}, Shape{1, 0, 3, 0}, Shape{0, 0, 4, 1}),
                         [](const auto& shape) { return name_of(shape.param); });

TEST_P(TinyTexelCacheRtl, EveryReadInEveryState) {
    const auto model = model_of(GetParam());
    const Outcome outcome = run_exhaustive(*model, engine_of(*model), effort(0), {});
    EXPECT_GT(outcome.cases, 1'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    RecordProperty("cases", std::to_string(outcome.cases));
}

class WrongTexelCacheRtl : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    IsFound, WrongTexelCacheRtl,
    testing::Values(Mutation{"KeepsItsLines", "texel_cache", "units/texel_cache.sv",
                             "load & invalidate", "1'b0 & invalidate"},
                    Mutation{"IgnoresTheHighestTagBit", "texel_cache", "units/texel_cache_way.sv",
                             "(tags[set] == tag)", "(tags[set][TW-2:0] == tag[TW-2:0])"},
                    Mutation{"IsCompleteAWordEarly", "texel_cache", "units/texel_cache.sv",
                             "(fill_word == LAST)", "(fill_word == LAST - 1'b1)"},
                    Mutation{"FetchesEveryOtherWordTwice", "texel_cache", "units/texel_cache.sv",
                             "| AW'(next)", "| (AW'(next) & ~AW'(1))"},
                    Mutation{"DoesNotTouchOnAHit", "texel_cache", "units/texel_cache_order.sv",
                             "fill | read", "fill | (read & empty)"},
                    Mutation{"AgesAllWays", "texel_cache", "units/texel_cache_order.sv",
                             "(own < age)", "(own < age | own != LAST)"},
                    Mutation{"CountsOnInAnEmptySet", "texel_cache", "units/texel_cache_order.sv",
                             "empty ? AW'(WAYS - 1 - w)", "(empty & read) ? AW'(WAYS - 1 - w)"},
                    Mutation{"SaysHitAfterAMiss", "texel_cache", "units/texel_cache.sv",
                             "missed   <= 1'b1", "missed   <= 1'b0"},
                    Mutation{"EvictsFromEmptySets", "texel_cache", "units/texel_cache.sv",
                             "|(there & chosen)", "1'b1"}),
    [](const auto& mutation) { return mutation.param.name; });

TEST_P(WrongTexelCacheRtl, InVerilator) {
    const Mutation& m = GetParam();
    const auto model = model_of({3, 6, 4, 1});
    const Mutant mutant(m);
    const Outcome outcome = run_verilator(*model, 20'000, mutant.root());
    EXPECT_GT(outcome.mismatches, 0U);
}

}  // namespace
}  // namespace repousse::cosim
