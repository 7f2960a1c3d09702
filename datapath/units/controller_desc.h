#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kControllerPorts[] = {
    {PortKind::Config, "vertex_count", "", 32, true, "base vertices"},
    {PortKind::Input, "vertex0", "", 32, true, "a corner's number"},
    {PortKind::Input, "vertex1", "", 32, true, ""},
    {PortKind::Input, "vertex2", "", 32, true, ""},
    {PortKind::Input, "direct", "", 1, true, "not displaced: to the triangle buffer"},
    {PortKind::Output, "base", "", 32, true, "number of the base triangle, from 0 in each draw"},
    {PortKind::Output, "route", "", 1, true, "0 displacement unit, 1 triangle buffer"},
    {PortKind::Output, "bad_index", "", 1, true, "status: a corner names no vertex; the draw ends"},
};

/// Entries that rule the conversion of an undisplaced vertex.
inline constexpr std::string_view kControllerKeys[] = {"normal", "displaced_normal"};

/// A descriptor, then its three vertices from memory, one a cycle.
inline constexpr UnitDesc kControllerDesc = {
    "controller",
    "Gumhold and Huettner 1999, section 2.2 and figure 3",
    kControllerPorts,
    kControllerKeys,
    4,  // latency
    3,  // interval
    2,  // capacity
    1,  // backward latency
};

}  // namespace repousse
