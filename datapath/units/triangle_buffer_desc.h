#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Finished triangles that wait to leave: a step of the sweep line makes two at most, so this
/// covers 128 cycles of a stalled rasteriser.
inline constexpr int kTriangleBufferDepth = 256;

/// Vertices that wait to leave: every second triangle brings one.
inline constexpr int kVertexBufferDepth = 256;

/// Base triangles whose order is kept, and undisplaced triangles that wait for their turn: a
/// displaced triangle takes some 100 cycles from controller to strip, a direct one three.
inline constexpr int kOrderDepth = 64;

inline constexpr Port kTriangleBufferPorts[] = {
    {PortKind::Input, "token", "", 1, true, "from the controller: a base triangle's place"},
    {PortKind::Input, "route", "", 1, true, "of the token: 0 displaced, 1 direct"},
    {PortKind::Input, "direct", "", 1, true, "from the controller: an undisplaced triangle"},
    {PortKind::Input, "count", "", 2, true, "from the strip: triangles of a step, 0 to 2"},
    {PortKind::Input, "vertices", "", 3, true, "from the strip: new vertices of a step, 0 to 4"},
    {PortKind::Input, "finish", "", 1, true, "from the strip: the base triangle is complete"},
    {PortKind::Output, "locked_by", "", 1, true, "route of the oldest token"},
    {PortKind::Output, "full", "", 1, true, "no room for a step's vertices and triangles"},
    {PortKind::Output, "triangles", "", 9, true, "that wait to leave, 0 to 256"},
};

/// A step of the strip, with its triangles, or a direct triangle a cycle.
inline constexpr UnitDesc kTriangleBufferDesc = {
    "triangle_buffer",
    "Gumhold and Huettner 1999, section 2.2 and figure 3 (FIFO/Triangle Buffer)",
    kTriangleBufferPorts,
    {},
    1,    // latency
    1,    // interval
    256,  // capacity
    1,    // backward latency
};

}  // namespace repousse
