#include "tlm/units/bump.h"

namespace repousse::shell {

Bump::Bump(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      before_test("before_test", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, true); }),
      after_split("after_split", [this](EdgeBatch& b, BatchTime& t) { make_normals(b, t, false); }),
      unit_(profile) {}

void Bump::disable() {
    before_test.enable(false);
    after_split.enable(false);
    enable_base(false);
}

void Bump::configure(const MapView<Fixed>& map, bool normal_test, bool eager) {
    unit_.configure(map);
    before_test.enable(normal_test);
    after_split.enable(!normal_test);
    enable_base(true);
    eager_ = eager;
}

void Bump::make_normals(EdgeBatch& batch, BatchTime& time, bool for_test) {
    const uint64_t before = unit_.counters().items;
    unit_.run(batch.edges, for_test, eager_);
    time.stage(kBumpDesc, unit_.counters().items - before);
}

void Bump::process_base(Triangle<Fixed>& triangle, BatchTime& time) {
    for (Vertex<Fixed>& v : triangle.corners) unit_(v);
    time.stage(kBumpDesc, triangle.corners.size());
}

}  // namespace repousse::shell
