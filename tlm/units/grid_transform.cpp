#include "tlm/units/grid_transform.h"

namespace repousse::shell {

GridTransform::GridTransform(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name), unit_(profile) {}

void GridTransform::configure(const GridRegisters<Fixed>& registers, bool tangents) {
    unit_.configure(registers);
    tangents_ = tangents;
}

void GridTransform::process(CornerBatch& batch, BatchTime& time) {
    for (std::size_t i = 0; i < batch.vertices.size(); ++i) {
        GridVertex& vertex = batch.corners[i];
        vertex.point = unit_(vertex.eye);
        unit_.scale(batch.vertices[i], vertex.point.c, tangents_, vertex.corner.data);
    }
    time.stage(kGridTransformDesc, batch.vertices.size());
}

}  // namespace repousse::shell
