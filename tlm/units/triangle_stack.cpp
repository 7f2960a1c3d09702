#include "tlm/units/triangle_stack.h"

#include <algorithm>

#include "datapath/pipelines/adaptive.h"

namespace repousse::shell {

TriangleStack::TriangleStack(const sc_core::sc_module_name& name, int contexts)
    : sc_module(name),
      contexts_(static_cast<uint64_t>(contexts)),
      triangles_(kBatchTriangles),
      edges_(3 * kBatchTriangles) {}

// Values do not depend on the number of contexts, so the simulation always has enough of them to
// fill a batch; the time is that of the modelled number.
bool TriangleStack::run(const Frame& frame) {
    Contexts<Fixed> lanes(static_cast<int>(kBatchTriangles), frame.order, frame.cap);
    Children<Fixed> result;
    BatchTime time;
    // What the frame has no unit for stays 0.
    edges_.assign(edges_.size(), {});
    const auto fetch = [&](Triangle<Fixed>& place) {
        if (!frame.fetch(place)) return false;
        BatchTime base;
        base_out->put(place, base);
        time.ahead(base);
        return true;
    };
    bool fits = true;
    while (const std::size_t n = lanes.gather(triangles_, fetch)) {
        EdgeBatch batch{{triangles_.data(), n}, {edges_.data(), 3 * n}};
        time.stage(kTriangleStackDesc, n);
        out->put(batch, time);
        for (std::size_t i = 0; i < n; ++i) {
            children->tessellate(triangles_[i], &edges_[3 * i], result);
            fits = lanes.scatter(i, triangles_[i], result) && fits;
        }
        lanes.flush(frame.emit);
        busy_.add(time.busy());
        if (!frame.elapse(time.cycles(n, contexts_))) break;
        time = {};
    }
    peak_ = std::max<uint64_t>(peak_, lanes.peak());
    return fits;
}

}  // namespace repousse::shell
