#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kFootprintPorts[] = {
    {PortKind::Config, "map_width", "", 15, true, "W, texels"},
    {PortKind::Config, "map_height", "", 15, true, "H, texels"},
    {PortKind::Config, "last_level", "", 4, true, "of the map's filter levels"},
    {PortKind::Config, "finer", "", 2, true, "0 to 2: levels below that of the footprint"},
    {PortKind::Config, "eye_x", "position", 0, false, "where the camera stands"},
    {PortKind::Config, "eye_y", "position", 0, false, ""},
    {PortKind::Config, "eye_z", "position", 0, false, ""},
    {PortKind::Input, "kind", "", 2, true, "0 corner, 1 on an edge, 2 inside"},
    {PortKind::Input, "p_x", "position", 0, false, "P, on the base surface"},
    {PortKind::Input, "p_y", "position", 0, false, ""},
    {PortKind::Input, "p_z", "position", 0, false, ""},
    {PortKind::Input, "n_x", "normal", 0, false, "N, unit length"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Input, "u_x", "uv", 0, false, "texture coordinates"},
    {PortKind::Input, "u_y", "uv", 0, false, ""},
    {PortKind::Input, "c", "inverse_w", 0, false, "w_scale / w"},
    {PortKind::Input, "step0_u", "sweep_data", 0, false,
     "change of u c: of the edge, or the sweep"},
    {PortKind::Input, "step0_v", "sweep_data", 0, false, "of v c"},
    {PortKind::Input, "step0_c", "inverse_w", 0, false, "of c"},
    {PortKind::Input, "step1_u", "sweep_data", 0, false, "inside: of the side; else not looked at"},
    {PortKind::Input, "step1_v", "sweep_data", 0, false, ""},
    {PortKind::Input, "step1_c", "inverse_w", 0, false, ""},
    {PortKind::Output, "reach_x", "uv", 0, false, "the footprint is U +- reach; 0 and up"},
    {PortKind::Output, "reach_y", "uv", 0, false, ""},
    {PortKind::Output, "level", "", 4, true, "to be read"},
    {PortKind::Output, "back", "", 1, true, "the surface is seen from the back"},
};

inline constexpr std::string_view kFootprintKeys[] = {
    "uv",
    "position",
    "normal",
    "sweep_data",
    "inverse_w",
    "reciprocal_index_bits",
    "reciprocal_newton_steps",
    "reciprocal_bits",
};

/// The reciprocal 8 (differences take 3 of them), half steps 2, rectangle 1, level and limits 1.
inline constexpr UnitDesc kFootprintDesc = {
    "footprint", "Gumhold and Huettner 1999, section 4.1", kFootprintPorts, kFootprintKeys,
    12,  // latency
    1,   // interval
    12,  // capacity
    0,   // backward latency
};

}  // namespace repousse
