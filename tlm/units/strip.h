#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/pipelines/vertex_pool.h"
#include "datapath/units/strip.h"
#include "datapath/units/strip_desc.h"
#include "datapath/units/triangle_buffer_desc.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The stripping unit in the device: datapath/units/strip.h with its timing. Its registers hold
/// vertices as they leave the device; here, their numbers.
class Strip : public Place<FineBatch> {
public:
    sc_core::sc_port<TriangleSink> triangles_out{"triangles_out"};

    explicit Strip(const sc_core::sc_module_name& name);

    /// End of a frame, or of an aborted one.
    void flush();
    void reset();
    bool bad_ref() const { return unit_.bad_ref(); }
    const StripCounters& counters() const { return unit_.counters(); }

private:
    void process(FineBatch& batch, BatchTime& time) override;

    repousse::Strip<uint32_t> unit_;
    VertexPool<OutputRecord::Corner> vertices_;       // by the numbers in the unit
    std::vector<std::array<uint32_t, 3>> triangles_;  // of one base triangle
};

}  // namespace repousse::shell
