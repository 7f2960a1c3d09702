#pragma once

#include "datapath/profile.h"
#include "datapath/units/grid_transform.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The vertex-grid transform lookup in the device: datapath/units/grid_transform.h with its timing.
/// Its lanes multiply all components of a vertex at once.
class GridTransform : public Place<CornerBatch> {
public:
    GridTransform(const sc_core::sc_module_name& name, const Profile& profile);

    /// The registers' table must outlive the frame. `tangents`: vertices carry them.
    void configure(const GridRegisters<Fixed>& registers, bool tangents);
    void reset() { unit_.reset(); }
    const GridTransformCounters& counters() const { return unit_.counters(); }

private:
    void process(CornerBatch& batch, BatchTime& time) override;

    repousse::GridTransform<Fixed> unit_;
    bool tangents_ = false;
};

}  // namespace repousse::shell
