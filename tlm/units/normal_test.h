#pragma once

#include "datapath/profile.h"
#include "datapath/units/normal_test.h"
#include "datapath/units/normal_test_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The Normal Test in the device: datapath/units/normal_test.h with its timing.
class NormalTest : public EdgePlace {
public:
    NormalTest(const sc_core::sc_module_name& name, const Profile& profile);

    /// `threshold` as the register holds it: a raw value of `displaced_normal`.
    void configure(int32_t threshold, NormalSpace space, bool eager);
    void reset() { unit_.reset(); }
    const TestCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;

    repousse::NormalTest<Fixed> unit_;
    bool eager_ = false;
};

}  // namespace repousse::shell
