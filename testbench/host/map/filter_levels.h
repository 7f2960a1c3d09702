#pragma once

#include <vector>

#include "testbench/host/map/height_map.h"
#include "testbench/host/map/level_surface.h"

namespace repousse::host {

/// How the filter levels of a displacement map are made.
enum class LevelFilter {
    Average,      ///< the mean of each block of 2^level x 2^level texels
    BoxMaximum,   ///< the highest texel of each block
    BoxMinimum,   ///< the lowest texel of each block
    Variational,  ///< the least volume between the level's surface and the map: variational_level.h
};

/// The name of a filter in scenes and reports.
const char* level_filter_name(LevelFilter kind);

/// The mean of each block, rounded half up; border blocks are cut short by the map's border.
HeightMap average_level(const HeightMap& map, int level);

/// The highest texel of each block.
HeightMap maximum_level(const HeightMap& map, int level);

/// The lowest texel of each block.
HeightMap minimum_level(const HeightMap& map, int level);

/// Level `level` of a map, of the kind asked for: level_size() texels a side, range, elevations
/// and wrap as the map's. Level 0 is the map. Range: level 0..level_count(map).
HeightMap filter_level(const HeightMap& map, int level, LevelFilter kind);

/// All levels, 1 to level_count(map), each made from the full-resolution map.
std::vector<HeightMap> filter_levels(const HeightMap& map, LevelFilter kind);

}  // namespace repousse::host
