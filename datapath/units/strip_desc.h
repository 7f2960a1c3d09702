#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Addressed by two bits: Vstart, Vedge, and the two lower vertices of the current step.
inline constexpr int kStripRegisters = 4;

/// Vertices in each FIFO at most: the tallest column that is kept.
inline constexpr int kStripFifoDepth = 256;

/// Triangles that a step makes at most: a quad.
inline constexpr int kStripTriangles = 2;

/// A command on a port: operation (StripOp), register, where the vertex is kept (StripKeep), two
/// bits each, the operation most significant.
inline constexpr int kStripCommandBits = 6;

/// What stands for a vertex here. In the device it is whatever the stages before have made of one:
/// the unit never looks inside, and its RTL has the width as a parameter.
inline constexpr int kStripVertexBits = 32;

inline constexpr Port kStripPorts[] = {
    {PortKind::Input, "flush", "", 1, true, "forget strip, registers and FIFOs first"},
    {PortKind::Input, "init", "", 1, true, "then start a new strip"},
    {PortKind::Input, "flip", "", 1, true, "with init: swap the last two vertices of a triangle"},
    {PortKind::Input, "count", "", 3, true, "commands, 0 to 4"},
    {PortKind::Input, "command0", "", kStripCommandBits, true, "operation, register, where kept"},
    {PortKind::Input, "command1", "", kStripCommandBits, true, ""},
    {PortKind::Input, "command2", "", kStripCommandBits, true, ""},
    {PortKind::Input, "command3", "", kStripCommandBits, true, ""},
    {PortKind::Input, "vertex0", "", kStripVertexBits, true, "of the first command that is new"},
    {PortKind::Input, "vertex1", "", kStripVertexBits, true, "of the second"},
    {PortKind::Input, "vertex2", "", kStripVertexBits, true, ""},
    {PortKind::Input, "vertex3", "", kStripVertexBits, true, ""},
    {PortKind::Output, "triangles", "", 2, true, "made by the step, 0 to 2"},
    {PortKind::Output, "bad_ref", "", 1, true,
     "a command named a register or FIFO without a vertex, or a full FIFO, or made a third "
     "triangle"},
    {PortKind::Output, "a0", "", kStripVertexBits, true,
     "the first triangle; undefined if not made"},
    {PortKind::Output, "b0", "", kStripVertexBits, true, ""},
    {PortKind::Output, "c0", "", kStripVertexBits, true, ""},
    {PortKind::Output, "a1", "", kStripVertexBits, true, "the second"},
    {PortKind::Output, "b1", "", kStripVertexBits, true, ""},
    {PortKind::Output, "c1", "", kStripVertexBits, true, ""},
};

inline constexpr std::string_view kStripKeys[] = {"column_depth"};

/// One step a cycle.
inline constexpr UnitDesc kStripDesc = {
    "strip", "Gumhold and Huettner 1999, section 2.3", kStripPorts, kStripKeys,
    1,  // latency
    1,  // interval
    1,  // capacity
    0,  // backward latency
};

}  // namespace repousse
