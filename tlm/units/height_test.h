#pragma once

#include "datapath/profile.h"
#include "datapath/units/height_test.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The Summed Height Test in the device: datapath/units/height_test.h with its timing. It reads
/// the summed-area table through ports of its own.
class HeightTest : public EdgePlace {
public:
    HeightTest(const sc_core::sc_module_name& name, const Profile& profile);

    /// Loads the registers; `table` must outlive the frame. Errors: what the unit cannot hold.
    Status configure(const HeightTestRegisters& registers, Span<const uint64_t> table, bool eager);
    void reset() { unit_.reset(); }
    const TestCounters& counters() const { return unit_.counters(); }
    const HeightTestStats& stats() const { return unit_.stats(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;

    repousse::HeightTest unit_;
    bool eager_ = false;
};

}  // namespace repousse::shell
