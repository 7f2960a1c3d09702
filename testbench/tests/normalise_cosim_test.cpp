// The RTL of normalise, both kinds: random and hard vectors, all vectors of a tiny profile, other
// tables, the cycles that each takes, and mutants that must be found.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "datapath/units/normalise_desc.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<UnitModel> model_of(const char* shipped, int kind) {
    Profile profile = *shipped_profile(shipped);
    profile.normalise_kind = kind;
    return make_unit_model("normalise", profile);
}

class NormaliseRtl : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Kinds, NormaliseRtl, testing::Values(0, 1), [](const auto& kind) {
    return std::string(kind.param == 0 ? "InverseSqrt" : "Cordic");
});

TEST_P(NormaliseRtl, HardVectorsAndRandomOnes) {
    for (const char* shipped : {"default", "narrow"}) {
        const auto model = model_of(shipped, GetParam());
        const Outcome outcome = run_verilator(*model, 200'000);
        EXPECT_GE(outcome.cases, 200'000U);
        EXPECT_EQ(outcome.mismatches, 0U) << shipped << ": " << outcome.first_mismatch;
    }
}

TEST_P(NormaliseRtl, EveryVectorOfATinyProfile) {
    const auto model = model_of("default", GetParam());
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    EXPECT_EQ(outcome.cases, uint64_t{1} << 24);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(NormaliseRtl, InIcarus) {
    const auto model = model_of("default", GetParam());
    expect_equal_in_icarus(*model, 1'000);
}

TEST_P(NormaliseRtl, TakesTheLatencyOfItsKindAndAVectorACycle) {
    const auto model = model_of("default", GetParam());
    EngineInstance instance(engine_of(*model));
    instance.configure({}, nullptr, 1);
    const auto latency =
        static_cast<uint64_t>(normalise_latency(GetParam(), model->profile().normal.frac));
    constexpr std::size_t kCount = 200;
    const std::vector<int64_t> in(3 * kCount, 1000);
    const auto [out, accept, depart] = pass(instance, *model, in);
    for (std::size_t i = 0; i < kCount; ++i) {
        ASSERT_EQ(depart[i] - accept[i], latency) << i;
        ASSERT_EQ(accept[i] - accept[0], i);
    }
}

TEST(NormaliseRtlTables, OtherSeedsStepsAndWidths) {
    const struct {
        int index_bits, steps, bits;
    } tables[] = {{2, 0, 8}, {5, 1, 12}, {12, 1, 24}, {4, 2, 29}};
    for (const auto& t : tables) {
        Profile profile = *shipped_profile("default");
        profile.inverse_sqrt_index_bits = t.index_bits;
        profile.inverse_sqrt_newton_steps = t.steps;
        profile.inverse_sqrt_bits = t.bits;
        const auto model = make_unit_model("normalise", profile);
        const Outcome outcome = run_verilator(*model, 50'000);
        EXPECT_EQ(outcome.mismatches, 0U) << t.index_bits << ": " << outcome.first_mismatch;
    }
}

TEST(NormaliseMutants, AreFound) {
    const struct {
        int kind;
        const char *file, *from, *to;
    } wrong[] = {
        {0, "common/rp_sqrt_newton.sv", "66'sd1073741824", "66'sd0"},
        {0, "common/rp_inverse_sqrt.sv", "e10 - 6'(carry)", "e10"},
        {1, "common/rp_cordic.sv", "{M{some}}", "{M{some | 1'b1}}"},
        {1, "common/rp_cordic.sv", "$unsigned(v[W-1] ? W'(-v) : v)", "$unsigned(v)"},
    };
    for (const auto& m : wrong) {
        const auto model = model_of("default", m.kind);
        const Mutant mutant(m.file, m.from, m.to);
        const Outcome outcome = run_verilator(*model, 100'000, mutant.root());
        EXPECT_GT(outcome.mismatches, 0U) << m.from;
    }
}

}  // namespace
}  // namespace repousse::cosim
