#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kViewClipPorts[] = {
    {PortKind::Config, "near_w", "clip", 0, false, "least distance along the view"},
    {PortKind::Config, "far_w", "clip", 0, false, "greatest distance"},
    {PortKind::Config, "cosine_x", "view_row", 0, false, "cos(a_x/2), rounded outwards"},
    {PortKind::Config, "sine_x", "view_row", 0, false, "sin(a_x/2), rounded outwards"},
    {PortKind::Config, "cosine_y", "view_row", 0, false, "cos(a_y/2), rounded outwards"},
    {PortKind::Config, "sine_y", "view_row", 0, false, "sin(a_y/2), rounded outwards"},
    {PortKind::Config, "margin", "clip", 0, false, "what rounding may have moved a point by"},
    {PortKind::Input, "x1", "clip", 0, false, "corner 1 in eye space, to the right"},
    {PortKind::Input, "y1", "clip", 0, false, "up"},
    {PortKind::Input, "w1", "clip", 0, false, "along the view"},
    {PortKind::Input, "x2", "clip", 0, false, "corner 2"},
    {PortKind::Input, "y2", "clip", 0, false, ""},
    {PortKind::Input, "w2", "clip", 0, false, ""},
    {PortKind::Input, "x3", "clip", 0, false, "corner 3"},
    {PortKind::Input, "y3", "clip", 0, false, ""},
    {PortKind::Input, "w3", "clip", 0, false, ""},
    {PortKind::Input, "max_displacement", "displacement", 0, false, "d_max >= 0 of the triangle"},
    {PortKind::Output, "reject", "", 1, true, "nothing of the displaced triangle is visible"},
    {PortKind::Output, "outside", "", 6, true,
     "planes that it lies beyond; from bit 0: left, right, bottom, top, near, far"},
};

inline constexpr std::string_view kViewClipKeys[] = {"displacement", "view_row", "clip"};

/// Products; plane distances against the reach; the three corners together.
inline constexpr UnitDesc kViewClipDesc = {
    "view_clip",
    "Gumhold and Huettner 1999, section 3.2, equations 7 and 8",
    kViewClipPorts,
    kViewClipKeys,
    3,  // latency
    1,  // interval
    3,  // capacity
    0,  // backward latency
};

}  // namespace repousse
