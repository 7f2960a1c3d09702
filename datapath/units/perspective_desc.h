#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kPerspectivePorts[] = {
    {PortKind::Config, "tangents", "", 1, true, "vertices carry tangent and handedness"},
    {PortKind::Input, "x_c", "sweep_data", 0, false, "position, times c"},
    {PortKind::Input, "y_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "z_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "nx_c", "sweep_data", 0, false, "normal, times c"},
    {PortKind::Input, "ny_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "nz_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "uv_x_c", "sweep_data", 0, false, "texture coordinates in texels, times c"},
    {PortKind::Input, "uv_y_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "c", "inverse_w", 0, false, "w_scale / w, > 0"},
    {PortKind::Input, "tx_c", "sweep_data", 0, false, "tangent, times c; with 13 components only"},
    {PortKind::Input, "ty_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "tz_c", "sweep_data", 0, false, ""},
    {PortKind::Input, "handedness_c", "sweep_data", 0, false, "only its sign counts"},
    {PortKind::Output, "x", "position", 0, false, "on the base surface"},
    {PortKind::Output, "y", "position", 0, false, ""},
    {PortKind::Output, "z", "position", 0, false, ""},
    {PortKind::Output, "nx", "unnormalised", 0, false, "on its way into normalise"},
    {PortKind::Output, "ny", "unnormalised", 0, false, ""},
    {PortKind::Output, "nz", "unnormalised", 0, false, ""},
    {PortKind::Output, "uv_x", "uv", 0, false, "texels"},
    {PortKind::Output, "uv_y", "uv", 0, false, ""},
    {PortKind::Output, "tx", "unnormalised", 0, false, "on its way into normalise; 0 without"},
    {PortKind::Output, "ty", "unnormalised", 0, false, ""},
    {PortKind::Output, "tz", "unnormalised", 0, false, ""},
    {PortKind::Output, "left_handed", "", 1, true, "the bitangent is -(N x T)"},
    {PortKind::Output, "clamped", "", 1, true, "c was not positive"},
};

inline constexpr std::string_view kPerspectiveKeys[] = {
    "uv",
    "position",
    "unnormalised",
    "sweep_data",
    "inverse_w",
    "components",
    "reciprocal_index_bits",
    "reciprocal_newton_steps",
    "reciprocal_bits",
};

/// The reciprocal 8, products 1, casts 1.
inline constexpr UnitDesc kPerspectiveDesc = {
    "perspective",
    "Gumhold and Huettner 1999, section 3.1, equations 5 and 6",
    kPerspectivePorts,
    kPerspectiveKeys,
    10,  // latency
    1,   // interval
    10,  // capacity
    0,   // backward latency
};

}  // namespace repousse
