#include "tlm/units/triangle_setup.h"

#include "datapath/pipelines/sweep.h"

namespace repousse::shell {

// Rounding is in the latency of the triangle that brings the vertex.
TriangleSetup::TriangleSetup(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      slots("slots", [this](CornerBatch& b, BatchTime&) { round(b); }),
      triangles("triangles", [this](BaseBatch& b, BatchTime& t) { set_up(b, t); }),
      unit_(setup_options(profile, true)),
      dividers_(static_cast<uint64_t>(profile.dividers)) {}

void TriangleSetup::configure(const TriangleSetupRegisters& registers, int components,
                              bool footprints) {
    unit_.configure(registers);
    unit_.use_footprints(footprints);
    unit_.use_components(components);
}

void TriangleSetup::round(CornerBatch& batch) {
    for (GridVertex& v : batch.corners) v.corner.slot = unit_.slot(v.point.position);
}

// A triangle needs its divisions, of a component of three edges and two gradients each, from the
// dividers that there are.
void TriangleSetup::set_up(BaseBatch& batch, BatchTime& time) {
    uint64_t count = 0;
    for (std::size_t i = 0; i < batch.items.size(); ++i) {
        const BaseItem& item = batch.items[i];
        if (item.rejected) continue;
        const auto& [a, b, c] = item.corners;
        unit_({a->corner, b->corner, c->corner}, batch.triangles[i]);
        ++count;
    }
    const auto components = static_cast<uint64_t>(unit_.options().components);
    const uint64_t interval = (5 * components + dividers_ - 1) / dividers_;
    time.stage(kTriangleSetupDesc, count, count * interval);
}

}  // namespace repousse::shell
