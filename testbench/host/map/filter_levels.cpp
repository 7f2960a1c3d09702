#include "testbench/host/map/filter_levels.h"

#include <algorithm>
#include <cstdint>

#include "testbench/host/map/variational_level.h"

namespace repousse::host {
namespace {

/// A map of a level's size, otherwise as `map`.
HeightMap level_shell(const HeightMap& map, int level) {
    HeightMap result;
    result.width = level_size(map.width, level);
    result.height = level_size(map.height, level);
    result.wrap = map.wrap;
    result.range_low = map.range_low;
    result.range_high = map.range_high;
    result.has_elevation = map.has_elevation;
    result.elevation_low_m = map.elevation_low_m;
    result.elevation_high_m = map.elevation_high_m;
    return result;
}

/// Calls `reduce(x0, x1, y0, y1)` for the block of every texel of a level.
template <class Reduce>
HeightMap by_blocks(const HeightMap& map, int level, Reduce reduce) {
    HeightMap result = level_shell(map, level);
    result.texels.reserve(static_cast<std::size_t>(result.width) *
                          static_cast<std::size_t>(result.height));
    const int block = 1 << level;
    for (int y = 0; y < map.height; y += block) {
        for (int x = 0; x < map.width; x += block) {
            result.texels.push_back(
                reduce(x, std::min(x + block, map.width), y, std::min(y + block, map.height)));
        }
    }
    return result;
}

}  // namespace

HeightMap average_level(const HeightMap& map, int level) {
    return by_blocks(map, level, [&](int x0, int x1, int y0, int y1) {
        std::uint64_t sum = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) sum += map.at(x, y);
        }
        const auto count =
            static_cast<std::uint64_t>(x1 - x0) * static_cast<std::uint64_t>(y1 - y0);
        return static_cast<std::uint16_t>((2 * sum + count) / (2 * count));
    });
}

HeightMap maximum_level(const HeightMap& map, int level) {
    return by_blocks(map, level, [&](int x0, int x1, int y0, int y1) {
        std::uint16_t highest = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) highest = std::max(highest, map.at(x, y));
        }
        return highest;
    });
}

HeightMap minimum_level(const HeightMap& map, int level) {
    return by_blocks(map, level, [&](int x0, int x1, int y0, int y1) {
        std::uint16_t lowest = 65535;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) lowest = std::min(lowest, map.at(x, y));
        }
        return lowest;
    });
}

const char* level_filter_name(LevelFilter kind) {
    switch (kind) {
        case LevelFilter::Average:
            return "average";
        case LevelFilter::BoxMaximum:
            return "maximum";
        case LevelFilter::BoxMinimum:
            return "minimum";
        case LevelFilter::Variational:
            break;
    }
    return "variational";
}

HeightMap filter_level(const HeightMap& map, int level, LevelFilter kind) {
    if (level == 0) return map;
    switch (kind) {
        case LevelFilter::Average:
            return average_level(map, level);
        case LevelFilter::BoxMaximum:
            return maximum_level(map, level);
        case LevelFilter::BoxMinimum:
            return minimum_level(map, level);
        case LevelFilter::Variational:
            break;
    }
    return variational_level(map, level).map;
}

std::vector<HeightMap> filter_levels(const HeightMap& map, LevelFilter kind) {
    std::vector<HeightMap> levels;
    for (int level = 1; level <= level_count(map.width, map.height); ++level) {
        levels.push_back(filter_level(map, level, kind));
    }
    return levels;
}

}  // namespace repousse::host
