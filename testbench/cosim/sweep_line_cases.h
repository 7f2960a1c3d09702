#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/sweep_line_ports.h"
#include "datapath/units/sweep_line.h"
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

/// One of both: a far sliver in 8192.
GridCorners any_sweep_triangle(Random& random);

/// Hands the beats that the sweep line makes of a base triangle to `send`. One that is aborted, or
/// that it gives up, ends with an empty beat.
template <class Send>
void sweep_beats(SweepLine& unit, const SweepLineIn& in, bool aborted, const Send& send) {
    const uint64_t before = unit.counters().runaways;
    SweepLineOut beat;
    if (!aborted) {
        unit.load(in.triangle);
        while (unit.step(beat.step)) {
            beat.last = !unit.busy();
            send(beat);
        }
    }
    if (beat.last) return;
    beat = {};
    beat.runaway = unit.counters().runaways != before;
    beat.last = true;
    send(beat);
}

}  // namespace repousse::cosim
