#pragma once

#include <cstdint>

#include "datapath/unit_desc.h"
#include "datapath/units/normalise_desc.h"

namespace repousse {

/// What bump reads at a texel, `bump_kind` of a profile.
enum class BumpKind : uint8_t {
    Normals,  ///< N_D, which the host made by finite differences
    Slopes,   ///< the four heights around, differenced (Blinn)
    Turns,    ///< two rotation angles (Kugler)
};

inline constexpr Port kBumpPorts[] = {
    {PortKind::Config, "map_width", "", 15, true, "W, texels"},
    {PortKind::Config, "map_height", "", 15, true, "H, texels"},
    {PortKind::Config, "wrap", "", 1, true, "the map is periodic"},
    {PortKind::Config, "slope_u_mantissa", "", 25, true, "kind 1: slope = rise * mantissa * 2^-e"},
    {PortKind::Config, "slope_u_exponent", "", 6, true, ""},
    {PortKind::Config, "slope_v_mantissa", "", 25, true, ""},
    {PortKind::Config, "slope_v_exponent", "", 6, true, ""},
    {PortKind::Input, "u_x", "uv", 0, false, "texture coordinates"},
    {PortKind::Input, "u_y", "uv", 0, false, ""},
    {PortKind::Input, "n_x", "normal", 0, false, "N"},
    {PortKind::Input, "n_y", "normal", 0, false, ""},
    {PortKind::Input, "n_z", "normal", 0, false, ""},
    {PortKind::Input, "t_x", "normal", 0, false, "T"},
    {PortKind::Input, "t_y", "normal", 0, false, ""},
    {PortKind::Input, "t_z", "normal", 0, false, ""},
    {PortKind::Input, "handedness", "", 1, true, "set: the bitangent is -(N x T)"},
    {PortKind::Output, "map_normal_x", "map_normal", 0, false, "N_D; 0 with kind 1"},
    {PortKind::Output, "map_normal_y", "map_normal", 0, false, ""},
    {PortKind::Output, "map_normal_z", "map_normal", 0, false, ""},
    {PortKind::Output, "displaced_normal_x", "displaced_normal", 0, false, "N', unit length"},
    {PortKind::Output, "displaced_normal_y", "displaced_normal", 0, false, ""},
    {PortKind::Output, "displaced_normal_z", "displaced_normal", 0, false, ""},
};

inline constexpr std::string_view kBumpKeys[] = {"uv",
                                                 "height",
                                                 "map_normal",
                                                 "normal",
                                                 "unnormalised",
                                                 "displaced_normal",
                                                 "bump_kind",
                                                 "slope",
                                                 "angle",
                                                 "sine_index_bits",
                                                 "normalise_kind",
                                                 "inverse_sqrt_index_bits",
                                                 "inverse_sqrt_newton_steps",
                                                 "inverse_sqrt_bits"};

/// Reads a normal, which is cycles between two vertices.
constexpr int bump_interval(int bump_kind) {
    return bump_kind == static_cast<int>(BumpKind::Slopes) ? 4 : 1;
}

/// Cycles from a vertex to its normal, with a memory that answers in the next cycle. The address 1,
/// the read 2, the rotation 4, the normalisation. Kind 1: 1 to send four reads, 3 for the other
/// three, their differences 1, the slopes 2, a shift 2. Kind 2: the sines 3, their products 2.
constexpr int bump_latency(int bump_kind, int normalise_kind, int displaced_normal_frac) {
    const int more = bump_kind == static_cast<int>(BumpKind::Slopes)  ? 9
                     : bump_kind == static_cast<int>(BumpKind::Turns) ? 5
                                                                      : 0;
    return 7 + more + normalise_latency(normalise_kind, displaced_normal_frac);
}

/// The figures of kind 0 with the inverse square root; for others there are the functions above.
/// The capacity: every stage, and eight reads on their way.
inline constexpr UnitDesc kBumpDesc = {
    "bump",
    "Doggett and Hirche 2000, section 2.1 and figure 8; Blinn 1978; Kugler 1998",
    kBumpPorts,
    kBumpKeys,
    bump_latency(0, 0, 0),            // latency
    bump_interval(0),                 // interval
    5 + normalise_latency(0, 0) + 8,  // capacity
    1,                                // backward latency: the response places are in registers
};

}  // namespace repousse
