#include "testbench/host/map/height_map.h"

#include <algorithm>
#include <cmath>

namespace repousse::host {
namespace {

/// How one side of a map is resampled: the cells that each new texel covers, with integer weights
/// in units of 1 / (new size) of a cell. The weights of one new texel add up to the old size.
struct Cover {
    int first = 0;
    std::vector<std::int64_t> weights;
};

std::vector<Cover> covers(int old_size, int new_size) {
    std::vector<Cover> result(static_cast<std::size_t>(new_size));
    for (int i = 0; i < new_size; ++i) {
        // New texel i covers [i * old, (i + 1) * old) where old texel j is [j * new, (j + 1) *
        // new).
        const std::int64_t low = std::int64_t{i} * old_size;
        const std::int64_t high = low + old_size;
        Cover& cover = result[static_cast<std::size_t>(i)];
        cover.first = static_cast<int>(low / new_size);
        for (std::int64_t j = cover.first; j * new_size < high; ++j) {
            cover.weights.push_back(std::min(high, (j + 1) * new_size) -
                                    std::max(low, j * new_size));
        }
    }
    return result;
}

}  // namespace

HeightMap quantise(const ElevationGrid& grid) {
    HeightMap map;
    map.width = grid.width;
    map.height = grid.height;
    map.texels.resize(grid.samples.size());
    const double span = grid.high - grid.low;
    for (std::size_t i = 0; i < grid.samples.size(); ++i) {
        const bool scalable = span > 0.0 && std::isfinite(grid.samples[i]);
        const double scaled =
            scalable ? std::floor((grid.samples[i] - grid.low) * 65535.0 / span + 0.5) : 0.0;
        map.texels[i] = static_cast<std::uint16_t>(std::clamp(scaled, 0.0, 65535.0));
    }
    map.has_elevation = grid.metres;
    if (grid.metres) {
        map.elevation_low_m = grid.low;
        map.elevation_high_m = grid.high;
    }
    return map;
}

void measure_range(ElevationGrid& grid) {
    grid.measured = true;
    bool found = false;
    for (const double sample : grid.samples) {
        if (!std::isfinite(sample)) continue;
        grid.low = found ? std::min(grid.low, sample) : sample;
        grid.high = found ? std::max(grid.high, sample) : sample;
        found = true;
    }
}

Result<HeightMap> crop(const HeightMap& map, int x, int y, int width, int height) {
    const bool inside = x >= 0 && y >= 0 && width > 0 && height > 0 && width <= map.width - x &&
                        height <= map.height - y;
    if (!inside) {
        const auto n = [](int value) { return std::to_string(value); };
        return Error{ErrorKind::Input, "",
                     "the crop [" + n(x) + ", " + n(y) + ", " + n(width) + ", " + n(height) +
                         "] is not inside the map",
                     "a part of 0.." + n(map.width - 1) + " x 0.." + n(map.height - 1), ""};
    }
    HeightMap part = map;
    part.width = width;
    part.height = height;
    part.texels.clear();
    part.texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int row = y; row < y + height; ++row) {
        for (int column = x; column < x + width; ++column)
            part.texels.push_back(map.at(column, row));
    }
    return part;
}

void flip_rows(HeightMap& map) {
    const auto width = static_cast<std::ptrdiff_t>(map.width);
    for (int low = 0, high = map.height - 1; low < high; ++low, --high) {
        std::swap_ranges(map.texels.begin() + low * width, map.texels.begin() + (low + 1) * width,
                         map.texels.begin() + high * width);
    }
}

HeightMap resample(const HeightMap& map, int width, int height) {
    HeightMap result = map;
    result.width = width;
    result.height = height;
    result.texels.clear();
    result.texels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const std::vector<Cover> columns = covers(map.width, width);
    const std::vector<Cover> rows = covers(map.height, height);
    // Weights add up to old width * old height < 2^28, so a sum stays below 2^44.
    const std::int64_t total = std::int64_t{map.width} * map.height;
    for (const Cover& row : rows) {
        for (const Cover& column : columns) {
            std::int64_t sum = 0;
            for (std::size_t j = 0; j < row.weights.size(); ++j) {
                std::int64_t line = 0;
                for (std::size_t i = 0; i < column.weights.size(); ++i) {
                    line += column.weights[i] * map.at(column.first + static_cast<int>(i),
                                                       row.first + static_cast<int>(j));
                }
                sum += row.weights[j] * line;
            }
            result.texels.push_back(static_cast<std::uint16_t>((2 * sum + total) / (2 * total)));
        }
    }
    return result;
}

}  // namespace repousse::host
