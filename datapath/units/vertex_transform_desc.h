#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kVertexTransformPorts[] = {
    {PortKind::Config, "eye_x", "position", 0, false, "the camera, world units"},
    {PortKind::Config, "eye_y", "position", 0, false, ""},
    {PortKind::Config, "eye_z", "position", 0, false, ""},
    {PortKind::Config, "right_x", "view_row", 0, false, "unit vector to the right of the picture"},
    {PortKind::Config, "right_y", "view_row", 0, false, ""},
    {PortKind::Config, "right_z", "view_row", 0, false, ""},
    {PortKind::Config, "up_x", "view_row", 0, false, "unit vector upwards"},
    {PortKind::Config, "up_y", "view_row", 0, false, ""},
    {PortKind::Config, "up_z", "view_row", 0, false, ""},
    {PortKind::Config, "forward_x", "view_row", 0, false, "unit vector along the view"},
    {PortKind::Config, "forward_y", "view_row", 0, false, ""},
    {PortKind::Config, "forward_z", "view_row", 0, false, ""},
    {PortKind::Config, "near", "clip", 0, false, "points with w <= near have no screen position"},
    {PortKind::Config, "focal_x", "focal", 0, false, "pixels per unit of x/w"},
    {PortKind::Config, "focal_y", "focal", 0, false, "negative: rows run downwards"},
    {PortKind::Config, "centre_x", "focal", 0, false, "of the viewport, in pixels"},
    {PortKind::Config, "centre_y", "focal", 0, false, ""},
    {PortKind::Input, "displaced_x", "position", 0, false, "P'"},
    {PortKind::Input, "displaced_y", "position", 0, false, ""},
    {PortKind::Input, "displaced_z", "position", 0, false, ""},
    {PortKind::Output, "near_bit", "", 1, true, "w <= near: x and y are 0"},
    {PortKind::Output, "x", "screen", 0, false, "pixels, saturated"},
    {PortKind::Output, "y", "screen", 0, false, ""},
};

inline constexpr std::string_view kVertexTransformKeys[] = {"position",
                                                            "view_row",
                                                            "clip",
                                                            "ndc",
                                                            "focal",
                                                            "screen",
                                                            "reciprocal_index_bits",
                                                            "reciprocal_newton_steps",
                                                            "reciprocal_bits"};

/// Subtract the eye, three dot products, one reciprocal (table, two Newton steps, correction), two
/// products, viewport.
inline constexpr UnitDesc kVertexTransformDesc = {
    "vertex_transform",
    "Doggett and Hirche 2000, section 3 and figure 7 (Transform)",
    kVertexTransformPorts,
    kVertexTransformKeys,
    12,  // latency
    1,   // interval
    12,  // capacity
    0,   // backward latency
};

}  // namespace repousse
