#include "testbench/host/map/voids.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "datapath/map_view.h"

namespace repousse::host {
namespace {

/// Calls `visit(i)` for a texel's eight neighbours (with itself and, at a border, repetitions).
template <class Visit>
void for_neighbours(const ElevationGrid& grid, std::size_t texel, bool wrap, Visit visit) {
    const auto width = static_cast<std::size_t>(grid.width);
    const int x = static_cast<int>(texel % width);
    const int y = static_cast<int>(texel / width);
    for (int j = y - 1; j <= y + 1; ++j) {
        if (!wrap && (j < 0 || j >= grid.height)) continue;
        for (int i = x - 1; i <= x + 1; ++i) {
            if (!wrap && (i < 0 || i >= grid.width)) continue;
            visit(static_cast<std::size_t>(texel_address(j, grid.height, wrap)) * width +
                  static_cast<std::size_t>(texel_address(i, grid.width, wrap)));
        }
    }
}

/// Mean of the valid neighbours of a void; NaN when there is none.
double rim_mean(const ElevationGrid& grid, std::size_t texel, bool wrap) {
    double sum = 0.0;
    int count = 0;
    for_neighbours(grid, texel, wrap, [&](std::size_t i) {
        if (!std::isfinite(grid.samples[i])) return;
        sum += grid.samples[i];
        ++count;
    });
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void mark_voids(ElevationGrid& grid, double value) {
    for (double& sample : grid.samples) {
        if (sample == value) sample = std::numeric_limits<double>::quiet_NaN();
    }
    if (grid.measured) measure_range(grid);
}

Status refuse_voids(const ElevationGrid& grid, const std::string& name) {
    for (std::size_t i = 0; i < grid.samples.size(); ++i) {
        if (std::isfinite(grid.samples[i])) continue;
        const auto width = static_cast<std::size_t>(grid.width);
        return Error{ErrorKind::Input, name,
                     "texel (" + std::to_string(i % width) + ", " + std::to_string(i / width) +
                         ") is not finite",
                     "finite heights", "fill_voids = true fills such texels"};
    }
    return done();
}

Result<std::size_t> fill_voids(ElevationGrid& grid, bool wrap, const std::string& name) {
    // Voids to look at in this round: at first all, then those beside what was just filled.
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < grid.samples.size(); ++i) {
        if (!std::isfinite(grid.samples[i])) front.push_back(i);
    }
    const std::size_t filled = front.size();
    if (filled == grid.samples.size()) {
        return Error{ErrorKind::Input, name, "no texel has a height: all are voids",
                     "at least one finite height", ""};
    }
    std::vector<std::pair<std::size_t, double>> rim;
    std::vector<bool> waiting(grid.samples.size());
    while (!front.empty()) {
        rim.clear();
        for (const std::size_t i : front) {
            waiting[i] = false;
            const double mean = rim_mean(grid, i, wrap);
            if (std::isfinite(mean)) rim.emplace_back(i, mean);
        }
        for (const auto& [i, mean] : rim) grid.samples[i] = mean;
        front.clear();
        for (const auto& filled_now : rim) {
            for_neighbours(grid, filled_now.first, wrap, [&](std::size_t i) {
                if (std::isfinite(grid.samples[i]) || waiting[i]) return;
                waiting[i] = true;
                front.push_back(i);
            });
        }
    }
    return filled;
}

}  // namespace repousse::host
