#include "tlm/units/footprint.h"

namespace repousse::shell {

Footprint::Footprint(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name), unit_(profile) {}

// Vertices of a batch may belong to several base triangles.
void Footprint::process(FineBatch& batch, BatchTime& time) {
    std::size_t first = 0;
    for (const FinePiece& piece : batch.pieces) {
        if (piece.vertices == 0) continue;
        unit_.run(batch.vertices, first, piece.vertices, *piece.texel_steps);
        first += piece.vertices;
    }
    time.stage(kFootprintDesc, batch.vertices.size);
}

}  // namespace repousse::shell
