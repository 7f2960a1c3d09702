#include "testbench/host/map/level_surface.h"

#include <algorithm>
#include <cmath>

#include "datapath/map_view.h"

namespace repousse::host {

int level_size(int size, int level) { return (size + (1 << level) - 1) >> level; }

int level_count(int width, int height) {
    int levels = 0;
    while (level_size(std::max(width, height), levels) > 1) ++levels;
    return levels;
}

LevelAxis level_axis(int size, int level, bool wrap) {
    LevelAxis axis;
    axis.vertices = level_size(size, level);
    axis.fraction.resize(static_cast<std::size_t>(size));
    const int block = 1 << level;
    for (int p = 0; p < size; ++p) {
        // Twice the texel's centre, from vertex 0, in texels: odd or (level 0) even, never halved.
        const int twice = 2 * p + 1 - block;
        const int before = twice < 0 ? -1 : twice / (2 * block);
        LevelAxis::Cell cell{p, p + 1, texel_address(before, axis.vertices, wrap),
                             texel_address(before + 1, axis.vertices, wrap)};
        const int along = twice - before * 2 * block;
        axis.fraction[static_cast<std::size_t>(p)] =
            cell.lower == cell.upper ? 0.0 : std::ldexp(along, -level - 1);
        const bool same = !axis.cells.empty() && axis.cells.back().lower == cell.lower &&
                          axis.cells.back().upper == cell.upper;
        if (same) {
            axis.cells.back().end = cell.end;
        } else {
            axis.cells.push_back(cell);
        }
    }
    return axis;
}

LevelGrid::LevelGrid(const HeightMap& map, int level)
    : x(level_axis(map.width, level, map.wrap)), y(level_axis(map.height, level, map.wrap)) {}

namespace {

/// Calls `row(y, low, high, t)` for every row of texels: it lies between the rows of vertices
/// that start at `low` and `high`, at t of the way.
template <class Row>
void for_rows(const LevelGrid& grid, Row row) {
    const auto columns = static_cast<std::size_t>(grid.x.vertices);
    for (const LevelAxis::Cell& rows : grid.y.cells) {
        for (auto y = static_cast<std::size_t>(rows.begin); y < static_cast<std::size_t>(rows.end);
             ++y) {
            row(y, static_cast<std::size_t>(rows.lower) * columns,
                static_cast<std::size_t>(rows.upper) * columns, grid.y.fraction[y]);
        }
    }
}

/// Calls `texel(x, lower, upper, t)` for every texel of a row.
template <class Texel>
void for_columns(const LevelGrid& grid, Texel texel) {
    for (const LevelAxis::Cell& cell : grid.x.cells) {
        const auto lower = static_cast<std::size_t>(cell.lower);
        const auto upper = static_cast<std::size_t>(cell.upper);
        for (auto x = static_cast<std::size_t>(cell.begin); x < static_cast<std::size_t>(cell.end);
             ++x) {
            texel(x, lower, upper, grid.x.fraction[x]);
        }
    }
}

}  // namespace

void surface_of(const LevelGrid& grid, const std::vector<double>& heights,
                std::vector<double>& surface) {
    const std::size_t width = grid.x.fraction.size();
    surface.resize(width * grid.y.fraction.size());
    std::vector<double> line(static_cast<std::size_t>(grid.x.vertices));
    for_rows(grid, [&](std::size_t y, std::size_t low, std::size_t high, double t) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            line[i] = heights[low + i] + t * (heights[high + i] - heights[low + i]);
        }
        double* row = surface.data() + y * width;
        for_columns(grid, [&](std::size_t x, std::size_t lower, std::size_t upper, double s) {
            row[x] = line[lower] + s * (line[upper] - line[lower]);
        });
    });
}

std::vector<double> surface_of(const LevelGrid& grid, const std::vector<double>& heights) {
    std::vector<double> surface;
    surface_of(grid, heights, surface);
    return surface;
}

void hat_sums(const LevelGrid& grid, const std::vector<double>& values, std::vector<double>& sums) {
    const std::size_t width = grid.x.fraction.size();
    sums.assign(grid.vertices(), 0.0);
    std::vector<double> line(static_cast<std::size_t>(grid.x.vertices));
    for_rows(grid, [&](std::size_t y, std::size_t low, std::size_t high, double t) {
        std::fill(line.begin(), line.end(), 0.0);
        const double* row = values.data() + y * width;
        for_columns(grid, [&](std::size_t x, std::size_t lower, std::size_t upper, double s) {
            line[lower] += (1.0 - s) * row[x];
            line[upper] += s * row[x];
        });
        for (std::size_t i = 0; i < line.size(); ++i) {
            sums[low + i] += (1.0 - t) * line[i];
            sums[high + i] += t * line[i];
        }
    });
}

std::vector<double> hat_sums(const LevelGrid& grid, const std::vector<double>& values) {
    std::vector<double> sums;
    hat_sums(grid, values, sums);
    return sums;
}

double difference_volume(const HeightMap& map, const LevelGrid& grid,
                         const std::vector<double>& heights) {
    const std::vector<double> surface = surface_of(grid, heights);
    double volume = 0.0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        volume += std::abs(surface[i] - map.texels[i]);
    }
    return volume;
}

double difference_volume(const HeightMap& map, const HeightMap& level_map, int level) {
    const std::vector<double> heights(level_map.texels.begin(), level_map.texels.end());
    return difference_volume(map, LevelGrid(map, level), heights);
}

}  // namespace repousse::host
