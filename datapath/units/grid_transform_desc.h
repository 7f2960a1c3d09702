#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// A grid coordinate as it leaves the unit: s15.6, one bit beyond the guard band of the slots.
inline constexpr int kGridPositionBits = 22;
/// log2 of a depth: s6.20. Depths have 31 bits at most, wherever their binary point is.
inline constexpr int kGridLog2Bits = 27;
/// The uniform table: 2^z_table_index_bits intervals, a word for either end of each.
inline constexpr int kUniformTableBits = 22;     ///< u14.8
inline constexpr int kUniformTableFraction = 8;  ///< below the grid's 6, for the interpolation
inline constexpr int kUniformScaleBits = 20;     ///< its leading bit is 1
inline constexpr int kUniformFractionBits = 16;  ///< of a place within an interval

inline constexpr Port kGridTransformPorts[] = {
    {PortKind::Config, "w_min", "clip", 0, false, "> 0: w is clamped to at least this"},
    {PortKind::Config, "w_scale", "clip", 0, false, "c = w_scale / w, at most 1"},
    {PortKind::Config, "focal_x", "focal", 0, false, "grid units per unit of x/w"},
    {PortKind::Config, "focal_y", "focal", 0, false, ""},
    {PortKind::Config, "steps_per_octave", "steps_per_octave", 0, false,
     "K: grid units in depth for each doubling of w"},
    {PortKind::Config, "log2_near", "", kGridLog2Bits, false, "log2(near) * 2^20"},
    {PortKind::Config, "table_near", "clip", 0, false, "uniform table: w of its first word"},
    {PortKind::Config, "table_scale", "", kUniformScaleBits, true,
     "uniform table: intervals per LSB of w, times 2^(16 + table_shift)"},
    {PortKind::Config, "table_shift", "", 6, true, ""},
    {PortKind::Input, "x", "clip", 0, false, "a vertex in eye space"},
    {PortKind::Input, "y", "clip", 0, false, ""},
    {PortKind::Input, "w", "clip", 0, false, ""},
    {PortKind::Input, "attribute", "position", 0, false, "what the one lane of `scale` multiplies"},
    {PortKind::Output, "x_grid", "", kGridPositionBits, false, "s15.6, saturated"},
    {PortKind::Output, "y_grid", "", kGridPositionBits, false, ""},
    {PortKind::Output, "z_grid", "", kGridPositionBits, false, "K log2(w / near)"},
    {PortKind::Output, "c", "inverse_w", 0, false, "w_scale / w"},
    {PortKind::Output, "data", "sweep_data", 0, false, "attribute * c"},
};

inline constexpr std::string_view kGridTransformKeys[] = {"position",
                                                          "clip",
                                                          "ndc",
                                                          "focal",
                                                          "sweep_data",
                                                          "inverse_w",
                                                          "steps_per_octave",
                                                          "z_table_kind",
                                                          "z_table_index_bits",
                                                          "reciprocal_index_bits",
                                                          "reciprocal_newton_steps",
                                                          "reciprocal_bits"};

/// Clamp, reciprocal (8), two products with their roundings (4), the lane of `scale` (2). The depth
/// is looked up beside the reciprocal.
inline constexpr UnitDesc kGridTransformDesc = {
    "grid_transform",
    "Gumhold and Huettner 1999, section 3.1, equations 2 to 4, and 3.2 (c)",
    kGridTransformPorts,
    kGridTransformKeys,
    15,  // latency
    1,   // interval
    15,  // capacity
    0,   // backward latency
};

}  // namespace repousse
