#pragma once

#include <cstdint>
#include <vector>

#include "testbench/host/map/filter_levels.h"

namespace repousse::host {

/// A displacement map with its filter levels as the device's memory holds them: the map, level 1,
/// level 2 and so on down to one texel, each row by row; then the minima of levels 1 to the last,
/// if there are minima (datapath/map_view.h: level_start).
struct LevelTable {
    std::vector<std::uint16_t> heights;
    int last_level = 0;
    bool has_minima = false;
};

/// The levels of `kind`. BoxMaximum comes with the box minima, for vertices that are seen from the
/// back; levels of the other kinds serve both sides.
///
/// A box level bounds everything under a footprint. On a periodic map whose side is no multiple of
/// 2^level, the level's last texel is cut short by the border, and a footprint across the seam may
/// step over it; so the first texel of the row or column answers for both. Errors: none.
LevelTable make_level_table(const HeightMap& map, LevelFilter kind);

}  // namespace repousse::host
