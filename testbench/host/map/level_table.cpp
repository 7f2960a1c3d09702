#include "testbench/host/map/level_table.h"

#include <algorithm>

#include "datapath/map_view.h"

namespace repousse::host {
namespace {

static_assert(kMaxFilterLevel == kMostLevels);

/// The first texel of every row, then of every column, answers for the last one too, where that
/// one is cut short.
template <class Extreme>
void join_seam(const HeightMap& map, int level, HeightMap& reduced, Extreme extreme) {
    if (!map.wrap) return;
    const int block = 1 << level;
    const auto at = [&](int x, int y) -> std::uint16_t& {
        return reduced
            .texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(reduced.width) +
                    static_cast<std::size_t>(x)];
    };
    if (map.width % block != 0) {
        for (int y = 0; y < reduced.height; ++y) {
            at(0, y) = extreme(at(0, y), at(reduced.width - 1, y));
        }
    }
    if (map.height % block != 0) {
        for (int x = 0; x < reduced.width; ++x) {
            at(x, 0) = extreme(at(x, 0), at(x, reduced.height - 1));
        }
    }
}

void append(LevelTable& table, const HeightMap& map) {
    table.heights.insert(table.heights.end(), map.texels.begin(), map.texels.end());
}

}  // namespace

LevelTable make_level_table(const HeightMap& map, LevelFilter kind) {
    LevelTable table;
    table.last_level = level_count(map.width, map.height);
    table.has_minima = kind == LevelFilter::BoxMaximum;
    append(table, map);
    const auto higher = [](std::uint16_t a, std::uint16_t b) { return std::max(a, b); };
    const auto lower = [](std::uint16_t a, std::uint16_t b) { return std::min(a, b); };
    for (int level = 1; level <= table.last_level; ++level) {
        HeightMap reduced = filter_level(map, level, kind);
        if (kind == LevelFilter::BoxMaximum) join_seam(map, level, reduced, higher);
        append(table, reduced);
    }
    for (int level = 1; table.has_minima && level <= table.last_level; ++level) {
        HeightMap reduced = minimum_level(map, level);
        join_seam(map, level, reduced, lower);
        append(table, reduced);
    }
    return table;
}

}  // namespace repousse::host
