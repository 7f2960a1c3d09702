#include "tlm/units/split.h"

namespace repousse::shell {

Split::Split(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {
    children.bind(*this);
}

void Split::process(EdgeBatch& batch, BatchTime& time) {
    unit_.decide(batch.edges);
    time.stage(kSplitDesc, batch.triangles.size());
}

}  // namespace repousse::shell
