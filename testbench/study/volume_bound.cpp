#include "testbench/study/volume_bound.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "testbench/host/map/filter_levels.h"

namespace repousse::study {
namespace {

using Values = std::vector<double>;

double dot(const Values& a, const Values& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// y := y - B (B'B)^-1 B'y by conjugate gradients, to about 1e-10 of B'y.
void project(const host::LevelGrid& grid, Values& y) {
    Values residual = hat_sums(grid, y);
    Values direction = residual, solution(residual.size()), spread, image;
    double square = dot(residual, residual);
    const double goal = 1e-20 * square;
    for (int i = 0; i < 300 && square > goal; ++i) {
        surface_of(grid, direction, spread);
        hat_sums(grid, spread, image);
        const double step = square / dot(direction, image);
        for (std::size_t k = 0; k < solution.size(); ++k) {
            solution[k] += step * direction[k];
            residual[k] -= step * image[k];
        }
        const double next = dot(residual, residual);
        for (std::size_t k = 0; k < direction.size(); ++k) {
            direction[k] = residual[k] + next / square * direction[k];
        }
        square = next;
    }
    surface_of(grid, solution, spread);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] -= spread[i];
}

/// What a dual vector proves.
double proven(const host::HeightMap& map, const host::LevelGrid& grid, Values y) {
    project(grid, y);
    double largest = 1.0;
    for (const double v : y) largest = std::max(largest, std::abs(v));
    double value = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) value -= y[i] * map.texels[i];
    for (const double left : hat_sums(grid, y)) value -= 65535.0 * std::abs(left);
    return value / largest;
}

}  // namespace

VolumeBound bound_volume(const host::HeightMap& map, int level, double enough, double near,
                         int iterations) {
    const host::LevelGrid grid(map, level);
    const host::HeightMap start = host::average_level(map, level);
    Values heights(start.texels.begin(), start.texels.end());
    Values ahead = heights, y(map.texels.size()), surface, pull;
    const Values area = hat_sums(grid, Values(y.size(), 1.0));
    VolumeBound result;
    result.found = difference_volume(map, grid, heights);
    // Step lengths 1 / scale at texels (whose weights add up to 1) and scale / area at vertices.
    const double scale = 2.0 * result.found / static_cast<double>(y.size());
    if (scale == 0.0) return result;
    for (int i = 1; i <= iterations; ++i) {
        surface_of(grid, ahead, surface);
        for (std::size_t p = 0; p < y.size(); ++p) {
            y[p] = std::clamp(y[p] + (surface[p] - map.texels[p]) / scale, -1.0, 1.0);
        }
        hat_sums(grid, y, pull);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            const double next = heights[k] - scale * pull[k] / area[k];
            ahead[k] = 2.0 * next - heights[k];
            heights[k] = next;
        }
        result.iterations = i;
        if (i % 100 != 0 && i != iterations) continue;
        Values inside(heights);
        for (double& h : inside) h = std::clamp(h, 0.0, 65535.0);
        result.found = std::min(result.found, difference_volume(map, grid, inside));
        result.least = std::max(result.least, proven(map, grid, y));
        if (result.least >= enough && result.least >= near * result.found) break;
    }
    return result;
}

}  // namespace repousse::study
