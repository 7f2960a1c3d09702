#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Bits of the exponent n.
inline constexpr int kShininessBits = 8;

inline constexpr Port kShadePorts[] = {
    {PortKind::Config, "ambient_red", "light", 0, false,
     "light from everywhere, times the material"},
    {PortKind::Config, "ambient_green", "light", 0, false, ""},
    {PortKind::Config, "ambient_blue", "light", 0, false, ""},
    {PortKind::Config, "shininess", "", kShininessBits, true, "n, 1 to 255"},
    {PortKind::Config, "two_sided", "", 1, true, "seen from the back, N points to the viewer"},
    {PortKind::Config, "light_x", "normal", 0, false, "towards each light, unit length", "lights"},
    {PortKind::Config, "light_y", "normal", 0, false, "", "lights"},
    {PortKind::Config, "light_z", "normal", 0, false, "", "lights"},
    {PortKind::Config, "diffuse_red", "light", 0, false, "D of each light", "lights"},
    {PortKind::Config, "diffuse_green", "light", 0, false, "", "lights"},
    {PortKind::Config, "diffuse_blue", "light", 0, false, "", "lights"},
    {PortKind::Config, "specular_red", "light", 0, false, "S of each light", "lights"},
    {PortKind::Config, "specular_green", "light", 0, false, "", "lights"},
    {PortKind::Config, "specular_blue", "light", 0, false, "", "lights"},
    {PortKind::Input, "n_x", "normal", 0, false, "N or N', unit length"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Input, "v_x", "normal", 0, false, "V, towards the eye, unit length"},
    {PortKind::Input, "v_y", "normal", 0, false, ""},
    {PortKind::Input, "v_z", "normal", 0, false, ""},
    {PortKind::Output, "red", "colour", 0, false, "the vertex's colour"},
    {PortKind::Output, "green", "colour", 0, false, ""},
    {PortKind::Output, "blue", "colour", 0, false, ""},
};

inline constexpr std::string_view kShadeKeys[] = {"normal",
                                                  "cosine",
                                                  "light",
                                                  "colour",
                                                  "lights",
                                                  "power_log_index_bits",
                                                  "power_exp_index_bits"};

/// From the view vector on: products, sums, length, reflection, logarithm 3, product,
/// exponential 3, products, sum, cast.
inline constexpr UnitDesc kShadeDesc = {
    "shade", "Phong 1975; Gumhold and Huettner 1999, figure 3", kShadePorts, kShadeKeys,
    13,  // latency
    1,   // interval
    13,  // capacity
    0,   // backward latency
};

}  // namespace repousse
