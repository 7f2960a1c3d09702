#pragma once

#include "datapath/profile.h"
#include "datapath/units/footprint.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// Filter level access in the device: datapath/units/footprint.h with its timing.
class Footprint : public Place<FineBatch> {
public:
    Footprint(const sc_core::sc_module_name& name, const Profile& profile);

    void configure(const FootprintRegisters<Fixed>& registers) { unit_.configure(registers); }
    void reset() { unit_.reset(); }
    const FootprintCounters& counters() const { return unit_.counters(); }

private:
    void process(FineBatch& batch, BatchTime& time) override;

    repousse::Footprint<Fixed> unit_;
};

}  // namespace repousse::shell
