#include "tlm/units/texcoord_test.h"

namespace repousse::shell {

TexcoordTest::TexcoordTest(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

void TexcoordTest::process(EdgeBatch& batch, BatchTime& time) {
    unit_.run(batch.edges, eager_);
    // Skipped edges pass through the unit as well.
    time.stage(kTexcoordTestDesc, batch.edges.size());
}

}  // namespace repousse::shell
