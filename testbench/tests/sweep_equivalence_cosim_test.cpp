// The sweep line's RTL against its datapath: hard cases and random base triangles, every command
// and every bit of every vertex; in Icarus too; and with mistakes made on purpose, which must be
// found.

#include <gtest/gtest.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "datapath/sweep_line_ports.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/sweep_line_cases.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/tests/support/mutant.h"
#include "tlm/config/profile_reader.h"

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
    e.stalled_percent = 30;
    return e;
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
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(GetParam().vectors), {});
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
        const Outcome outcome = run_random(*model, engine_of(*model), scenarios, effort(0), {});
        EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
    }
}

TEST(SweepRtl, NarrowProfile) {
    const auto model = make_unit_model("sweep_line", *shipped_profile("narrow"));
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(2'000), {});
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

struct Mistake {
    const char *name, *file, *from, *to;
};

class SweepMistakes : public testing::TestWithParam<Mistake> {};

INSTANTIATE_TEST_SUITE_P(
    Rtl, SweepMistakes,
    testing::Values(Mistake{"DragsOnlyOntoTheRow", "units/sweep_line_step.sv",
                            "edge_in_left & $signed(row_e) <= $signed(left_up)",
                            "edge_in_left & $signed(row_e) == $signed(left_up)"},
                    Mistake{"ForgetsTheOtherEdge", "units/sweep_line_halves.sv",
                            "this_half[3] | this_half[1]", "this_half[3]"},
                    Mistake{"CarriesTooLate", "units/sweep_line_adder.sv", "~other[RW+1]",
                            "~other[RW+1] & other != '0"},
                    Mistake{"PreparesTheWrongBase", "units/sweep_line_two.sv",
                            ".b(next_crosses ? slant : sweep_step)",
                            ".b(next_crosses ? sweep_step : slant)"}),
    [](const auto& mistake) { return mistake.param.name; });

TEST_P(SweepMistakes, AreFound) {
    const Mistake& m = GetParam();
    const auto model = model_of(kTwoLanes);
    const Mutant mutant(m.file, m.from, m.to);
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(2'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
    for (const char* part : {"sweep_line: transaction ", ", beat ", ", cycle ", ", field ",
                             ": engine 0x", ", datapath 0x", " LSB; with ", "determinant=0x"}) {
        EXPECT_NE(outcome.first_mismatch.find(part), std::string::npos)
            << part << " is missing in: " << outcome.first_mismatch.substr(0, 300);
    }
}

}  // namespace
}  // namespace repousse::cosim
