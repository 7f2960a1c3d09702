#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Maps are at most 4096 texels a side: a size, or a column or row of the summed-area table
/// (0..4096), takes 13 bits.
inline constexpr int kMapSizeBits = 13;

inline constexpr Port kHeightTestPorts[] = {
    {PortKind::Config, "map_width", "", kMapSizeBits, true, "W, texels, 1 to 4096"},
    {PortKind::Config, "map_height", "", kMapSizeBits, true, "H, texels, 1 to 4096"},
    {PortKind::Config, "wrap", "", 1, true, "the map is periodic; otherwise boxes are clipped"},
    {PortKind::Config, "literal", "", 1, true, "boxes follow |du| and |dv|; otherwise square"},
    {PortKind::Config, "sum", "", 1, true, "compare sums as printed; otherwise averages"},
    {PortKind::Config, "threshold", "sat_width", 0, true,
     "averages: height LSB; sums: height LSB * texel^2"},
    {PortKind::Input, "skip", "", 1, true, "the edge is decided: pass it on with result 0"},
    {PortKind::Input, "u1_x", "uv", 0, false, "end 1"},
    {PortKind::Input, "u1_y", "uv", 0, false, ""},
    {PortKind::Input, "u2_x", "uv", 0, false, "end 2"},
    {PortKind::Input, "u2_y", "uv", 0, false, ""},
    {PortKind::Input, "u12_x", "uv", 0, false, "the vertex that would split the edge"},
    {PortKind::Input, "u12_y", "uv", 0, false, ""},
    {PortKind::Output, "sht", "", 1, true, "the height around U12 is not that around the ends"},
};

inline constexpr std::string_view kHeightTestKeys[] = {"uv", "sat_width", "height"};

/// The entries of the three boxes are read side by side, one of each a cycle: an edge takes 4
/// cycles (as in section 3.1.3), 6 or 9 where a box crosses a seam. The figures are for 4, and for
/// a memory that answers in the cycle after the request.
inline constexpr UnitDesc kHeightTestDesc = {
    "height_test",
    "Doggett and Hirche 2000, sections 2.3 and 3.1.3, equation 2",
    kHeightTestPorts,
    kHeightTestKeys,
    13,  // latency
    4,   // interval
    10,  // capacity
    1,   // backward latency: the response places are counted in registers
};

}  // namespace repousse
