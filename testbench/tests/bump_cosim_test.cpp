// The RTL of bump, all three kinds: random and hard vertices, all of a tiny profile, Icarus, the
// other normalisation, other tables of sines, the cycles that each takes, and mutants that must be
// found.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "datapath/units/bump_desc.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

Profile profile_of(const char* shipped, int bump_kind) {
    Profile profile = *shipped_profile(shipped);
    profile.bump_kind = bump_kind;
    return profile;
}

class BumpRtl : public testing::TestWithParam<int> {};

std::string kind_name(const testing::TestParamInfo<int>& kind) {
    return kind.param == 0 ? "Normals" : kind.param == 1 ? "Slopes" : "Turns";
}

INSTANTIATE_TEST_SUITE_P(Kinds, BumpRtl, testing::Values(0, 1, 2), kind_name);

TEST_P(BumpRtl, HardVerticesAndRandomOnes) {
    for (const char* shipped : {"default", "narrow"}) {
        const auto model = make_unit_model("bump", profile_of(shipped, GetParam()));
        const Outcome outcome = run_verilator(*model, 100'000);
        EXPECT_GE(outcome.cases, 100'000U);
        EXPECT_EQ(outcome.mismatches, 0U) << shipped << ": " << outcome.first_mismatch;
    }
}

TEST_P(BumpRtl, EveryVertexOfATinyProfile) {
    const auto model = make_unit_model("bump", profile_of("default", GetParam()));
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    EXPECT_EQ(outcome.cases, uint64_t{1} << 24);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(BumpRtl, InIcarus) {
    const auto model = make_unit_model("bump", profile_of("default", GetParam()));
    expect_equal_in_icarus(*model, 1'000);
}

TEST_P(BumpRtl, NormalisedByCordic) {
    Profile profile = profile_of("default", GetParam());
    profile.normalise_kind = 1;
    const auto model = make_unit_model("bump", profile);
    const Outcome outcome = run_verilator(*model, 20'000);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(BumpRtl, TakesTheCyclesOfItsKind) {
    const auto model = make_unit_model("bump", profile_of("default", GetParam()));
    const Scenario first = model->hard_cases().at(0);
    const Profile& profile = model->profile();
    const auto latency = static_cast<uint64_t>(
        bump_latency(GetParam(), profile.normalise_kind, profile.displaced_normal.frac));
    const auto interval = static_cast<uint64_t>(bump_interval(GetParam()));
    for (const uint32_t memory : {1, 3}) {
        EngineInstance instance(engine_of(*model));
        instance.configure(first.config, first.table.get(), memory);
        constexpr std::size_t kCount = 200;
        const std::vector<int64_t> in(model->inputs() * kCount, 100);
        const auto [out, accept, depart] = pass(instance, *model, in);
        EXPECT_EQ(depart[0] - accept[0], latency + memory - 1);
        for (std::size_t i = 50; i + 1 < kCount; ++i) {
            ASSERT_EQ(accept[i + 1] - accept[i], interval);
            ASSERT_EQ(depart[i + 1] - depart[i], interval);
        }
    }
}

TEST(BumpRtlTiming, CapacityAndBackwardLatencyAreTheDescriptions) {
    const auto model = make_unit_model("bump", profile_of("default", 0));
    const UnitDesc& desc = model->desc();
    const Scenario first = model->hard_cases().at(0);
    EngineInstance instance(engine_of(*model));
    instance.configure(first.config, first.table.get(), 1);
    const auto capacity = static_cast<std::size_t>(desc.capacity);
    const std::size_t count = capacity + 5;
    const std::vector<int64_t> in(model->inputs() * count, 100);
    const auto accept = pass(instance, *model, in, {}, std::vector<uint64_t>(count, 1000)).accept;
    EXPECT_LT(accept[capacity - 1], 1000U);
    EXPECT_GE(accept[capacity], 1000 + static_cast<uint64_t>(desc.backward_latency));
}

TEST(BumpRtlSines, TablesOfAnySize) {
    for (const auto& [index_bits, width, frac] : {std::array{2, 16, 15}, std::array{10, 16, 16},
                                                  std::array{3, 9, 7}, std::array{8, 5, 1}}) {
        Profile profile = profile_of("default", 2);
        profile.sine_index_bits = index_bits;
        profile.angle.width = width, profile.angle.frac = frac;
        const auto model = make_unit_model("bump", profile);
        const Outcome outcome = run_verilator(*model, 20'000);
        EXPECT_EQ(outcome.mismatches, 0U) << index_bits << ": " << outcome.first_mismatch;
    }
}

TEST(BumpMutants, AreFound) {
    const struct {
        int kind;
        const char *file, *from, *to;
    } wrong[] = {
        {0, "common/rp_map_coordinate.sv", "wrap ? raised - whole : whole - 1", "whole - 1"},
        {0, "units/bump_rotate.sv", "left ? second - first", "left ? first - second"},
        {0, "units/bump_rotate.sv", "frame ? $signed(d2[0*DW +: DW])",
         "1'b1 ? $signed(d2[0*DW +: DW])"},
        {0, "units/bump.sv", ".in_data(as_map_normal)", ".in_data(~as_map_normal)"},
        {1, "units/bump_slopes.sv", "twice_u <= at_side;", "twice_u <= at_side & ~at_end;"},
        {1, "units/bump_slopes.sv", "j[0] ? rise_v + wide : -wide", "j[0] ? rise_v - wide : wide"},
        {1, "common/rp_scaled_vector.sv", ".OFFSET(2 - OW)", ".OFFSET(1 - OW)"},
        {2, "units/bump_sine.sv", "(TW'(QUARTER) >> 1)", "TW'(0)"},
        {2, "units/bump_sine.sv", "QUARTER - from_start : from_start", "from_start : from_start"},
        {2, "units/bump_turns.sv", "(2*NW)'(cos_a) * (2*NW)'(sin_b)", "(2*NW)'(sin_b) <<< NFRAC"},
    };
    for (const auto& m : wrong) {
        const auto model = make_unit_model("bump", profile_of("default", m.kind));
        const Mutant mutant(m.file, m.from, m.to);
        const Outcome outcome = run_verilator(*model, 20'000, mutant.root());
        EXPECT_GT(outcome.mismatches, 0U) << m.from;
    }
}

}  // namespace
}  // namespace repousse::cosim
