#include "tlm/units/shade.h"

namespace repousse::shell {

Shade::Shade(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      edges("edges", [this](EdgeBatch& batch,
                            BatchTime& time) { timed(time, [&] { unit_.run(batch.edges); }); }),
      base("base",
           [this](Triangle<Fixed>& triangle, BatchTime& time) {
               timed(time, [&] {
                   for (Vertex<Fixed>& v : triangle.corners) unit_(v);
               });
           }),
      fine("fine", [this](FineBatch& batch,
                          BatchTime& time) { timed(time, [&] { unit_.run(batch.vertices); }); }),
      unit_(profile),
      latency_(shade_latency(profile.normalise_kind, profile.normal.frac)) {}

void Shade::configure(const ShadeRegisters<Fixed>& registers, bool bumped) {
    unit_.configure(registers, bumped);
    enable(true);
}

void Shade::enable(bool enabled) {
    edges.enable(enabled);
    base.enable(enabled);
    fine.enable(enabled);
}

template <class Work>
void Shade::timed(BatchTime& time, Work&& work) {
    const uint64_t before = unit_.counters().items;
    work();
    const uint64_t items = unit_.counters().items - before;
    time.stage(kShadeDesc, items, items, latency_);
}

}  // namespace repousse::shell
