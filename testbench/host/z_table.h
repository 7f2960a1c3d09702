#pragma once

#include <cstdint>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/units/grid_transform.h"
#include "testbench/host/view/camera.h"

namespace repousse::host {

/// What decides where an object's vertices lie on the grid.
struct GridCamera {
    ViewFrame view;           ///< near > 0: z_grid is 0 there
    double coarseness = 1.0;  ///< grid units in pixels: divides x, y and z alike
    double w_min = 0.0;       ///< w is clamped to at least this; at least an LSB
    double w_scale = 0.0;     ///< c = w_scale / w: the least w of the object, at least w_min
    double far = 0.0;         ///< the uniform table ends there; the octave tables need no end
};

/// Grid units in depth for each doubling of w: ln 2 / ln(1 + s) over the coarseness, s = 1 / focal
/// being a pixel's width at w = 1 (Gumhold and Huettner, equations 3 and 4).
double steps_per_octave(const GridCamera& camera);

/// Where w lies in depth, in grid units (equation 4); exact but for the double's last bits.
double grid_depth(const GridCamera& camera, double w);

/// The registers of `grid_transform` for a camera. With the profile's uniform table (and P = Fixed)
/// `table` is filled, and the registers' span refers to it: 2^z_table_index_bits + 1 words, which
/// the driver has to bring to the device with every camera. Errors: a focal length, the steps per
/// octave or a depth does not fit its format.
template <class P>
Result<GridRegisters<P>> make_grid_registers(const Profile& profile, const GridCamera& camera,
                                             std::vector<uint32_t>& table);

}  // namespace repousse::host
