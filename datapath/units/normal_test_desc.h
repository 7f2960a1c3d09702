#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kNormalTestPorts[] = {
    {PortKind::Config, "threshold", "displaced_normal", 0, true,
     "largest difference that passes; components differ by up to 2"},
    {PortKind::Config, "map_space", "", 1, true, "compare N_D and N apart"},
    {PortKind::Input, "skip", "", 1, true, "the edge is decided: pass it on with result 0"},
    {PortKind::Input, "displaced_normal1_x", "displaced_normal", 0, false, "end 1"},
    {PortKind::Input, "displaced_normal1_y", "displaced_normal", 0, false, ""},
    {PortKind::Input, "displaced_normal1_z", "displaced_normal", 0, false, ""},
    {PortKind::Input, "map_normal1_x", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal1_y", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal1_z", "map_normal", 0, false, ""},
    {PortKind::Input, "normal1_x", "normal", 0, false, ""},
    {PortKind::Input, "normal1_y", "normal", 0, false, ""},
    {PortKind::Input, "normal1_z", "normal", 0, false, ""},
    {PortKind::Input, "displaced_normal2_x", "displaced_normal", 0, false, "end 2"},
    {PortKind::Input, "displaced_normal2_y", "displaced_normal", 0, false, ""},
    {PortKind::Input, "displaced_normal2_z", "displaced_normal", 0, false, ""},
    {PortKind::Input, "map_normal2_x", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal2_y", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal2_z", "map_normal", 0, false, ""},
    {PortKind::Input, "normal2_x", "normal", 0, false, ""},
    {PortKind::Input, "normal2_y", "normal", 0, false, ""},
    {PortKind::Input, "normal2_z", "normal", 0, false, ""},
    {PortKind::Input, "displaced_normal12_x", "displaced_normal", 0, false, "the midpoint"},
    {PortKind::Input, "displaced_normal12_y", "displaced_normal", 0, false, ""},
    {PortKind::Input, "displaced_normal12_z", "displaced_normal", 0, false, ""},
    {PortKind::Input, "map_normal12_x", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal12_y", "map_normal", 0, false, ""},
    {PortKind::Input, "map_normal12_z", "map_normal", 0, false, ""},
    {PortKind::Input, "normal12_x", "normal", 0, false, ""},
    {PortKind::Input, "normal12_y", "normal", 0, false, ""},
    {PortKind::Input, "normal12_z", "normal", 0, false, ""},
    {PortKind::Output, "nt", "", 1, true, "some component differs"},
};

inline constexpr std::string_view kNormalTestKeys[] = {"displaced_normal", "map_normal", "normal"};

/// Six absolute differences and comparisons side by side (twelve in map space), then an OR.
inline constexpr UnitDesc kNormalTestDesc = {
    "normal_test",
    "Doggett and Hirche 2000, sections 2.2 and 3.1.4",
    kNormalTestPorts,
    kNormalTestKeys,
    2,  // latency
    1,  // interval
    2,  // capacity
    0,  // backward latency
};

}  // namespace repousse
