#include "tlm/units/mid_vertex.h"

namespace repousse::shell {

// Topology is one adder, which the attributes' latency covers.
MidVertex::MidVertex(const sc_core::sc_module_name& name, const Profile& profile)
    : sc_module(name),
      topology("topology", [this](EdgeBatch& b, BatchTime&) { unit_.run_topology(b.edges); }),
      before_test("before_test",
                  [this](EdgeBatch& b, BatchTime& t) { make_attributes(b, t, true); }),
      after_split("after_split",
                  [this](EdgeBatch& b, BatchTime& t) { make_attributes(b, t, false); }),
      unit_(profile),
      latency_(mid_vertex_latency(profile.normalise_kind, profile.normal.frac)) {}

void MidVertex::configure(bool normal_test, bool eager) {
    before_test.enable(normal_test);
    after_split.enable(!normal_test);
    eager_ = eager;
}

void MidVertex::make_attributes(EdgeBatch& batch, BatchTime& time, bool for_test) {
    const uint64_t before = unit_.counters().attributes;
    unit_.run_attributes(batch.edges, for_test, eager_);
    const uint64_t made = unit_.counters().attributes - before;
    time.stage(kMidVertexDesc, made, made, latency_);
}

}  // namespace repousse::shell
