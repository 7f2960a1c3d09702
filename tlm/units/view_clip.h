#pragma once

#include "datapath/profile.h"
#include "datapath/units/view_clip.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// Clipping to the extended view volume in the device: datapath/units/view_clip.h with its timing.
class ViewClip : public Place<BaseBatch> {
public:
    ViewClip(const sc_core::sc_module_name& name, const Profile& profile);

    void configure(const ClipRegisters<Fixed>& registers) { unit_.configure(registers); }
    void reset() { unit_.reset(); }
    const ViewClipCounters& counters() const { return unit_.counters(); }

private:
    void process(BaseBatch& batch, BatchTime& time) override;

    repousse::ViewClip<Fixed> unit_;
};

}  // namespace repousse::shell
