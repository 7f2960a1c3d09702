#pragma once

#include <vector>

#include "testbench/reference/coverage.h"

namespace repousse::reference {

/// A remeshed base triangle: the axes of its remeshing plane, and fine triangles by name.
struct Remeshing {
    int axis_a = 0;  ///< sweep
    int axis_b = 1;  ///< side
    std::vector<CoverTriangle> triangles;
};

/// Sweep-line remeshing (Gumhold and Huettner 3.4, repaired) in closed form: every slot is computed
/// from the corners by a division, vertices are names, nothing is accumulated. Triangles come in
/// the order in which the sweep line makes them.
Remeshing remesh(const std::array<std::array<int64_t, 3>, 3>& corners);

}  // namespace repousse::reference
