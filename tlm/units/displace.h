#pragma once

#include "datapath/profile.h"
#include "datapath/units/displace.h"
#include "datapath/units/displace_desc.h"
#include "tlm/edge_stage.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// Displace Vertex in the device: datapath/units/displace.h with its timing. It reads the map
/// through a port of its own, one texel a cycle. Its places are `edges` and `base` in adaptive
/// tessellation and `fine` in sweep-line remeshing.
class Displace : public sc_core::sc_module {
public:
    Displace(const sc_core::sc_module_name& name, const Profile& profile);

    /// The map's tables must outlive the frame.
    void configure(const MapView<Fixed>& map) { unit_.configure(map); }
    void reset() { unit_.reset(); }
    const DisplaceCounters& counters() const { return unit_.counters(); }

    EdgeCall edges;
    BaseCall base;
    FineCall fine;

private:
    template <class Work>
    void timed(BatchTime& time, Work&& work);

    repousse::Displace<Fixed> unit_;
};

}  // namespace repousse::shell
