#include "tlm/units/perspective.h"

namespace repousse::shell {

Perspective::Perspective(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name),
      unit_(profile),
      normalise_latency_(normalise_latency(profile.normalise_kind, profile.normal.frac)) {}

void Perspective::configure(bool tangents) { unit_.configure(tangents); }

// Normal and tangent have a normalisation each.
void Perspective::process(FineBatch& batch, BatchTime& time) {
    FineVertex<Fixed>* next = batch.vertices.begin();
    for (const SweepStep& step : batch.steps) {
        for (std::size_t i = 0; i < step.vertex_count; ++i) unit_(step.vertices[i], *next++);
    }
    time.stage(kPerspectiveDesc, batch.vertices.size());
    time.stage(kNormaliseDesc, batch.vertices.size(), batch.vertices.size(), normalise_latency_);
}

}  // namespace repousse::shell
