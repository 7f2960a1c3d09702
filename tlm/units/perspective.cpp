#include "tlm/units/perspective.h"

namespace repousse::shell {

Perspective::Perspective(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name),
      unit_(profile),
      normalise_latency_(normalise_latency(profile.normalise_kind, profile.normal.frac)) {}

void Perspective::configure(bool tangents) { unit_.configure(tangents); }

// Normal and tangent have a normalisation each.
void Perspective::process(FineBatch& batch, BatchTime& time) {
    unit_.run(batch.vertices);
    const std::size_t n = batch.vertices.size;
    time.stage(kPerspectiveDesc, n);
    time.stage(kNormaliseDesc, n, n, normalise_latency_);
}

}  // namespace repousse::shell
