#pragma once

#include <cstdint>

#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// The paper's half donut (Doggett and Hirche, figure 10; formula of adaptive-tessellation.md,
/// section 5): texel centre p = ((x + .5) / width, (y + .5) / height), rho = |p - (.5, .5)| - .3,
/// D = sqrt(.12^2 - rho^2) or 0 outside the ring, h = floor(D / .12 * 65535 + .5).
/// `range_high` is set to 0.12.
HeightMap make_donut_map(int width, int height);

/// Every texel `value`.
HeightMap make_constant_map(int width, int height, std::uint16_t value);

/// h = start + slope_x * x + slope_y * y (texel indices), saturated to 0..65535.
HeightMap make_ramp_map(int width, int height, int start, int slope_x, int slope_y);

/// Squares of `square` texels, alternately `low` (at texel (0, 0)) and `high`.
HeightMap make_checker_map(int width, int height, int square, std::uint16_t low,
                           std::uint16_t high);

/// What kind of landscape `make_fbm_map` makes.
struct FbmSettings {
    std::uint64_t seed = 1;
    int cells_x = 4;  ///< lattice cells of the first octave across the map, 1..256
    int cells_y = 4;
    int octaves = 7;        ///< 1..12; each has twice the cells of the one before
    int gain_percent = 50;  ///< amplitude of an octave over the one before, 10..90
    bool ridged = false;    ///< 1 - |noise| an octave: mountain crests instead of hills
    bool wrap = false;      ///< periodic in both directions
};

/// Fractional Brownian motion of gradient noise, in 64-bit integers only (hash, lattice, fade
/// curve, sum), so a seed gives the same bytes on every machine; stretched to the full 0..65535.
HeightMap make_fbm_map(int width, int height, const FbmSettings& settings);

}  // namespace repousse::host
