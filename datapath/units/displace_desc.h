#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kDisplacePorts[] = {
    {PortKind::Config, "map_width", "", 15, true, "W, texels"},
    {PortKind::Config, "map_height", "", 15, true, "H, texels"},
    {PortKind::Config, "wrap", "", 1, true, "the map is periodic"},
    {PortKind::Config, "filter", "", 2, true, "0 nearest, 1 bilinear, 2 maximum, 3 average"},
    {PortKind::Config, "finer", "", 2, true, "0 to 2: 2^finer + 1 places an axis; maximum only"},
    {PortKind::Config, "minima", "", 1, true, "levels of their own for the back"},
    {PortKind::Config, "scale_mantissa", "", 25, true, "D = h * mantissa * 2^-exponent + bias"},
    {PortKind::Config, "scale_exponent", "", 6, true, ""},
    {PortKind::Config, "bias", "displacement", 0, false, "world units"},
    {PortKind::Input, "p_x", "position", 0, false, "P"},
    {PortKind::Input, "p_y", "position", 0, false, ""},
    {PortKind::Input, "p_z", "position", 0, false, ""},
    {PortKind::Input, "n_x", "normal", 0, false, "N, unit length"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Input, "u_x", "uv", 0, false, "texture coordinates"},
    {PortKind::Input, "u_y", "uv", 0, false, ""},
    {PortKind::Input, "reach_x", "uv", 0, false, "filter levels: the texels under U +- reach ..."},
    {PortKind::Input, "reach_y", "uv", 0, false, ""},
    {PortKind::Input, "level", "", 4, true, "... of this level"},
    {PortKind::Input, "back", "", 1, true, "seen from the back: the minimum"},
    {PortKind::Output, "displaced_x", "position", 0, false, "P' = P + D N"},
    {PortKind::Output, "displaced_y", "position", 0, false, ""},
    {PortKind::Output, "displaced_z", "position", 0, false, ""},
};

inline constexpr std::string_view kDisplaceKeys[] = {"uv",           "height",   "filtered_height",
                                                     "displacement", "position", "normal"};

/// Four reads for a bilinear height, one for the nearest texel, one, two or four of a filter level,
/// up to nine or 25 of a finer one, through one port; interpolation, scale, multiply-add. The
/// figures are those of bilinear heights, with a memory that answers in the next cycle.
inline constexpr UnitDesc kDisplaceDesc = {
    "displace",
    "Doggett and Hirche 2000, equation 1 and section 3 (Displace Vertex); Gumhold and Huettner "
    "1999, "
    "section 4.1",
    kDisplacePorts,
    kDisplaceKeys,
    16,  // latency
    4,   // interval
    11,  // capacity
    1,   // backward latency: the response places are counted in registers
};

}  // namespace repousse
