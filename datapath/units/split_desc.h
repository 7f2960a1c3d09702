#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kSplitPorts[] = {
    {PortKind::Config, "has_surface_test", "", 1, true,
     "the scene has nt or sht; otherwise every edge counts as detailed"},
    {PortKind::Input, "eligible", "", 3, true, "bit e: edge e may be split"},
    {PortKind::Input, "ct", "", 3, true, "bit e"},
    {PortKind::Input, "vt", "", 3, true, "bit e"},
    {PortKind::Input, "nt", "", 3, true, "bit e"},
    {PortKind::Input, "sht", "", 3, true, "bit e"},
    {PortKind::Input, "corner1_x", "position", 0, false, "P' of the corners"},
    {PortKind::Input, "corner1_y", "position", 0, false, ""},
    {PortKind::Input, "corner1_z", "position", 0, false, ""},
    {PortKind::Input, "corner2_x", "position", 0, false, ""},
    {PortKind::Input, "corner2_y", "position", 0, false, ""},
    {PortKind::Input, "corner2_z", "position", 0, false, ""},
    {PortKind::Input, "corner3_x", "position", 0, false, ""},
    {PortKind::Input, "corner3_y", "position", 0, false, ""},
    {PortKind::Input, "corner3_z", "position", 0, false, ""},
    {PortKind::Input, "mid12_x", "position", 0, false, "P' of the new vertices"},
    {PortKind::Input, "mid12_y", "position", 0, false, ""},
    {PortKind::Input, "mid12_z", "position", 0, false, ""},
    {PortKind::Input, "mid23_x", "position", 0, false, ""},
    {PortKind::Input, "mid23_y", "position", 0, false, ""},
    {PortKind::Input, "mid23_z", "position", 0, false, ""},
    {PortKind::Input, "mid31_x", "position", 0, false, ""},
    {PortKind::Input, "mid31_y", "position", 0, false, ""},
    {PortKind::Input, "mid31_z", "position", 0, false, ""},
    {PortKind::Output, "digit", "", 2, true, "number of the child, in push order"},
    {PortKind::Output, "vertex1", "", 3, true, "its corners: 0 to 2 the parent's"},
    {PortKind::Output, "vertex2", "", 3, true, "corners, 3 to 5 the new vertices"},
    {PortKind::Output, "vertex3", "", 3, true, "of the edges 12, 23, 31"},
    {PortKind::Output, "unsplit", "", 3, true, "bit e: its edge e is the parent's, unsplit"},
    {PortKind::Output, "pass", "", 1, true, "no edge is split: the triangle itself"},
    {PortKind::Output, "last", "", 1, true, "the triangle's last child"},
};

inline constexpr std::string_view kSplitKeys[] = {"position", "diagonal"};

/// The decisions of three edges, differences, squares, their comparison, then one child a cycle:
/// the interval is that of three split edges, the longest.
inline constexpr UnitDesc kSplitDesc = {
    "split", "Doggett and Hirche 2000, sections 2.6 and 3.1.5, figure 6", kSplitPorts, kSplitKeys,
    5,  // latency
    4,  // interval
    5,  // capacity
    0,  // backward latency
    "last",
};

}  // namespace repousse
