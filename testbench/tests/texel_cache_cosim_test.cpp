// The RTL of texel_cache: hard and random reads in many shapes, every state of tiny ones, Icarus,
// every accept and departure cycle, and engines that are wrong on purpose.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "datapath/units/texel_cache.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/tests/support/mutant.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

Engine engine_of(const UnitModel& model, const std::filesystem::path& root = source_folder()) {
    const auto path = build_engine(model.desc(), model.profile(), root);
    if (!path) throw std::runtime_error(path.error().message());
    auto engine = Engine::open(*path, model.desc(), model.profile());
    if (!engine) throw std::runtime_error(engine.error().message());
    return *engine;
}

Effort effort(uint64_t vectors) {
    Effort e;
    e.vectors = vectors;
    e.stalled_percent = 50;
    return e;
}

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
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(200'000), {});
    EXPECT_GE(outcome.cases, 200'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(TexelCacheRtl, InIcarus) {
    const auto model = model_of(GetParam());
    const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 2'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, 2'000U);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
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
        std::vector<uint64_t> offer(kCount), ready(kCount), accept(kCount), depart(kCount);
        uint64_t v = 0, r = 0;
        for (uint64_t& t : offer) t = v += random.percent(60) ? 1 : 1 + random.below(16);
        for (uint64_t& t : ready) t = r += random.percent(60) ? 1 : random.below(12);
        std::vector<int64_t> out(expected.size());
        RepousseBatch batch = plain_batch(kCount, scenario.inputs.data(), out.data());
        batch.offer = offer.data(), batch.ready = ready.data();
        batch.accept = accept.data(), batch.depart = depart.data();
        instance.configure(scenario.config, scenario.table.get(), latency);
        const uint64_t start = instance.cycle();
        for (auto* cycles : {&offer, &ready}) {
            for (uint64_t& t : *cycles) t += start;
        }
        ASSERT_EQ(instance.run(batch), kRepousseDone);
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
    std::vector<int64_t> in, out(100 * model->outputs());
    for (int i = 0; i < 100; ++i) in.insert(in.end(), {i == 0, 1234});
    std::vector<uint64_t> depart(100), accept(100);
    RepousseBatch batch = plain_batch(100, in.data(), out.data());
    batch.depart = depart.data(), batch.accept = accept.data();
    const Scenario scenario = model->hard_cases().front();
    instance.configure(scenario.config, scenario.table.get(), 1);
    ASSERT_EQ(instance.run(batch), kRepousseDone);
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

struct Mutation {
    const char* name;
    const char* file;
    const char* from;
    const char* to;
};

class WrongTexelCacheRtl : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    IsFound, WrongTexelCacheRtl,
    testing::Values(
        Mutation{"KeepsItsLines", "texel_cache.sv", "load & invalidate", "1'b0 & invalidate"},
        Mutation{"IgnoresTheHighestTagBit", "texel_cache_way.sv", "(tags[set] == tag)",
                 "(tags[set][TW-2:0] == tag[TW-2:0])"},
        Mutation{"IsCompleteAWordEarly", "texel_cache.sv", "(fill_word == LAST)",
                 "(fill_word == LAST - 1'b1)"},
        Mutation{"FetchesEveryOtherWordTwice", "texel_cache.sv", "| AW'(next)",
                 "| (AW'(next) & ~AW'(1))"},
        Mutation{"DoesNotTouchOnAHit", "texel_cache_order.sv", "fill | read",
                 "fill | (read & empty)"},
        Mutation{"AgesAllWays", "texel_cache_order.sv", "(own < age)", "(own < age | own != LAST)"},
        Mutation{"CountsOnInAnEmptySet", "texel_cache_order.sv", "empty ? AW'(WAYS - 1 - w)",
                 "(empty & read) ? AW'(WAYS - 1 - w)"},
        Mutation{"SaysHitAfterAMiss", "texel_cache.sv", "missed   <= 1'b1", "missed   <= 1'b0"},
        Mutation{"EvictsFromEmptySets", "texel_cache.sv", "|(there & chosen)", "1'b1"}),
    [](const auto& mutation) { return mutation.param.name; });

TEST_P(WrongTexelCacheRtl, InVerilator) {
    const Mutation& m = GetParam();
    const auto model = model_of({3, 6, 4, 1});
    const Mutant mutant("units/" + std::string(m.file), m.from, m.to);
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(20'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
}

}  // namespace
}  // namespace repousse::cosim
