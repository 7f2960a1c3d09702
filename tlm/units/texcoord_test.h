#pragma once

#include "datapath/profile.h"
#include "datapath/units/texcoord_test.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The Tex Coord Test in the device: datapath/units/texcoord_test.h with its timing.
class TexcoordTest : public EdgePlace {
public:
    TexcoordTest(const sc_core::sc_module_name& name, const Profile& profile);

    void configure(bool eager) { eager_ = eager; }
    void reset() { unit_.reset(); }
    const TestCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;

    repousse::TexcoordTest unit_;
    bool eager_ = false;
};

}  // namespace repousse::shell
