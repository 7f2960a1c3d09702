// The RTL of bump, all three kinds: random and hard vertices, all of a tiny profile, Icarus, the
// other normalisation, other tables of sines, the cycles that each takes, and mutants that must be
// found.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "datapath/units/bump_desc.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/tests/support/mutant.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

Engine engine_of(const UnitModel& model, const fs::path& root = source_folder()) {
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
        const Outcome outcome =
            run_random(*model, engine_of(*model), model->hard_cases(), effort(100'000), {});
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
    const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 1'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, 1'000U);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
}

TEST_P(BumpRtl, NormalisedByCordic) {
    Profile profile = profile_of("default", GetParam());
    profile.normalise_kind = 1;
    const auto model = make_unit_model("bump", profile);
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(20'000), {});
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
        std::vector<int64_t> in(model->inputs() * kCount, 100), out(model->outputs() * kCount);
        std::vector<uint64_t> accept(kCount), depart(kCount);
        RepousseBatch batch = plain_batch(kCount, in.data(), out.data());
        batch.accept = accept.data();
        batch.depart = depart.data();
        ASSERT_EQ(instance.run(batch), kRepousseDone);
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
    std::vector<int64_t> in(model->inputs() * count, 100), out(model->outputs() * count);
    std::vector<uint64_t> accept(count), ready(count, instance.cycle() + 1000);
    RepousseBatch batch = plain_batch(count, in.data(), out.data());
    batch.accept = accept.data();
    batch.ready = ready.data();
    ASSERT_EQ(instance.run(batch), kRepousseDone);
    EXPECT_LT(accept[capacity - 1], ready[0]);
    EXPECT_GE(accept[capacity], ready[0] + static_cast<uint64_t>(desc.backward_latency));
}

TEST(BumpRtlSines, TablesOfAnySize) {
    for (const auto& [index_bits, width, frac] : {std::array{2, 16, 15}, std::array{10, 16, 16},
                                                  std::array{3, 9, 7}, std::array{8, 5, 1}}) {
        Profile profile = profile_of("default", 2);
        profile.sine_index_bits = index_bits;
        profile.angle.width = width, profile.angle.frac = frac;
        const auto model = make_unit_model("bump", profile);
        const Outcome outcome =
            run_random(*model, engine_of(*model), model->hard_cases(), effort(20'000), {});
        EXPECT_EQ(outcome.mismatches, 0U) << index_bits << ": " << outcome.first_mismatch;
    }
}

TEST(BumpMutants, AreFound) {
    const struct {
        int kind;
        const char *file, *from, *to;
    } wrong[] = {
        {0, "units/bump_place.sv", "(x >= whole) ? x - whole : x", "(x >= whole) ? whole - 1 : x"},
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
        const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                           model->hard_cases(), effort(20'000), {});
        EXPECT_GT(outcome.mismatches, 0U) << m.from;
    }
}

}  // namespace
}  // namespace repousse::cosim
