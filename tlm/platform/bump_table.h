#pragma once

#include <cstddef>

#include "datapath/map_view.h"
#include "datapath/units/bump_desc.h"
#include "tlm/platform/frame_path.h"

namespace repousse::shell {

/// Fetches the table that bump of this kind reads, beside the heights; `texels`: of the map.
inline void bind_bump(FrameHost& host, BumpKind kind, std::size_t texels, MapView<Fixed>& map) {
    if (kind == BumpKind::Normals) map.normals = host.table<Vec3<int16_t>>(kNormalsLo, texels);
    if (kind == BumpKind::Turns) map.turns = host.table<Turn<int16_t>>(kNormalsLo, texels);
}

}  // namespace repousse::shell
