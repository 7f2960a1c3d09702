// The units' RTL against their datapaths: random, exhaustive, in Icarus, and with engines
// that are wrong on purpose, which must be found.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "datapath/units/grid_transform.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/vector_file.h"
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

std::unique_ptr<UnitModel> model_of(const std::string& unit, const char* profile = "default") {
    return make_unit_model(unit, *shipped_profile(profile));
}

Effort effort(uint64_t vectors) {
    Effort e;
    e.vectors = vectors;
    e.stalled_percent = 50;
    return e;
}

class RtlEquivalence : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Units, RtlEquivalence,
                         testing::Values("texcoord_test", "view_test", "normal_test", "displace",
                                         "height_test", "grid_transform", "view_clip",
                                         "perspective", "strip", "shade", "normalise", "footprint",
                                         "mid_vertex"),
                         [](const auto& unit) { return unit.param; });

TEST_P(RtlEquivalence, HardCasesAndRandomOnesInVerilator) {
    const auto model = model_of(GetParam());
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(200'000), {});
    EXPECT_GE(outcome.cases, 200'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST_P(RtlEquivalence, NarrowProfile) {
    const auto model = model_of(GetParam(), "narrow");
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(50'000), {});
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
    const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 5'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, 5'000U);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
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

/// The model of grid_transform with another depth table.
std::unique_ptr<UnitModel> with_table(const char* shipped, ZTableKind kind, int index_bits) {
    Profile profile = *shipped_profile(shipped);
    profile.z_table_kind = static_cast<int>(kind);
    profile.z_table_index_bits = index_bits;
    return make_unit_model("grid_transform", profile);
}

constexpr std::pair<ZTableKind, int> kDepthTables[] = {
    {ZTableKind::Uniform, 1},  {ZTableKind::Uniform, 8},   {ZTableKind::Linear, 1},
    {ZTableKind::Linear, 8},   {ZTableKind::Quadratic, 1}, {ZTableKind::Quadratic, 3},
    {ZTableKind::Quadratic, 5}};

TEST(GridTransformRtl, AllThreeDepthTables) {
    for (const char* shipped : {"default", "narrow"}) {
        for (const auto& [kind, bits] : kDepthTables) {
            if (shipped == std::string("narrow") && bits != 8) continue;
            const auto model = with_table(shipped, kind, bits);
            const Outcome outcome =
                run_random(*model, engine_of(*model), model->hard_cases(), effort(50'000), {});
            EXPECT_EQ(outcome.mismatches, 0U)
                << shipped << ", kind " << static_cast<int>(kind) << ", " << bits
                << " index bits: " << outcome.first_mismatch;
        }
    }
}

TEST(GridTransformRtl, AllThreeDepthTablesInIcarus) {
    for (const auto& [kind, bits] :
         {std::pair{ZTableKind::Uniform, 4}, std::pair{ZTableKind::Quadratic, 3}}) {
        const auto model = with_table("default", kind, bits);
        const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 2'000, 1);
        ASSERT_TRUE(outcome.ok()) << outcome.error().message();
        EXPECT_GE(outcome->cases, 2'000U);
        EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
    }
}

TEST(GridTransformRtl, ReciprocalsOfAnyPrecision) {
    const int settings[][3] = {{2, 0, 8}, {7, 0, 24}, {12, 1, 24}, {3, 2, 16}, {9, 2, 30}};
    for (const auto& [index_bits, newton_steps, bits] : settings) {
        Profile profile = *shipped_profile("default");
        profile.reciprocal_index_bits = index_bits;
        profile.reciprocal_newton_steps = newton_steps;
        profile.reciprocal_bits = bits;
        const auto model = make_unit_model("grid_transform", profile);
        const Outcome outcome =
            run_random(*model, engine_of(*model), model->hard_cases(), effort(50'000), {});
        EXPECT_EQ(outcome.mismatches, 0U) << bits << ": " << outcome.first_mismatch;
    }
}

TEST(StripRtl, FifosOfAnyDepth) {
    // Three are full and empty all the time, and no whole row of banks; 0 is no FIFO at all.
    for (const int depth : {0, 1, 3, 8}) {
        Profile profile = *shipped_profile("default");
        profile.column_depth = depth;
        const auto model = make_unit_model("strip", profile);
        const Outcome outcome =
            run_random(*model, engine_of(*model), model->hard_cases(), effort(50'000), {});
        EXPECT_EQ(outcome.mismatches, 0U) << depth << ": " << outcome.first_mismatch;
    }
}

struct Mutation {
    const char* name;
    const char* unit;
    const char* file;
    const char* from;
    const char* to;
};

class WrongRtl : public testing::TestWithParam<Mutation> {};

INSTANTIATE_TEST_SUITE_P(
    IsFound, WrongRtl,
    testing::Values(
        Mutation{"TexcoordWantsBothEnds", "texcoord_test", "units/texcoord_test.sv",
                 "~same_as_1 & ~same_as_2", "~same_as_1 | ~same_as_2"},
        Mutation{"ViewTestIsNotStrict", "view_test", "units/view_test.sv", "distance > threshold",
                 "distance >= threshold"},
        Mutation{"NormalTestIsNotStrict", "normal_test", "units/normal_test_difference.sv",
                 "TW'(d) > threshold", "TW'(d) >= threshold"},
        Mutation{"NormalTestForgetsTheBaseNormals", "normal_test", "units/normal_test.sv",
                 "(map_space & (|base_beyond))", "(map_space & (&base_beyond))"},
        Mutation{"NormalTestRoundsItsThreshold", "normal_test", "units/normal_test.sv",
                 "BTW'(threshold) << BASE_RISE", "(BTW'(threshold) << BASE_RISE) | BTW'(1)"},
        Mutation{"DisplaceReadsAtTheTexelsCorner", "displace", "units/displace_cell.sv",
                 "bilinear ? wide - half : wide", "bilinear ? wide : wide - half"},
        Mutation{"DisplaceForgetsTheSeam", "displace", "units/displace_cell.sv",
                 "(x >= whole) ? x - whole : x", "(x >= whole) ? whole - 1 : x"},
        Mutation{"DisplaceTruncatesItsHeight", "displace", "units/displace_height.sv",
                 "(WIDE'(1) << DROPPED) >> 1", "WIDE'(0)"},
        Mutation{"DisplaceForgetsTheFourthTexel", "displace", "units/displace.sv",
                 "{1'b0, two_columns} + {1'b0, two_rows}", "{1'b0, two_columns | two_rows}"},
        Mutation{"DisplaceTakesTheHighestFromTheBackToo", "displace", "units/displace_height.sv",
                 "back ? (sum < term) : (sum > term)", "back ^ (sum < term)"},
        Mutation{"DisplaceWrapsInTheLevel", "displace", "units/displace_cell.sv",
                 "coordinate(last_index, size, wrap) >> level",
                 "coordinate(last_index, size, 1'b0) >> level"},
        Mutation{"DisplaceReadsMinimaOfTheMap", "displace", "units/displace.sv",
                 "& (beat_vertex[VW +: 4] != 4'd0)", ""},
        Mutation{"FootprintForgetsThatCChanges", "footprint", "units/footprint_step.sv",
                 "product <= PW'(u) * PW'(step_c)", "product <= PW'(u) + PW'(step_c)"},
        Mutation{"FootprintOfAnEdgeIsNoSquare", "footprint", "units/footprint.sv",
                 "side_y <= RW'(square)", "side_y <= RW'(first_y)"},
        Mutation{"FootprintRoundsItsLevelDown", "footprint", "units/footprint.sv",
                 "{longer, 1'b0} - 1'b1", "{1'b0, longer} - 1'b1"},
        Mutation{"FootprintSeesThePlaneFromTheBack", "footprint", "units/footprint.sv", "along > 0",
                 "along >= 0"},
        Mutation{"DisplaceDoesNotSaturate", "displace", "units/displace_scale.sv", "? HIGH[DW-1:0]",
                 "? ~HIGH[DW-1:0]"},
        Mutation{"DisplaceMixesVerticesUp", "displace", "units/displace.sv",
                 ".load(load[4:0]), .in_data", ".load({load[4:1], load[1]}), .in_data"},
        Mutation{"MidVertexRoundsTowardsZero", "mid_vertex", "units/mid_vertex.sv",
                 "sum = (PW+1)'(a) + (PW+1)'(b)", "sum = (PW+1)'(a) + (PW+1)'(b) + (PW+1)'(a < 0)"},
        Mutation{"MidVertexTakesTheLowerGeneration", "mid_vertex", "units/mid_vertex.sv",
                 "(generation1 > generation2)", "(generation1 < generation2)"},
        Mutation{"MidVertexMixesNormalsUp", "mid_vertex", "units/mid_vertex.sv",
                 ".unit_z(units[(3*k+2)*NW +: NW])", ".unit_z(units[(5-3*k)*NW +: NW])"},
        Mutation{"HeightTestSubtractsTooMuch", "height_test", "units/height_test.sv",
                 "(column == 2'd1) ^ (row == 2'd1)", "(column == 2'd1) | (row == 2'd1)"},
        Mutation{"HeightTestForgetsTheSeam", "height_test", "units/height_test_side.sv",
                 "periodic && period(a", "0 && period(a"},
        Mutation{"GridTransformForgetsTheClamp", "grid_transform", "units/grid_transform.sv",
                 "(w < w_min) ? w_min : w", "(w > w_min) ? w_min : w"},
        Mutation{"GridTransformLetsCExceedOne", "grid_transform", "units/grid_transform.sv",
                 "(quotient > ONE) ? ONE : quotient", "(quotient > ONE) ? quotient : quotient"},
        Mutation{"GridTransformDropsAMantissaBit", "grid_transform",
                 "units/grid_transform_octave.sv", "u0        <= top[30 -: MANTISSA]",
                 "u0        <= top[30 -: MANTISSA] & ~MANTISSA'(1)"},
        Mutation{"GridTransformTruncatesDepth", "grid_transform", "common/rp_cast.sv",
                 "wide + (WIDE'(1) <<< (SHIFT - 1))", "wide"},
        Mutation{"ReciprocalIsNotCorrected", "grid_transform", "common/rp_reciprocal.sv",
                 "(BITS+1)'(twice_remainder > divisor)", "(BITS+1)'(0)"},
        Mutation{"ViewClipIsNotStrict", "view_clip", "units/view_clip_corner.sv",
                 "right > side_reach", "right >= side_reach"},
        Mutation{"ViewClipRoundsDown", "view_clip", "units/view_clip.sv", "(-wide) <<< GAINED",
                 "-(wide - 1) <<< GAINED"},
        Mutation{"ViewClipTrustsSaturatedCorners", "view_clip", "units/view_clip_corner.sv",
                 "at_end(x) | at_end(y)", "at_end(x)"},
        Mutation{"StripForgetsTheSwap", "strip", "units/strip_command.sv",
                 "full & is_ref & (place == older)", "1'b0"},
        Mutation{"StripWindsAllTrianglesAlike", "strip", "units/strip_command.sv", "odd ^ full",
                 "odd"},
        Mutation{"StripOverfillsItsFifo", "strip", "units/strip_command.sv",
                 "to_column & (column_left != FULL)", "to_column"},
        Mutation{"StripFlushesNoFifo", "strip", "units/strip.sv", "column_count & ~{CW{flush}}",
                 "column_count"},
        Mutation{"StripReadsTheWrongRow", "strip", "common/rp_banks.sv",
                 "(NW'(b) < NW'(head_bank))", "(1'b0)"},
        Mutation{"ShadeForgetsTheLength", "shade", "units/shade.sv", "TWO - FW'(q1)",
                 "TWO + FW'(q1)"},
        Mutation{"ShadeLightsTheBack", "shade", "units/shade_light.sv", "(b2 > 0)", "(b2 != 0)"},
        Mutation{"ShadeTurnsNothing", "shade", "units/shade.sv", "two_sided & a1[CW-1]",
                 "two_sided & ~a1[CW-1]"},
        Mutation{"ShadeSeesNegativeLengthsAsLong", "shade", "common/rp_scaled_vector.sv",
                 "(of[k] ^ of[W-1])", "of[k]"},
        Mutation{"ShadeForgetsTheBend", "shade", "units/shade_power.sv",
                 "SUM'(piece[BEND-1:0]) * SUM'(arch)", "SUM'(piece[BEND-1:0]) + SUM'(arch)"},
        Mutation{"PerspectiveTakesZeroForC", "perspective", "units/perspective.sv", "(c <= 0)",
                 "(c < 0)"},
        Mutation{"PerspectiveTruncates", "perspective", "common/rp_scaled_cast.sv",
                 "(floored + WIDE'(1)) >>> 1", "floored >>> 1"},
        Mutation{"PerspectiveAlwaysHasTangents", "perspective", "units/perspective.sv",
                 "tangents & (HAS", "tangents | (HAS"},
        Mutation{"HeightTestDifferenceHasOneBitLess", "height_test",
                 "units/height_test_decision.sv", "if (d[SW]) d = -d;", "if (d[SW-1]) d = -d;"}),
    [](const auto& mutation) { return mutation.param.name; });

TEST_P(WrongRtl, InVerilator) {
    const Mutation& m = GetParam();
    const auto model = model_of(m.unit);
    const Mutant mutant(m.file, m.from, m.to);
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
    // What a person needs to find it.
    for (const char* part : {m.unit, ": transaction ", ", cycle ", ", field ", ": engine 0x",
                             ", datapath 0x", " LSB; with ", "=0x"}) {
        EXPECT_NE(outcome.first_mismatch.find(part), std::string::npos)
            << part << " is missing in: " << outcome.first_mismatch;
    }
}

TEST(WrongEngines, OfTheOtherDepthTables) {
    const struct {
        ZTableKind kind;
        const char *file, *from, *to;
    } wrong[] = {
        {ZTableKind::Quadratic, "units/grid_transform_octave.sv", "product[2*M-1 -: M]",
         "~product[2*M-1 -: M]"},
        {ZTableKind::Uniform, "units/grid_transform_uniform.sv",
         "scaled[PW-1] ? {PLACE{1'b0}} :", ""},
        {ZTableKind::Uniform, "units/grid_transform_uniform.sv", "38'(high) - 38'(low)",
         "38'(high)"},
    };
    for (const auto& m : wrong) {
        const auto model = with_table("default", m.kind, 4);
        const Mutant mutant(m.file, m.from, m.to);
        const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                           model->hard_cases(), effort(20'000), {});
        EXPECT_GT(outcome.mismatches, 0U) << m.from;
    }
}

TEST(WrongEngines, InIcarus) {
    const auto model = model_of("view_test");
    const Mutant mutant("units/view_test.sv", "distance > threshold", "distance >= threshold");
    const auto outcome = run_icarus(*model, mutant.root(), model->hard_cases(), 1'000, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GT(outcome->mismatches, 0U);
    EXPECT_NE(outcome->first_mismatch.find("field vt"), std::string::npos)
        << outcome->first_mismatch;
}

TEST(WrongEngines, AnEngineOfAnotherProfile) {
    // The engine drops 8 fraction bits, the datapath 7.
    const auto model = model_of("texcoord_test");
    Profile other = model->profile();
    other.uv.frac = 7;
    const auto judge = model->with(other);
    const Outcome outcome = run_random(*judge, engine_of(*model), {}, effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
}

TEST(WrongEngines, AUnitThatLosesTransactionsIsStuck) {
    const auto model = model_of("texcoord_test");
    const Mutant mutant("common/rp_pipe.sv", "load | (valid & ~ready)", "load");
    const Outcome outcome = run_random(*model, engine_of(*model, mutant.root()),
                                       model->hard_cases(), effort(50'000), {});
    EXPECT_GT(outcome.mismatches, 0U);
}

TEST(Engines, AMissingToolIsAnEnvironmentErrorThatNamesThePackage) {
    const auto model = model_of("texcoord_test");
    const std::string path = getenv("PATH");
    setenv("PATH", "/nonexistent", 1);
    const auto engine = build_engine(model->desc(), model->profile(), source_folder());
    const auto icarus = run_icarus(*model, source_folder(), {}, 10, 1);
    setenv("PATH", path.c_str(), 1);
    ASSERT_FALSE(engine.ok());
    EXPECT_EQ(engine.error().kind, ErrorKind::Environment);
    EXPECT_NE(engine.error().message().find("apt-get install verilator"), std::string::npos);
    ASSERT_FALSE(icarus.ok());
    EXPECT_EQ(icarus.error().kind, ErrorKind::Environment);
    EXPECT_NE(icarus.error().message().find("apt-get install iverilog"), std::string::npos);
}

TEST(Engines, AnotherUnitsEngineIsRefused) {
    const auto model = model_of("texcoord_test");
    const auto path = build_engine(model->desc(), model->profile(), source_folder());
    ASSERT_TRUE(path.ok());
    const auto engine = Engine::open(*path, model_of("view_test")->desc());
    ASSERT_FALSE(engine.ok());
    EXPECT_NE(engine.error().message().find("an engine of texcoord_test"), std::string::npos);
}

}  // namespace
}  // namespace repousse::cosim
