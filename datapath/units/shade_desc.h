#pragma once

#include "datapath/unit_desc.h"
#include "datapath/units/normalise_desc.h"

namespace repousse {

/// Bits of the exponent n.
inline constexpr int kShininessBits = 8;

inline constexpr Port kShadePorts[] = {
    {PortKind::Config, "eye_x", "position", 0, false, "where the viewer is"},
    {PortKind::Config, "eye_y", "position", 0, false, ""},
    {PortKind::Config, "eye_z", "position", 0, false, ""},
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
    {PortKind::Input, "p_x", "position", 0, false, "P'"},
    {PortKind::Input, "p_y", "position", 0, false, ""},
    {PortKind::Input, "p_z", "position", 0, false, ""},
    {PortKind::Input, "n_x", "normal", 0, false, "N or N', unit length"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Output, "red", "colour", 0, false, "the vertex's colour"},
    {PortKind::Output, "green", "colour", 0, false, ""},
    {PortKind::Output, "blue", "colour", 0, false, ""},
};

inline constexpr std::string_view kShadeKeys[] = {
    "position",
    "normal",
    "unnormalised",
    "cosine",
    "light",
    "colour",
    "lights",
    "power_log_index_bits",
    "power_exp_index_bits",
    "normalise_kind",
    "inverse_sqrt_index_bits",
    "inverse_sqrt_newton_steps",
    "inverse_sqrt_bits",
};

/// Cycles from a vertex to its colour. The view vector: difference, length, shift, normalisation.
/// From there on: products, sums, length, reflection, logarithm 3, product, exponential 3,
/// products, sum and cast.
constexpr int shade_latency(int normalise_kind, int frac) {
    return 3 + normalise_latency(normalise_kind, frac) + 13;
}

/// The figures of normalisation kind 0, which both shipped profiles have; with another kind the
/// latency, and as many places, are `shade_latency`.
inline constexpr UnitDesc kShadeDesc = {
    "shade",
    "Phong 1975; Gumhold and Huettner 1999, figure 3",
    kShadePorts,
    kShadeKeys,
    shade_latency(0, 0),  // latency
    1,                    // interval
    shade_latency(0, 0),  // capacity
    0,                    // backward latency
};

}  // namespace repousse
