// Engines that are wrong on purpose are found, and those that cannot be had are errors.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <string>

#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"

namespace repousse::cosim {
namespace {

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
                 "bilinear ? wide - (one >>> 1) : wide", "bilinear ? wide : wide - (one >>> 1)"},
        Mutation{"DisplaceForgetsTheSeam", "displace", "common/rp_map_coordinate.sv",
                 "wrap ? raised - whole : whole - 1", "whole - 1"},
        Mutation{"DisplaceTruncatesItsHeight", "displace", "units/displace_height.sv",
                 "(WIDE'(1) << DROPPED) >> 1", "WIDE'(0)"},
        Mutation{"DisplaceForgetsTheFourthTexel", "displace", "units/displace.sv",
                 "5'(columns) * 5'(rows)", "5'(columns) + 5'(rows) - 5'd1"},
        Mutation{"DisplaceEndsARowLate", "displace", "units/displace.sv", "beat_j >= four_rows",
                 "beat_j > four_rows"},
        Mutation{"DisplaceForgetsAQuarterPlace", "displace", "units/displace_cell.sv",
                 "{1'b1, finer[1], |finer, finer[1], 1'b1}",
                 "{1'b1, finer[1], |finer, 1'b0, 1'b1}"},
        Mutation{"DisplaceReadsFinerAveragesToo", "displace", "units/displace_cell.sv",
                 "looked = maximum ? finest", "looked = (maximum | average) ? finest"},
        Mutation{"DisplaceTakesTheHighestFromTheBackToo", "displace", "units/displace_height.sv",
                 "back ? (sum < term) : (sum > term)", "back ^ (sum < term)"},
        Mutation{"DisplaceWrapsInTheLevel", "displace", "units/displace_cell.sv",
                 ".wrap(wrap), .at(at)", ".wrap(wrap & ~levels), .at(at)"},
        Mutation{"DisplaceReadsMinimaOfTheMap", "displace", "units/displace.sv",
                 "& (beat_vertex[VW +: 4] != 4'd0)", ""},
        Mutation{"FootprintForgetsThatCChanges", "footprint", "units/footprint_step.sv",
                 "product <= PW'(u) * PW'(step_c)", "product <= PW'(u) + PW'(step_c)"},
        Mutation{"FootprintOfAnEdgeIsNoSquare", "footprint", "units/footprint.sv",
                 "side_y <= RW'(square)", "side_y <= RW'(first_y)"},
        Mutation{"FootprintRoundsItsLevelDown", "footprint", "units/footprint.sv",
                 "{longer, 1'b0} - 1'b1", "{1'b0, longer} - 1'b1"},
        Mutation{"FootprintForgetsThatLevelsEnd", "footprint", "units/footprint.sv",
                 "(coarse > 6'(finer)) ? coarse - 6'(finer) : 6'd0", "coarse - 6'(finer)"},
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
    const Mutant mutant(m);
    const Outcome outcome = run_verilator(*model, 50'000, mutant.root());
    EXPECT_GT(outcome.mismatches, 0U);
    // What a person needs to find it.
    for (const char* part : {m.unit, ": transaction ", ", cycle ", ", field ", ": engine 0x",
                             ", datapath 0x", " LSB; with ", "=0x"}) {
        EXPECT_NE(outcome.first_mismatch.find(part), std::string::npos)
            << part << " is missing in: " << outcome.first_mismatch;
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
    const Outcome outcome = run_verilator(*model, 50'000, mutant.root());
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
