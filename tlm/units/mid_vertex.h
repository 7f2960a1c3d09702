#pragma once

#include "datapath/profile.h"
#include "datapath/units/mid_vertex.h"
#include "datapath/units/mid_vertex_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// Calculate New U, P and N in the device: datapath/units/mid_vertex.h with its timing. It stands
/// in the chain three times: `topology` ahead of the cheap tests; the other attributes either
/// `before_test`, for the edges that reach the normal test, or, in a frame without that test,
/// `after_split`, for the edges that are split.
class MidVertex : public sc_core::sc_module {
public:
    MidVertex(const sc_core::sc_module_name& name, const Profile& profile);

    /// `normal_test`: the frame uses the normal test.
    void configure(bool normal_test, bool eager);
    void reset() { unit_.reset(); }
    const MidVertexCounters& counters() const { return unit_.counters(); }

    EdgeCall topology;
    EdgeCall before_test;
    EdgeCall after_split;

private:
    void make_attributes(EdgeBatch& batch, BatchTime& time, bool for_test);

    repousse::MidVertex<Fixed> unit_;
    int latency_;  // of the profile's normalisation
    bool eager_ = false;
};

}  // namespace repousse::shell
