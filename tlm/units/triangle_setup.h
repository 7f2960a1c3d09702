#pragma once

#include "datapath/profile.h"
#include "datapath/units/triangle_setup.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// Base triangle setup in the device: datapath/units/triangle_setup.h with its timing. `slots`
/// rounds base vertices to the grid, `triangles` does the rest for base triangles that were not
/// clipped.
class TriangleSetup : public sc_core::sc_module {
public:
    TriangleSetup(const sc_core::sc_module_name& name, const Profile& profile);

    /// `components` of a vertex are in use; `footprints`: so are the steps of texture coordinates.
    void configure(const TriangleSetupRegisters& registers, int components, bool footprints);
    void reset() { unit_.reset(); }
    const TriangleSetupCounters& counters() const { return unit_.counters(); }

    CornerCall slots;
    Call<BaseBatch> triangles;

private:
    void round(CornerBatch& batch);
    void set_up(BaseBatch& batch, BatchTime& time);

    repousse::TriangleSetup unit_;
    uint64_t dividers_;
};

}  // namespace repousse::shell
