#pragma once

#include "datapath/profile.h"
#include "datapath/units/shade.h"
#include "datapath/units/shade_desc.h"
#include "tlm/edge_stage.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The illumination unit in the device: datapath/units/shade.h with its timing. It stands behind
/// `displace` and `bump`: in adaptive tessellation `edges` colours the new vertices of split edges
/// and `base` the corners of base triangles, in sweep-line remeshing `fine` the vertices of the
/// fine mesh.
class Shade : public sc_core::sc_module {
public:
    Shade(const sc_core::sc_module_name& name, const Profile& profile);

    /// Colours are not wanted in this frame.
    void disable() { enable(false); }

    /// `bumped`: vertices have N', and it is N' that is lit.
    void configure(const ShadeRegisters<Fixed>& registers, bool bumped);
    void reset() { unit_.reset(); }
    const ShadeCounters& counters() const { return unit_.counters(); }

    EdgeCall edges;
    BaseCall base;
    FineCall fine;

private:
    void enable(bool enabled);
    template <class Work>
    void timed(BatchTime& time, Work&& work);

    repousse::Shade<Fixed> unit_;
    int latency_;  // with the profile's normalisation
};

}  // namespace repousse::shell
