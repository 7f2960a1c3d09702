// The RTL of grid_transform with depth tables and reciprocals other than the shipped profiles'.
// All else of its RTL is in rtl_equivalence_cosim_test and rtl_timing_cosim_test.

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "datapath/units/grid_transform.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"

namespace repousse::cosim {
namespace {

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
            const Outcome outcome = run_verilator(*model, 50'000);
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
        expect_equal_in_icarus(*model, 2'000);
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
        const Outcome outcome = run_verilator(*model, 50'000);
        EXPECT_EQ(outcome.mismatches, 0U) << bits << ": " << outcome.first_mismatch;
    }
}

TEST(GridTransformRtl, WrongDepthTablesAreFound) {
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
        const Outcome outcome = run_verilator(*model, 20'000, mutant.root());
        EXPECT_GT(outcome.mismatches, 0U) << m.from;
    }
}

}  // namespace
}  // namespace repousse::cosim
