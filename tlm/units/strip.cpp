#include "tlm/units/strip.h"

namespace repousse::shell {

Strip::Strip(const sc_core::sc_module_name& name) : Place(name) {
    triangles_.reserve(kStripTriangles * kBatchSweepSteps);
}

void Strip::flush() {
    unit_.flush();
    vertices_.clear();
}

void Strip::reset() {
    unit_.reset();
    vertices_.clear();
}

void Strip::process(FineBatch& batch, BatchTime& time) {
    uint32_t next = vertices_.start_batch(unit_);
    for (const FineVertex<Fixed>& vertex : batch.vertices) vertices_.push_back(corner_of(vertex));
    StripTriangles<uint32_t> made;
    std::array<uint32_t, 4> numbers{};
    const SweepStep* step = batch.steps.begin();
    for (const FinePiece& piece : batch.pieces) {
        triangles_.clear();
        for (uint32_t i = 0; i < piece.steps; ++i, ++step) {
            for (std::size_t k = 0; k < step->vertex_count; ++k) numbers[k] = next++;
            unit_(step->strip, {numbers.data(), step->vertex_count}, made);
            triangles_.insert(triangles_.end(), made.triangles.begin(),
                              made.triangles.begin() + made.count);
        }
        triangles_out->push({piece.base, triangles_, vertices_.all()});
        if (piece.runaway) unit_.flush();
        if (piece.last) triangles_out->finish();
    }
    time.stage(kStripDesc, batch.steps.size());
    // A step's triangles enter the triangle buffer together.
    time.stage(kTriangleBufferDesc, batch.steps.size());
}

}  // namespace repousse::shell
