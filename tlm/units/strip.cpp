#include "tlm/units/strip.h"

namespace repousse::shell {

Strip::Strip(const sc_core::sc_module_name& name) : Place(name) {
    triangles_.reserve(kStripTriangles * kFineVertices);
}

void Strip::process(FineBatch& batch, BatchTime& time) {
    std::size_t run = 0, vertex = 0;
    for (const FinePiece& piece : batch.pieces) {
        uint32_t number = fine_out->push(batch.vertices, vertex, piece.vertices);
        vertex += piece.vertices;
        triangles_.clear();
        unit_.run(
            batch.runs.subspan(run, piece.runs), [&number] { return number++; }, triangles_);
        run += piece.runs;
        fine_out->push(piece.base, triangles_);
        if (piece.runaway) unit_.flush();
        if (piece.last) fine_out->finish();
    }
    const uint64_t steps = step_count(batch.runs);
    time.stage(kStripDesc, steps);
    // A step's vertices and triangles enter the triangle buffer together.
    time.stage(kTriangleBufferDesc, steps);
}

}  // namespace repousse::shell
