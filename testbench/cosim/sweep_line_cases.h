#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "testbench/cosim/random.h"

namespace repousse::cosim {

/// Three corners on the grid.
using GridCorners = std::array<std::array<int32_t, 3>, 3>;

/// Base triangles that are hard for the sweep line, under the case's name.
struct SweepCase {
    const char* name;
    std::vector<GridCorners> triangles;
};

/// The hard cases of the committed vectors: small triangles, so that the files stay small.
const std::vector<SweepCase>& sweep_hard_cases();

/// A base triangle of one of many kinds: small and middling ones, facing and edgewise, thin, with
/// equal corners, collinear, a point. About 60 fine triangles on average, rarely 2,000.
GridCorners random_sweep_triangle(Random& random);

/// A sliver with corners up to +-4096: up to 25,000 fine triangles.
GridCorners random_far_sliver(Random& random);

}  // namespace repousse::cosim
