#pragma once

#include <vector>

#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// The variational descent of Gumhold and Huettner, section 4.2.
///
/// From the average, each step takes the derivative of the difference volume V by every vertex
/// (equation 12: raise the vertex by epsilon, take the volume over the influenced area again),
/// then moves all vertices at once by -lambda dV.
///
/// What the paper leaves open, and what is added:
/// - The unit of lambda. A move of lambda = 1 and dV = 1 is the start's mean |surface - map| under
///   the vertex's hat, so that plains and mountains of one map settle equally fast. A is the area
///   weighted by that hat: dV is within -1..1, and border vertices move like the others.
/// - How lambda varies. A step that does not lower V is taken back. Then lambda, and epsilon with
///   it, halves: from 2^0 over the paper's 2^-2 down to `least_lambda`. So V falls strictly.
/// - Momentum (Nesterov's weights n / (n + 3)), dropped at the first step that is taken back:
///   about half the steps for the same volume.
///
/// V is convex in the heights, a sum of absolute values of linear functions, so there is no local
/// minimum to fall into; kinks slow the descent down, and it stops a little above the optimum.
struct VariationalSettings {
    double epsilon = 1e-4;             ///< of the height range; at least 1/64 LSB is used
    int steps = 64;                    ///< at most, taken or not
    double least_lambda = 1.0 / 1024;  ///< stop below
    int patience = 8;                  ///< stop when so many steps together ...
    double least_fall = 1.0 / 2048;    ///< ... lower V by less than this part of the start
};

/// A level, and how the volume fell on the way to it.
struct VariationalLevel {
    HeightMap map;
    /// LSB x texel: of the average, then after each step (the same again for one taken back).
    std::vector<double> volumes;
    /// Of `map`, whose heights are rounded to 16 bits. Never above volumes[0].
    double volume = 0.0;
};

VariationalLevel variational_level(const HeightMap& map, int level,
                                   const VariationalSettings& settings = {});

}  // namespace repousse::host
