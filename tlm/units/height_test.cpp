#include "tlm/units/height_test.h"

namespace repousse::shell {

HeightTest::HeightTest(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

Status HeightTest::configure(const HeightTestRegisters& registers, Span<const uint64_t> table,
                             bool eager) {
    const Status status = unit_.check(registers, table.size());
    if (!status) return status;
    unit_.configure(registers, table);
    eager_ = eager;
    return done();
}

void HeightTest::process(EdgeBatch& batch, BatchTime& time) {
    const uint64_t reads_before = unit_.stats().reads;
    unit_.run(batch.edges, eager_);
    // Three boxes are read side by side; a skipped edge passes in one cycle.
    const uint64_t reads = unit_.stats().reads - reads_before;
    time.stage(kHeightTestDesc, batch.edges.size(), batch.edges.size() + reads / 3);
}

}  // namespace repousse::shell
