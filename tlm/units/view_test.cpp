#include "tlm/units/view_test.h"

namespace repousse::shell {

ViewTest::ViewTest(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

void ViewTest::configure(int64_t threshold, bool eager) {
    unit_.configure(threshold);
    eager_ = eager;
}

void ViewTest::process(EdgeBatch& batch, BatchTime& time) {
    unit_.run(batch.edges, eager_);
    time.stage(kViewTestDesc, batch.edges.size());
}

}  // namespace repousse::shell
