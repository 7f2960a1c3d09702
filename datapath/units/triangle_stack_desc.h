#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kTriangleStackPorts[] = {
    {PortKind::Input, "uv_x", "uv", 0, false, "a corner: texture coordinates"},
    {PortKind::Input, "uv_y", "uv", 0, false, ""},
    {PortKind::Input, "generation", "", 4, true, "of the corner"},
    {PortKind::Input, "position_x", "position", 0, false, "P"},
    {PortKind::Input, "position_y", "position", 0, false, ""},
    {PortKind::Input, "position_z", "position", 0, false, ""},
    {PortKind::Input, "displaced_x", "position", 0, false, "P'"},
    {PortKind::Input, "displaced_y", "position", 0, false, ""},
    {PortKind::Input, "displaced_z", "position", 0, false, ""},
    {PortKind::Input, "normal_x", "normal", 0, false, "N"},
    {PortKind::Input, "normal_y", "normal", 0, false, ""},
    {PortKind::Input, "normal_z", "normal", 0, false, ""},
    {PortKind::Input, "tangent_x", "normal", 0, false, "T"},
    {PortKind::Input, "tangent_y", "normal", 0, false, ""},
    {PortKind::Input, "tangent_z", "normal", 0, false, ""},
    {PortKind::Input, "map_normal_x", "map_normal", 0, false, "N_D"},
    {PortKind::Input, "map_normal_y", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal_z", "map_normal", 0, false, ""},
    {PortKind::Input, "displaced_normal_x", "displaced_normal", 0, false, "N'"},
    {PortKind::Input, "displaced_normal_y", "displaced_normal", 0, false, ""},
    {PortKind::Input, "displaced_normal_z", "displaced_normal", 0, false, ""},
    {PortKind::Input, "near_bit", "", 1, true, "the corner has no screen position"},
    {PortKind::Input, "screen_x", "screen", 0, false, "pixels"},
    {PortKind::Input, "screen_y", "screen", 0, false, ""},
    {PortKind::Input, "handedness", "", 1, true, "set: the bitangent is -(N x T)"},
    {PortKind::Input, "unsplit", "", 1, true, "the edge behind the corner is known to be unsplit"},
    {PortKind::Output, "empty", "", 1, true, "no triangle waits"},
};

inline constexpr std::string_view kTriangleStackKeys[] = {
    "uv", "position", "normal", "map_normal", "displaced_normal", "screen"};

/// A memory of triangles with a pointer: a push or a pop a cycle. Ports name one corner; a triangle
/// is three of them, with its path behind.
inline constexpr UnitDesc kTriangleStackDesc = {
    "triangle_stack",
    "Doggett and Hirche 2000, section 3 and figure 7 (Triangle Queue)",
    kTriangleStackPorts,
    kTriangleStackKeys,
    1,  // latency
    1,  // interval
    1,  // capacity
    0,  // backward latency
};

}  // namespace repousse
