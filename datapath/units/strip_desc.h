#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Addressed by two bits: Vstart, Vedge, and the two lower vertices of the current step.
inline constexpr int kStripRegisters = 4;

/// Vertices in each FIFO at most: the tallest column that is kept.
inline constexpr int kStripFifoDepth = 256;

inline constexpr Port kStripPorts[] = {
    {PortKind::Config, "flush", "", 1, true, "end of frame: forget strip and FIFOs"},
    {PortKind::Input, "init", "", 1, true, "start a new strip first"},
    {PortKind::Input, "flip", "", 1, true, "with init: swap the last two vertices of a triangle"},
    {PortKind::Input, "count", "", 3, true, "commands, 0 to 4"},
    {PortKind::Input, "command0", "", 6, true, "operation, register, where the vertex is kept"},
    {PortKind::Input, "command1", "", 6, true, ""},
    {PortKind::Input, "command2", "", 6, true, ""},
    {PortKind::Input, "command3", "", 6, true, ""},
    {PortKind::Output, "triangles", "", 3, true, "made by the step, 0 to 2"},
    {PortKind::Output, "bad_ref", "", 1, true, "status: a register or FIFO without a vertex"},
};

/// One step a cycle.
inline constexpr UnitDesc kStripDesc = {
    "strip", "Gumhold and Huettner 1999, section 2.3", kStripPorts, {},
    1,  // latency
    1,  // interval
    1,  // capacity
    0,  // backward latency
};

}  // namespace repousse
