#include "tlm/units/bump.h"

namespace repousse::shell {

Bump::Bump(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      before_test("before_test", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, true); }),
      after_split("after_split", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, false); }),
      base("base", [this](Triangle<Fixed>& b, BatchTime& t) { make_all(b.corners, t); }),
      fine("fine", [this](FineBatch& b, BatchTime& t) { make_all(b.vertices, t); }),
      unit_(profile) {}

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
    time.stage(kBumpDesc, unit_.counters().items - before);
}

template <class Vertices>
void Bump::make_all(Vertices& vertices, BatchTime& time) {
    for (auto& v : vertices) unit_(v);
    time.stage(kBumpDesc, vertices.size());
}

}  // namespace repousse::shell
