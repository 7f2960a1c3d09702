#pragma once

#include <functional>
#include <utility>

#include "datapath/units/triangle_buffer.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The FIFO/Triangle Buffer Unit in the device: datapath/units/triangle_buffer.h over the records
/// that go to memory. Level lt has no rasteriser that could be slow: it writes when it is full.
class TriangleBuffer : public sc_core::sc_module, public OrderSink, public TriangleSink {
public:
    sc_core::sc_export<OrderSink> order{"order"};
    sc_core::sc_export<TriangleSink> in{"in"};

    explicit TriangleBuffer(const sc_core::sc_module_name& name);

    /// Starts a frame. `emit` gets finished triangles in order.
    void configure(std::function<void(Span<const OutputRecord>)> emit);

    /// Writes what waits.
    void drain() { unit_.drain(emit_); }

    /// After an abort: forgets what is under way.
    void clear() { unit_.clear(); }
    void reset() { unit_.reset(); }
    const TriangleBufferCounters& counters() const { return unit_.counters(); }

private:
    void expect(const OrderToken& token) override;
    void push_direct(const OutputRecord& triangle) override;
    void push(const StripBatch& batch) override;
    void finish() override;

    repousse::TriangleBuffer<OutputRecord> unit_;
    std::function<void(Span<const OutputRecord>)> emit_;
};

}  // namespace repousse::shell
