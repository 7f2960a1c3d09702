#pragma once

#include "datapath/unit_desc.h"
#include "datapath/units/normalise_desc.h"

namespace repousse {

inline constexpr Port kMidVertexPorts[] = {
    {PortKind::Input, "u1_x", "uv", 0, false, "end 1"},
    {PortKind::Input, "u1_y", "uv", 0, false, ""},
    {PortKind::Input, "generation1", "", 4, true, "0 to 14"},
    {PortKind::Input, "p1_x", "position", 0, false, ""},
    {PortKind::Input, "p1_y", "position", 0, false, ""},
    {PortKind::Input, "p1_z", "position", 0, false, ""},
    {PortKind::Input, "n1_x", "normal", 0, false, ""},
    {PortKind::Input, "n1_y", "normal", 0, false, ""},
    {PortKind::Input, "n1_z", "normal", 0, false, ""},
    {PortKind::Input, "t1_x", "normal", 0, false, ""},
    {PortKind::Input, "t1_y", "normal", 0, false, ""},
    {PortKind::Input, "t1_z", "normal", 0, false, ""},
    {PortKind::Input, "left1", "", 1, true, "set: the bitangent is -(N x T)"},
    {PortKind::Input, "u2_x", "uv", 0, false, "end 2"},
    {PortKind::Input, "u2_y", "uv", 0, false, ""},
    {PortKind::Input, "generation2", "", 4, true, ""},
    {PortKind::Input, "p2_x", "position", 0, false, ""},
    {PortKind::Input, "p2_y", "position", 0, false, ""},
    {PortKind::Input, "p2_z", "position", 0, false, ""},
    {PortKind::Input, "n2_x", "normal", 0, false, ""},
    {PortKind::Input, "n2_y", "normal", 0, false, ""},
    {PortKind::Input, "n2_z", "normal", 0, false, ""},
    {PortKind::Input, "t2_x", "normal", 0, false, ""},
    {PortKind::Input, "t2_y", "normal", 0, false, ""},
    {PortKind::Input, "t2_z", "normal", 0, false, ""},
    {PortKind::Input, "left2", "", 1, true, ""},
    {PortKind::Output, "u12_x", "uv", 0, false, "the midpoint"},
    {PortKind::Output, "u12_y", "uv", 0, false, ""},
    {PortKind::Output, "generation12", "", 4, true, "max of the ends + 1"},
    {PortKind::Output, "p12_x", "position", 0, false, "(P1 + P2) / 2"},
    {PortKind::Output, "p12_y", "position", 0, false, ""},
    {PortKind::Output, "p12_z", "position", 0, false, ""},
    {PortKind::Output, "n12_x", "normal", 0, false, "normalised"},
    {PortKind::Output, "n12_y", "normal", 0, false, ""},
    {PortKind::Output, "n12_z", "normal", 0, false, ""},
    {PortKind::Output, "t12_x", "normal", 0, false, "normalised"},
    {PortKind::Output, "t12_y", "normal", 0, false, ""},
    {PortKind::Output, "t12_z", "normal", 0, false, ""},
    {PortKind::Output, "left12", "", 1, true, "set if either is"},
};

inline constexpr std::string_view kMidVertexKeys[] = {"uv",
                                                      "position",
                                                      "normal",
                                                      "unnormalised",
                                                      "normalise_kind",
                                                      "inverse_sqrt_index_bits",
                                                      "inverse_sqrt_newton_steps",
                                                      "inverse_sqrt_bits"};

/// Cycles from two vertices to the one between them: the sums, then two normalisations side by
/// side.
constexpr int mid_vertex_latency(int normalise_kind, int normal_frac) {
    return 1 + normalise_latency(normalise_kind, normal_frac);
}

/// The figures of normalisation by the inverse square root; CORDIC has `mid_vertex_latency`.
inline constexpr UnitDesc kMidVertexDesc = {
    "mid_vertex",
    "Doggett and Hirche 2000, sections 2.1, 3.1.2 and 3.1.4",
    kMidVertexPorts,
    kMidVertexKeys,
    mid_vertex_latency(0, 0),  // latency
    1,                         // interval
    mid_vertex_latency(0, 0),  // capacity
    0,                         // backward latency
};

}  // namespace repousse
