#pragma once

#include <functional>
#include <utility>

#include "datapath/units/triangle_buffer.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The FIFO/Triangle Buffer Unit in the device: datapath/units/triangle_buffer.h over the records
/// that go to memory. Level lt has no rasteriser that could be slow: it writes when it is full.
class TriangleBuffer : public sc_core::sc_module, public OrderSink, public FineSink {
public:
    sc_core::sc_export<OrderSink> order{"order"};
    sc_core::sc_export<FineSink> in{"in"};

    explicit TriangleBuffer(const sc_core::sc_module_name& name);

    /// What becomes of finished vertices and triangles.
    struct Sink {
        std::function<void(Span<const FineRecord>)> vertices;
        std::function<void(Span<const FineTriangleRecord>)> triangles;

        void operator()(Span<const FineRecord> some) const { vertices(some); }
        void operator()(Span<const FineTriangleRecord> some) const { triangles(some); }
    };

    /// Starts a frame. `sink` gets what is finished, in order.
    void configure(Sink sink);

    /// Writes what waits.
    void drain() { unit_.drain(sink_); }

    /// After an abort: forgets what is under way.
    void clear() { unit_.clear(); }
    void reset() { unit_.reset(); }
    const TriangleBufferCounters& counters() const { return unit_.counters(); }

private:
    void expect(const OrderToken& token) override;
    void push_direct(const DirectTriangle& triangle) override;
    uint32_t push(const FineVertices<Fixed>& batch, std::size_t first, std::size_t count) override;
    void push(uint32_t base, Span<const std::array<uint32_t, 3>> triangles) override;
    void finish() override;
    void await_lock();

    repousse::TriangleBuffer<FineRecord> unit_;
    Sink sink_;
};

}  // namespace repousse::shell
