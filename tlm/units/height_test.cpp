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
    const uint64_t beats = unit_.stats().beats;
    const uint64_t tests = unit_.counters().tests;
    unit_.run(batch.edges, eager_);
    // A tested edge takes a cycle for each beat of its reads, a skipped one passes in one cycle.
    const uint64_t skipped = batch.edges.size() - (unit_.counters().tests - tests);
    time.stage(kHeightTestDesc, batch.edges.size(), unit_.stats().beats - beats + skipped);
}

}  // namespace repousse::shell
