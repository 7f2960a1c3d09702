#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// A grid coordinate before rounding: s14.6 for x and y (u14.6 for z, less its offset), one bit
/// more for positions beyond the guard band, which are clamped here.
inline constexpr int kGridFractionBits = 6;
inline constexpr int kGridSlotBits = 14;
inline constexpr int kGridDifferenceBits = 15;
inline constexpr int kGridRemainderBits = 15;
inline constexpr int kGridDeterminantBits = 28;

inline constexpr Port kTriangleSetupPorts[] = {
    {PortKind::Config, "guard", "", 13, true, "clamp of corners, grid units, at most 4096"},
    {PortKind::Config, "z_offset", "", kGridSlotBits, true, "taken from z, grid units"},
    {PortKind::Input, "x", "", 22, false, "a corner: grid position, 6 fraction bits, signed"},
    {PortKind::Input, "y", "", 22, false, ""},
    {PortKind::Input, "z", "", 22, false, ""},
    {PortKind::Output, "slot_x", "", kGridSlotBits, false, "the corner, rounded and clamped"},
    {PortKind::Output, "slot_y", "", kGridSlotBits, false, ""},
    {PortKind::Output, "slot_z", "", kGridSlotBits, false, ""},
    {PortKind::Output, "sweep_axis", "", 2, true, "main direction of the primary edge"},
    {PortKind::Output, "side_axis", "", 2, true, ""},
    {PortKind::Output, "primary", "", 2, true, "the longest edge"},
    {PortKind::Output, "form", "", 2, true, "0 roof, 1 increasing, 2 decreasing"},
    {PortKind::Output, "determinant", "", kGridDeterminantBits, false, "twice the projected area"},
    {PortKind::Output, "quotient", "", 48, false, "a component of a difference vector, signed"},
    {PortKind::Output, "remainder", "", kGridDeterminantBits, true,
     "doubled; edges use the low 15 bits"},
};

inline constexpr std::string_view kTriangleSetupKeys[] = {
    "sweep_data", "inverse_w", "adder_kind", "guard_bits", "components", "dividers",
};

/// Rounding, main directions and longest edge 3 cycles, cross products 3, one quotient 48, case
/// selection 2. The interval is that of one divider: 13 components of 3 edges and 2 gradients.
inline constexpr UnitDesc kTriangleSetupDesc = {
    "triangle_setup",
    "Gumhold and Huettner 1999, sections 3.4.1 to 3.4.3, equations 9 to 11",
    kTriangleSetupPorts,
    kTriangleSetupKeys,
    56,  // latency
    65,  // interval
    2,   // capacity
    1,   // backward latency
};

}  // namespace repousse
