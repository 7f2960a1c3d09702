#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kSplitPorts[] = {
    {PortKind::Input, "eligible", "", 3, true, "bit e: edge e may be split"},
    {PortKind::Input, "ct", "", 3, true, "bit e"},
    {PortKind::Input, "vt", "", 3, true, "bit e"},
    {PortKind::Input, "nt", "", 3, true, "bit e"},
    {PortKind::Input, "sht", "", 3, true, "bit e"},
    {PortKind::Input, "diagonal1_x", "position", 1, false, "P'(A) - P'(M1)"},
    {PortKind::Input, "diagonal1_y", "position", 1, false, ""},
    {PortKind::Input, "diagonal1_z", "position", 1, false, ""},
    {PortKind::Input, "diagonal2_x", "position", 1, false, "P'(B) - P'(M2)"},
    {PortKind::Input, "diagonal2_y", "position", 1, false, ""},
    {PortKind::Input, "diagonal2_z", "position", 1, false, ""},
    {PortKind::Output, "pattern", "", 2, true, "number of split edges"},
    {PortKind::Output, "first", "", 2, true, "the edge that decides the rotation"},
    {PortKind::Output, "first_diagonal", "", 1, true, "the quad is cut along A-M1"},
};

inline constexpr std::string_view kSplitKeys[] = {"position", "diagonal"};

/// The decisions of three edges, two squared lengths, then one child a cycle.
inline constexpr UnitDesc kSplitDesc = {
    "split", "Doggett and Hirche 2000, sections 2.6 and 3.1.5, figure 6", kSplitPorts, kSplitKeys,
    5,  // latency
    4,  // interval
    5,  // capacity
    0,  // backward latency
};

}  // namespace repousse
