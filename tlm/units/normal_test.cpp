#include "tlm/units/normal_test.h"

namespace repousse::shell {

NormalTest::NormalTest(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

void NormalTest::configure(int32_t threshold, NormalSpace space, bool eager) {
    unit_.configure(threshold, space);
    eager_ = eager;
}

void NormalTest::process(EdgeBatch& batch, BatchTime& time) {
    unit_.run(batch.edges, eager_);
    time.stage(kNormalTestDesc, batch.edges.size());
}

}  // namespace repousse::shell
