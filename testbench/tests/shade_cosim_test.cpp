// The RTL of shade with the other normalisation within it: values and cycles. All else of its RTL
// is in rtl_equivalence_cosim_test and rtl_timing_cosim_test.

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "datapath/units/shade_desc.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/unit_model.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

Engine engine_of(const UnitModel& model) {
    const auto path = build_engine(model.desc(), model.profile(), source_folder());
    if (!path) throw std::runtime_error(path.error().message());
    auto engine = Engine::open(*path, model.desc(), model.profile());
    if (!engine) throw std::runtime_error(engine.error().message());
    return *engine;
}

std::unique_ptr<UnitModel> with_cordic(const char* shipped) {
    Profile profile = *shipped_profile(shipped);
    profile.normalise_kind = 1;
    return make_unit_model("shade", profile);
}

TEST(ShadeRtlWithCordic, HardCasesAndRandomOnes) {
    for (const char* shipped : {"default", "narrow"}) {
        const auto model = with_cordic(shipped);
        Effort effort;
        effort.vectors = 50'000;
        effort.stalled_percent = 50;
        const Outcome outcome =
            run_random(*model, engine_of(*model), model->hard_cases(), effort, {});
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
    std::vector<int64_t> in(6 * kCount, 1000), out(3 * kCount);
    std::vector<uint64_t> accept(kCount), depart(kCount);
    RepousseBatch batch = plain_batch(kCount, in.data(), out.data());
    batch.accept = accept.data();
    batch.depart = depart.data();
    ASSERT_EQ(instance.run(batch), kRepousseDone);
    for (std::size_t i = 0; i < kCount; ++i) {
        ASSERT_EQ(depart[i] - accept[i], latency) << i;
        ASSERT_EQ(accept[i] - accept[0], i);
    }
}

}  // namespace
}  // namespace repousse::cosim
