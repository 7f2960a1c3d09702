#include "tlm/units/bump.h"

namespace repousse::shell {

Bump::Bump(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      before_test("before_test", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, true); }),
      after_split("after_split", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, false); }),
      base("base", [this](Triangle<Fixed>& b, BatchTime& t) { make_all(b.corners, t); }),
      fine("fine",
           [this](FineBatch& b, BatchTime& t) {
               unit_.run(b.vertices);
               add_time(t, b.vertices.size);
           }),
      unit_(profile),
      interval_(bump_interval(profile.bump_kind)),
      latency_(
          bump_latency(profile.bump_kind, profile.normalise_kind, profile.displaced_normal.frac)) {}

void Bump::disable() {
    before_test.enable(false);
    after_split.enable(false);
    base.enable(false);
    fine.enable(false);
}

void Bump::configure(const MapView<Fixed>& map, bool normal_test, bool eager) {
    unit_.configure(map);
    before_test.enable(normal_test);
    after_split.enable(!normal_test);
    base.enable(true);
    fine.enable(true);
    eager_ = eager;
}

void Bump::make_normals(EdgeBatch& batch, BatchTime& time, bool for_test) {
    const uint64_t before = unit_.counters().items;
    unit_.run(batch.edges, for_test, eager_);
    add_time(time, unit_.counters().items - before);
}

void Bump::add_time(BatchTime& time, uint64_t made) const {
    time.stage(kBumpDesc, made, made * static_cast<uint64_t>(interval_), latency_);
}

template <class Vertices>
void Bump::make_all(Vertices& vertices, BatchTime& time) {
    for (auto& v : vertices) unit_(v);
    add_time(time, vertices.size());
}

}  // namespace repousse::shell
