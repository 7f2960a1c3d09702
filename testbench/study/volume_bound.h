#pragma once

#include "testbench/host/map/level_surface.h"

namespace repousse::study {

/// What no filter level of a map can do better, and what one can do.
struct VolumeBound {
    double least = 0;  ///< no heights of the level's vertices give a smaller difference volume
    double found = 0;  ///< some heights give this one; both LSB x texel
    int iterations = 0;
};

/// Brackets the least difference volume min |B z - f| (sum of absolute values) over all heights z
/// in 0..65535 of the vertices of level `level` of a map f; B as in level_surface.h.
///
/// It is a linear program. Its dual: for every y with |y| <= 1 at each texel and B'y = 0,
/// |B z - f| >= y (B z - f) = -y f for all z, so each such y is a proof. Pairs (z, y) come from
/// the primal-dual iteration of Chambolle and Pock with the diagonal steps of Pock and Chambolle
/// (ICCV 2011); y is made to obey B'y = 0 by conjugate gradients on B'B, then scaled into +-1. What
/// is left of B'y is paid for with the largest height there is.
///
/// Stops when `least` is at least `enough` and at least `near` times `found`, or after
/// `iterations`; both are looked at every hundred iterations. A study, not a filter: ten to a
/// hundred times the descent's work.
VolumeBound bound_volume(const host::HeightMap& map, int level, double enough, double near,
                         int iterations);

}  // namespace repousse::study
