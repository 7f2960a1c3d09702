#include "tlm/units/triangle_buffer.h"

namespace repousse::shell {

// The controller never runs further ahead than a batch.
static_assert(kBatchBases <= kOrderDepth);

TriangleBuffer::TriangleBuffer(const sc_core::sc_module_name& name) : sc_module(name) {
    order.bind(*this);
    in.bind(*this);
}

void TriangleBuffer::configure(std::function<void(Span<const OutputRecord>)> emit) {
    emit_ = std::move(emit);
    unit_.clear();
}

// The order FIFO may be full of direct triangles that wait for room.
void TriangleBuffer::expect(const OrderToken& token) {
    if (!unit_.can_expect()) drain();
    unit_.expect(token);
}

void TriangleBuffer::push_direct(const OutputRecord& triangle) { unit_.push_direct(triangle); }

void TriangleBuffer::push(const StripBatch& batch) {
    for (std::size_t first = 0; first < batch.triangles.size();) {
        const auto make = [&](std::size_t i, OutputRecord& record) {
            const auto& [a, b, c] = batch.triangles[first + i];
            record.base = batch.base;
            record.depth = 0;
            record.digits = {};
            record.corners = {batch.vertices[a], batch.vertices[b], batch.vertices[c]};
        };
        first += unit_.push(batch.triangles.size() - first, make);
        if (first < batch.triangles.size()) drain();
    }
}

// A direct triangle before it may still wait for room.
void TriangleBuffer::finish() {
    if (!unit_.locked_by(Route::Displaced)) drain();
    unit_.finish();
}

}  // namespace repousse::shell
