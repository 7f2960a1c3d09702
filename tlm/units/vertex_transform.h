#pragma once

#include "datapath/profile.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/vertex_transform_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The Transform stage in the device: datapath/units/vertex_transform.h with its timing.
class VertexTransform : public EdgePlace, public BasePlace {
public:
    VertexTransform(const sc_core::sc_module_name& name, const Profile& profile);

    /// Screen positions are not wanted in this frame.
    void disable();

    void configure(const ViewRegisters<Fixed>& camera);
    void reset() { unit_.reset(); }
    const VertexTransformCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;
    void process_base(Triangle<Fixed>& triangle, BatchTime& time) override;

    repousse::VertexTransform<Fixed> unit_;
};

}  // namespace repousse::shell
