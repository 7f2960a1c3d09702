#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kBumpPorts[] = {
    {PortKind::Config, "map_width", "", 15, true, "W, texels"},
    {PortKind::Config, "map_height", "", 15, true, "H, texels"},
    {PortKind::Config, "wrap", "", 1, true, "the map is periodic"},
    {PortKind::Input, "u_x", "uv", 0, false, "texture coordinates"},
    {PortKind::Input, "u_y", "uv", 0, false, ""},
    {PortKind::Input, "n_x", "normal", 0, false, "N"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Input, "t_x", "normal", 0, false, "T"},
    {PortKind::Input, "t_y", "normal", 0, false, ""},
    {PortKind::Input, "t_z", "normal", 0, false, ""},
    {PortKind::Input, "handedness", "", 1, true, "set: the bitangent is -(N x T)"},
    {PortKind::Output, "map_normal_x", "map_normal", 0, false, "N_D as read"},
    {PortKind::Output, "map_normal_y", "map_normal", 0, false, ""},
    {PortKind::Output, "map_normal_z", "map_normal", 0, false, ""},
    {PortKind::Output, "displaced_normal_x", "displaced_normal", 0, false, "N', unit length"},
    {PortKind::Output, "displaced_normal_y", "displaced_normal", 0, false, ""},
    {PortKind::Output, "displaced_normal_z", "displaced_normal", 0, false, ""},
};

inline constexpr std::string_view kBumpKeys[] = {"uv",
                                                 "map_normal",
                                                 "normal",
                                                 "unnormalised",
                                                 "displaced_normal",
                                                 "normalise_kind",
                                                 "inverse_sqrt_index_bits",
                                                 "inverse_sqrt_newton_steps",
                                                 "inverse_sqrt_bits"};

/// One read, a cross product, nine multiply-adds, a normalisation.
inline constexpr UnitDesc kBumpDesc = {
    "bump", "Doggett and Hirche 2000, section 2.1 and figure 8", kBumpPorts, kBumpKeys,
    14,  // latency
    1,   // interval
    14,  // capacity
    0,   // backward latency
};

}  // namespace repousse
