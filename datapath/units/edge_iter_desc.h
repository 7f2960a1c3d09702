#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kEdgeIterPorts[] = {
    {PortKind::Config, "cap", "", 4, true, "the highest generation of a new vertex"},
    {PortKind::Input, "generation1", "", 4, true, "of corner 1"},
    {PortKind::Input, "generation2", "", 4, true, "of corner 2"},
    {PortKind::Input, "generation3", "", 4, true, "of corner 3"},
    {PortKind::Input, "unsplit", "", 3, true, "bit e: edge e is known to be unsplit"},
    {PortKind::Output, "number", "", 2, true, "of the edge, 0: 12, 1: 23, 2: 31"},
    {PortKind::Output, "eligible", "", 1, true, "the edge may be split; otherwise it is decided"},
    {PortKind::Output, "last", "", 1, true, "the triangle's last edge"},
};

/// One edge a cycle, three a triangle.
inline constexpr UnitDesc kEdgeIterDesc = {
    "edge_iter", "Doggett and Hirche 2000, section 3.1", kEdgeIterPorts,
    {},  // profile entries that change a result
    1,   // latency
    3,   // interval
    1,   // capacity
    0,   // backward latency
    "last",
};

}  // namespace repousse
