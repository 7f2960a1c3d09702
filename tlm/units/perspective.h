#pragma once

#include "datapath/profile.h"
#include "datapath/units/perspective.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// Perspective correction in the device: datapath/units/perspective.h, with the normalisation
/// behind it, and their timing.
class Perspective : public Place<FineBatch> {
public:
    Perspective(const sc_core::sc_module_name& name, const Profile& profile);

    /// `tangents`: vertices carry them.
    void configure(bool tangents);
    void reset() { unit_.reset(); }
    const PerspectiveCounters& counters() const { return unit_.counters(); }
    const NormaliseCounters& normalise_counters() const { return unit_.normalise_counters(); }

private:
    void process(FineBatch& batch, BatchTime& time) override;

    repousse::Perspective<Fixed> unit_;
    int normalise_latency_;  // of the profile's kind
};

}  // namespace repousse::shell
