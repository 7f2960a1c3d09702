#pragma once

#include "datapath/profile.h"
#include "datapath/units/view_test.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The View Test in the device: datapath/units/view_test.h with its timing.
class ViewTest : public EdgePlace {
public:
    ViewTest(const sc_core::sc_module_name& name, const Profile& profile);

    /// `threshold` as the register holds it: a raw value with the fraction bits of `screen`.
    void configure(int64_t threshold, bool eager);
    void reset() { unit_.reset(); }
    const TestCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;

    repousse::ViewTest<Fixed> unit_;
    bool eager_ = false;
};

}  // namespace repousse::shell
