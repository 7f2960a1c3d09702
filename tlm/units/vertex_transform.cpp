#include "tlm/units/vertex_transform.h"

namespace repousse::shell {

VertexTransform::VertexTransform(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      edges("edges", [this](EdgeBatch& batch,
                            BatchTime& time) { timed(time, [&] { unit_.run(batch.edges); }); }),
      base("base",
           [this](Triangle<Fixed>& triangle, BatchTime& time) {
               timed(time, [&] {
                   for (Vertex<Fixed>& v : triangle.corners) v.screen = unit_(v.displaced);
               });
           }),
      corners("corners",
              [this](CornerBatch& batch, BatchTime& time) {
                  timed(time, [&] {
                      for (std::size_t i = 0; i < batch.vertices.size(); ++i) {
                          batch.corners[i].eye = unit_.eye(batch.vertices[i].position);
                      }
                  });
              }),
      unit_(profile) {}

void VertexTransform::disable() {
    edges.enable(false);
    base.enable(false);
}

void VertexTransform::configure(const ViewRegisters<Fixed>& camera) {
    unit_.configure(camera);
    edges.enable(true);
    base.enable(true);
}

template <class Work>
void VertexTransform::timed(BatchTime& time, Work&& work) {
    const uint64_t before = unit_.counters().items;
    work();
    time.stage(kVertexTransformDesc, unit_.counters().items - before);
}

}  // namespace repousse::shell
