#include "tlm/units/displace.h"

namespace repousse::shell {

Displace::Displace(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      edges("edges", [this](EdgeBatch& batch,
                            BatchTime& time) { timed(time, [&] { unit_.run(batch.edges); }); }),
      base("base",
           [this](Triangle<Fixed>& triangle, BatchTime& time) {
               timed(time, [&] {
                   for (Vertex<Fixed>& v : triangle.corners) {
                       v.displaced = unit_(v.position, v.normal, v.uv);
                   }
               });
           }),
      fine("fine", [this](FineBatch& batch,
                          BatchTime& time) { timed(time, [&] { unit_.run(batch.vertices); }); }),
      unit_(profile) {}

template <class Work>
void Displace::timed(BatchTime& time, Work&& work) {
    const DisplaceCounters before = unit_.counters();
    work();
    const DisplaceCounters& after = unit_.counters();
    time.stage(kDisplaceDesc, after.items - before.items, after.reads - before.reads);
}

}  // namespace repousse::shell
