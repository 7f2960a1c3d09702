#include "tlm/units/vertex_transform.h"

namespace repousse::shell {

VertexTransform::VertexTransform(const sc_core::sc_module_name& name, const Profile& profile)
    : EdgePlace(name), unit_(profile) {}

void VertexTransform::disable() {
    enable(false);
    enable_base(false);
}

void VertexTransform::configure(const ViewRegisters<Fixed>& camera) {
    unit_.configure(camera);
    enable(true);
    enable_base(true);
}

void VertexTransform::process(EdgeBatch& batch, BatchTime& time) {
    const uint64_t before = unit_.counters().items;
    unit_.run(batch.edges);
    time.stage(kVertexTransformDesc, unit_.counters().items - before);
}

void VertexTransform::process_base(Triangle<Fixed>& triangle, BatchTime& time) {
    for (Vertex<Fixed>& v : triangle.corners) v.screen = unit_(v.displaced);
    time.stage(kVertexTransformDesc, triangle.corners.size());
}

}  // namespace repousse::shell
