#include "tlm/units/split.h"

namespace repousse::shell {

Split::Split(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {
    children.bind(*this);
}

void Split::process(EdgeBatch& batch, BatchTime& time) {
    unit_.decide(batch.edges);
    // A child a cycle: the triangle itself, or one more than it has split edges.
    uint64_t cycles = batch.triangles.size();
    for (const Edge<Fixed>& edge : batch.edges) cycles += edge.split;
    time.stage(kSplitDesc, batch.triangles.size(), cycles);
}

}  // namespace repousse::shell
