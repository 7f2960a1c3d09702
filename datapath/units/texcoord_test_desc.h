#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kTexcoordTestPorts[] = {
    {PortKind::Input, "skip", "", 1, true, "the edge is decided: pass it on with result 0"},
    {PortKind::Input, "u1_x", "uv", 0, false, "end 1"},
    {PortKind::Input, "u1_y", "uv", 0, false, ""},
    {PortKind::Input, "u2_x", "uv", 0, false, "end 2"},
    {PortKind::Input, "u2_y", "uv", 0, false, ""},
    {PortKind::Input, "u12_x", "uv", 0, false, "the vertex that would split the edge"},
    {PortKind::Input, "u12_y", "uv", 0, false, ""},
    {PortKind::Output, "ct", "", 1, true, "the split vertex lies in a texel of its own"},
};

inline constexpr std::string_view kTexcoordTestKeys[] = {"uv"};

/// One register stage behind six comparators.
inline constexpr UnitDesc kTexcoordTestDesc = {
    "texcoord_test",
    "Doggett and Hirche 2000, sections 2.5 and 3.1.2",
    kTexcoordTestPorts,
    kTexcoordTestKeys,
    1,  // latency
    1,  // interval
    1,  // capacity
    0,  // backward latency
};

}  // namespace repousse
