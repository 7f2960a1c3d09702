#include "tlm/units/displace.h"

namespace repousse::shell {

Displace::Displace(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

void Displace::process(EdgeBatch& batch, BatchTime& time) {
    const DisplaceCounters before = unit_.counters();
    unit_.run(batch.edges);
    const DisplaceCounters& after = unit_.counters();
    time.stage(kDisplaceDesc, after.items - before.items, after.reads - before.reads);
}

void Displace::process_base(Triangle<Fixed>& triangle, BatchTime& time) {
    const uint64_t reads = unit_.counters().reads;
    for (Vertex<Fixed>& v : triangle.corners) v.displaced = unit_(v.position, v.normal, v.uv);
    time.stage(kDisplaceDesc, triangle.corners.size(), unit_.counters().reads - reads);
}

}  // namespace repousse::shell
