#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "testbench/host/view/rasteriser.h"

namespace repousse::test {

using HalfEdge = std::array<host::SnappedVertex, 2>;

/// How often half-edges that close up wind counter-clockwise (to the eye) around the centre of
/// pixel (x, y). A centre on an edge counts as a little to the right of where it is, and less than
/// that below: so it lies inside what has it on its left or top border, and on no edge at all.
inline int winding(const std::vector<HalfEdge>& edges, int x, int y) {
    const std::int64_t cx = x * host::kSubpixels + host::kSubpixels / 2;
    const std::int64_t cy = y * host::kSubpixels + host::kSubpixels / 2;
    int turns = 0;
    for (const auto& [p, q] : edges) {
        if ((p.y <= cy) == (q.y <= cy)) continue;  // the ray to the right passes above or below
        const std::int64_t dy = q.y - p.y;
        const std::int64_t side = (p.x - cx) * dy + (q.x - p.x) * (cy - p.y);
        const bool is_right = dy > 0 ? side > 0 : side < 0;
        if (is_right) turns += dy > 0 ? -1 : 1;
    }
    return turns;
}

}  // namespace repousse::test
