// The RTL of shade with the other normalisation within it: values and cycles. All else of its RTL
// is in rtl_equivalence_cosim_test and rtl_timing_cosim_test.

#include <gtest/gtest.h>

#include <vector>

#include "datapath/units/shade_desc.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

std::unique_ptr<UnitModel> with_cordic(const char* shipped) {
    Profile profile = *shipped_profile(shipped);
    profile.normalise_kind = 1;
    return make_unit_model("shade", profile);
}

TEST(ShadeRtlWithCordic, HardCasesAndRandomOnes) {
    for (const char* shipped : {"default", "narrow"}) {
        const auto model = with_cordic(shipped);
        const Outcome outcome = run_verilator(*model, 50'000);
        EXPECT_GE(outcome.cases, 50'000U);
        EXPECT_EQ(outcome.mismatches, 0U) << shipped << ": " << outcome.first_mismatch;
    }
}

TEST(ShadeRtlWithCordic, TakesItsLatencyAndAVertexACycle) {
    const auto model = with_cordic("default");
    EngineInstance instance(engine_of(*model));
    instance.configure(model->hard_cases()[0].config, nullptr, 1);
    const auto latency = static_cast<uint64_t>(shade_latency(1, model->profile().normal.frac));
    EXPECT_EQ(latency, 76U);
    constexpr std::size_t kCount = 200;
    const std::vector<int64_t> in(6 * kCount, 1000);
    const auto [out, accept, depart] = pass(instance, *model, in);
    for (std::size_t i = 0; i < kCount; ++i) {
        ASSERT_EQ(depart[i] - accept[i], latency) << i;
        ASSERT_EQ(accept[i] - accept[0], i);
    }
}

}  // namespace
}  // namespace repousse::cosim
