#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kNormalisePorts[] = {
    {PortKind::Input, "x", "unnormalised", 0, false, "a vector of any length"},
    {PortKind::Input, "y", "unnormalised", 0, false, ""},
    {PortKind::Input, "z", "unnormalised", 0, false, ""},
    {PortKind::Output, "unit_x", "normal", 0, false, "the vector over its length"},
    {PortKind::Output, "unit_y", "normal", 0, false, ""},
    {PortKind::Output, "unit_z", "normal", 0, false, ""},
};

inline constexpr std::string_view kNormaliseKeys[] = {
    "normal",
    "unnormalised",
    "normalise_kind",
    "inverse_sqrt_index_bits",
    "inverse_sqrt_newton_steps",
    "inverse_sqrt_bits",
};

/// Cycles from a vector to its unit vector. Kind 0: squares and their sum 2, inverse square root 12
/// (leading zeros, shift, seed, twice a Newton step of 4, rounding), products and casts 2. Kind 1,
/// CORDIC with n = frac + 5 turns for results of `frac` fraction bits: 2 to scale, 3 n turns, a
/// cast.
constexpr int normalise_latency(int kind, int frac) {
    const int bounded = frac < 4 ? 4 : frac > 18 ? 18 : frac;
    return kind == 0 ? 16 : 3 * (bounded + 5) + 3;
}

/// The figures of kind 0, which both shipped profiles have; other kinds have `normalise_latency`.
inline constexpr UnitDesc kNormaliseDesc = {
    "normalise",
    "Gumhold and Huettner 1999, equation 1",
    kNormalisePorts,
    kNormaliseKeys,
    normalise_latency(0, 0),  // latency
    1,                        // interval
    normalise_latency(0, 0),  // capacity
    0,                        // backward latency
};

}  // namespace repousse
