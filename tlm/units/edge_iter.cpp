#include "tlm/units/edge_iter.h"

namespace repousse::shell {

void EdgeIter::process(EdgeBatch& batch, BatchTime& time) {
    unit_.run(batch.triangles, batch.edges);
    time.stage(kEdgeIterDesc, batch.triangles.size());
}

}  // namespace repousse::shell
