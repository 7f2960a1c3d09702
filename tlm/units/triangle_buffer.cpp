#include "tlm/units/triangle_buffer.h"

namespace repousse::shell {

// The controller never runs further ahead than a batch.
static_assert(kBatchBases <= kOrderDepth);

TriangleBuffer::TriangleBuffer(const sc_core::sc_module_name& name) : sc_module(name) {
    order.bind(*this);
    in.bind(*this);
}

void TriangleBuffer::configure(Sink sink) {
    sink_ = std::move(sink);
    unit_.clear();
}

// The order FIFO may be full of direct triangles that wait for room.
void TriangleBuffer::expect(const OrderToken& token) {
    if (!unit_.can_expect()) drain();
    unit_.expect(token);
}

void TriangleBuffer::push_direct(const DirectTriangle& triangle) { unit_.push_direct(triangle); }

// A direct triangle before it may still wait for room: the next numbers are its vertices'.
void TriangleBuffer::await_lock() {
    if (!unit_.locked_by(Route::Displaced)) drain();
}

uint32_t TriangleBuffer::push(const FineVertices<Fixed>& batch, std::size_t first,
                              std::size_t count) {
    await_lock();
    const uint32_t number = unit_.vertex_count();
    for (const std::size_t end = first + count; first < end;) {
        const auto make = [&](std::size_t i, FineRecord& record) {
            record = batch.output(first + i);
        };
        first += unit_.push_vertices(end - first, make);
        if (first < end) drain();
    }
    return number;
}

void TriangleBuffer::push(uint32_t base, Span<const std::array<uint32_t, 3>> triangles) {
    for (std::size_t first = 0; first < triangles.size();) {
        const auto make = [&](std::size_t i, FineTriangleRecord& record) {
            record = {base, triangles[first + i]};
        };
        first += unit_.push(triangles.size() - first, make);
        if (first < triangles.size()) drain();
    }
}

void TriangleBuffer::finish() {
    await_lock();
    unit_.finish();
}

}  // namespace repousse::shell
