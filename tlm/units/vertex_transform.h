#pragma once

#include "datapath/profile.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/vertex_transform_desc.h"
#include "tlm/edge_stage.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The Transform stage in the device: datapath/units/vertex_transform.h with its timing. Its places
/// are `edges` and `base` in adaptive tessellation and `corners`, as far as eye space, in
/// sweep-line remeshing.
class VertexTransform : public sc_core::sc_module {
public:
    VertexTransform(const sc_core::sc_module_name& name, const Profile& profile);

    /// Screen positions are not wanted in this frame.
    void disable();

    void configure(const ViewRegisters<Fixed>& camera);
    void reset() { unit_.reset(); }
    const VertexTransformCounters& counters() const { return unit_.counters(); }

    EdgeCall edges;
    BaseCall base;
    CornerCall corners;

private:
    template <class Work>
    void timed(BatchTime& time, Work&& work);

    repousse::VertexTransform<Fixed> unit_;
};

}  // namespace repousse::shell
