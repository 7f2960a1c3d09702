#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Registers are addressed by four bits. One lane: 0-3 differences, 4-11 vertices, 12-15 invalid.
/// Two lanes hold the last vertex kept in the column FIFO as well, of both columns, and one more
/// edge vertex: 4-14 vertices, 15 invalid.
inline constexpr int kSweepOneLaneRegisters = 12;
inline constexpr int kSweepTwoLaneRegisters = 15;

inline constexpr Port kSweepLinePorts[] = {
    {PortKind::Config, "column_depth", "", 10, true, "vertices the column FIFO holds; 0: one lane"},
    {PortKind::Config, "abort", "", 1, true, "drop the triangle in the unit"},
    {PortKind::Input, "columns", "", 14, true, "of a half, 0 to 8192"},
    {PortKind::Input, "steps", "", 14, true, "of its edge, 1 to 8192"},
    {PortKind::Input, "direction", "", 1, true, "set: the sweep runs downwards"},
    {PortKind::Input, "flip", "", 1, true, "triangles are wound the other way"},
    {PortKind::Input, "tip", "", 1, true, "starts at an end of the primary edge"},
    {PortKind::Input, "closing", "", 1, true, "ends at an end of the primary edge"},
    {PortKind::Input, "other_left", "", 1, true, "first left column: the other side edge"},
    {PortKind::Input, "other_right", "", 1, true, "last right column: the other side edge"},
    {PortKind::Output, "init", "", 1, true, "start a new strip first"},
    {PortKind::Output, "flip_strip", "", 1, true, "its winding"},
    {PortKind::Output, "count", "", 3, true, "commands, 0 to 4"},
    {PortKind::Output, "command0", "", 6, true, "operation, register, where it is kept"},
    {PortKind::Output, "command1", "", 6, true, ""},
    {PortKind::Output, "command2", "", 6, true, ""},
    {PortKind::Output, "command3", "", 6, true, ""},
};

/// One step a cycle: a quad, or a single triangle. Data follow the slots by a cycle.
inline constexpr UnitDesc kSweepLineDesc = {
    "sweep_line",
    "Gumhold and Huettner 1999, section 3.4.4, figures 14 and 15",
    kSweepLinePorts,
    {},
    2,  // latency
    1,  // interval
    2,  // capacity
    1,  // backward latency
};

}  // namespace repousse
