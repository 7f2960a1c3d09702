// The sweep line's RTL against its datapath: hard cases and random base triangles, every command
// and every bit of every vertex; in Icarus too; and with mistakes made on purpose, which must be
// found.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "datapath/sweep_line_ports.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/sweep_line_cases.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"

namespace repousse::cosim {
namespace {

/// What a profile may choose.
struct Build {
    const char* name;
    int adder_kind, guard_bits, column_depth, components;
    uint64_t vectors;
};

constexpr Build kTwoLanes = {"TwoLanes", 2, 0, 256, 1, 40'000};
constexpr Build kOneLane = {"OneLane", 2, 0, 0, 1, 20'000};

std::unique_ptr<UnitModel> model_of(const Build& build) {
    Profile profile = *shipped_profile("default");
    profile.adder_kind = build.adder_kind;
    profile.guard_bits = build.guard_bits;
    profile.column_depth = build.column_depth;
    profile.components = build.components;
    return make_unit_model("sweep_line", profile);
}

/// As run_verilator(), with fewer of the batches stalled.
Outcome run(const UnitModel& model, uint64_t vectors,
            const std::filesystem::path& root = source_folder()) {
    return run_random(model, engine_of(model, root), model.hard_cases(), effort(vectors, 30), {});
}

class SweepEquivalence : public testing::TestWithParam<Build> {};

INSTANTIATE_TEST_SUITE_P(Builds, SweepEquivalence,
                         testing::Values(Build{"Default", 2, 0, 256, 13, 4'000}, kTwoLanes,
                                         kOneLane, Build{"ColumnFifoOfThree", 2, 0, 3, 2, 10'000},
                                         Build{"PlainInOneLane", 0, 5, 0, 2, 4'000},
                                         Build{"CanonicalInTwoLanes", 1, 13, 16, 2, 8'000}),
                         [](const auto& build) { return build.param.name; });

TEST_P(SweepEquivalence, HardCasesAndRandomOnesInVerilator) {
    const auto model = model_of(GetParam());
    const Outcome outcome = run(*model, GetParam().vectors);
    EXPECT_GE(outcome.cases, GetParam().vectors);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    std::printf("%s: %llu base triangles, %.0f a second\n", GetParam().name,
                static_cast<unsigned long long>(outcome.cases),
                static_cast<double>(outcome.cases) / outcome.seconds);
}

TEST(SweepRtl, SliversAcrossTheWholeGrid) {
    for (const Build& build : {kTwoLanes, kOneLane}) {
        const auto model = model_of(build);
        Random random(3);
        TriangleSetup setup({AdderKind::Exact, 0, 1});
        std::vector<Scenario> scenarios;
        for (int n = 0; n < 24; ++n) {
            std::array<SweepCorner, 3> corners;
            const GridCorners grid = random_far_sliver(random);
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i].id = static_cast<uint32_t>(i);
                corners[i].slot = grid[i];
                corners[i].data.fill(static_cast<int32_t>(random.next()));
            }
            SweepLineIn in;
            setup(corners, in.triangle);
            scenarios.push_back({"far sliver", {0}, nullptr, in.pack(model->profile())});
        }
        const Outcome outcome = run_random(*model, engine_of(*model), scenarios, effort(0, 30), {});
        EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    }
}

TEST(SweepRtl, NarrowProfile) {
    const auto model = cosim::model_of("sweep_line", "narrow");
    const Outcome outcome = run(*model, 2'000);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST(SweepRtl, HardCasesAndRandomOnesInIcarus) {
    for (const Build& build : {kTwoLanes, kOneLane}) {
        const auto model = model_of(build);
        const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 100, 1);
        ASSERT_TRUE(outcome.ok()) << outcome.error().message();
        EXPECT_GE(outcome->cases, 140U);
        EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
    }
}

class SweepMistakes : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    Rtl, SweepMistakes,
    testing::Values(Mutation{"DragsOnlyOntoTheRow", "sweep_line", "units/sweep_line_step.sv",
                             "edge_in_left & $signed(row_e) <= $signed(left_up)",
                             "edge_in_left & $signed(row_e) == $signed(left_up)"},
                    Mutation{"ForgetsTheOtherEdge", "sweep_line", "units/sweep_line_halves.sv",
                             "this_half[3] | this_half[1]", "this_half[3]"},
                    Mutation{"CarriesTooLate", "sweep_line", "units/sweep_line_adder.sv",
                             "~other[RW+1]", "~other[RW+1] & other != '0"},
                    Mutation{"PreparesTheWrongBase", "sweep_line", "units/sweep_line_two.sv",
                             ".b(next_crosses ? slant : sweep_step)",
                             ".b(next_crosses ? sweep_step : slant)"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST_P(SweepMistakes, AreFound) {
    const Mutation& m = GetParam();
    const auto model = model_of(kTwoLanes);
    const Mutant mutant(m);
    const Outcome outcome = run(*model, 2'000, mutant.root());
    EXPECT_GT(outcome.mismatches, 0U);
    for (const char* part : {"sweep_line: transaction ", ", beat ", ", cycle ", ", field ",
                             ": engine 0x", ", datapath 0x", " LSB; with ", "determinant=0x"}) {
        EXPECT_NE(outcome.first_mismatch.find(part), std::string::npos)
            << part << " is missing in: " << outcome.first_mismatch.substr(0, 300);
    }
}

}  // namespace
}  // namespace repousse::cosim
