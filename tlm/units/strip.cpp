#include "tlm/units/strip.h"

namespace repousse::shell {

Strip::Strip(const sc_core::sc_module_name& name) : Place(name) {
    triangles_.reserve(kStripTriangles * kBatchSweepSteps);
}

void Strip::process(FineBatch& batch, BatchTime& time) {
    std::size_t step = 0, vertex = 0;
    for (const FinePiece& piece : batch.pieces) {
        const uint32_t first = fine_out->push(batch.vertices, vertex, piece.vertices);
        vertex += piece.vertices;
        triangles_.clear();
        unit_.run(batch.steps.subspan(step, piece.steps), first, triangles_);
        step += piece.steps;
        fine_out->push(piece.base, triangles_);
        if (piece.runaway) unit_.flush();
        if (piece.last) fine_out->finish();
    }
    time.stage(kStripDesc, batch.steps.size());
    // A step's vertices and triangles enter the triangle buffer together.
    time.stage(kTriangleBufferDesc, batch.steps.size());
}

}  // namespace repousse::shell
