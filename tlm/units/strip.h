#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/units/strip.h"
#include "datapath/units/strip_desc.h"
#include "datapath/units/triangle_buffer_desc.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The stripping unit in the device: datapath/units/strip.h with its timing. Its registers hold
/// the numbers of vertices, which go on to the triangle buffer before their triangles do.
class Strip : public Place<FineBatch> {
public:
    sc_core::sc_port<FineSink> fine_out{"fine_out"};

    explicit Strip(const sc_core::sc_module_name& name);

    /// End of a frame, or of an aborted one.
    void flush() { unit_.flush(); }
    void reset() { unit_.reset(); }
    bool bad_ref() const { return unit_.bad_ref(); }
    const StripCounters& counters() const { return unit_.counters(); }

private:
    void process(FineBatch& batch, BatchTime& time) override;

    repousse::Strip<uint32_t> unit_;
    std::vector<std::array<uint32_t, 3>> triangles_;  // of one base triangle
};

}  // namespace repousse::shell
