#include "testbench/host/map/variational_level.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/level_surface.h"

namespace repousse::host {
namespace {

constexpr double kHeightStep = 1.0 / 64;  // of heights during the descent, so that sums are exact

double on_step(double height) { return std::floor(height / kHeightStep + 0.5) * kHeightStep; }

/// The difference volume with its derivatives by all vertices, in one pass over the map.
class VolumeSlope {
public:
    VolumeSlope(const HeightMap& map, int level, double epsilon) : map_(map), grid_(map, level) {
        const auto width = static_cast<std::size_t>(map.width);
        rise_left_.resize(width);
        rise_right_.resize(width);
        set_epsilon(epsilon);
        for (auto* line : {&low_, &high_, &volume_, &sums_[0], &sums_[1], &sums_[2], &sums_[3]}) {
            line->resize(width);
        }
        area_ = hat_sums(grid_, std::vector<double>(map.texels.size(), 1.0));
    }

    const LevelGrid& grid() const { return grid_; }

    /// `epsilon` in LSB; rounded to the heights' step, and at least one.
    void set_epsilon(double epsilon) {
        epsilon_ = std::max(kHeightStep, on_step(epsilon));
        for (std::size_t x = 0; x < rise_left_.size(); ++x) {
            rise_left_[x] = epsilon_ * (1.0 - grid_.x.fraction[x]);
            rise_right_[x] = epsilon_ * grid_.x.fraction[x];
        }
    }

    /// The mean |surface - map| below the hat of each vertex, LSB.
    std::vector<double> mean_differences(const std::vector<double>& heights) const {
        std::vector<double> difference = surface_of(grid_, heights);
        for (std::size_t i = 0; i < difference.size(); ++i) {
            difference[i] = std::abs(difference[i] - map_.texels[i]);
        }
        std::vector<double> means = hat_sums(grid_, difference);
        for (std::size_t i = 0; i < means.size(); ++i) means[i] /= area_[i];
        return means;
    }

    /// Volume of the surface over `heights`; `slope` becomes equation 12 of every vertex.
    ///
    /// Every texel is in the influenced area of four vertices: each is raised by epsilon in turn.
    /// What a texel adds is kept by columns over the rows of a cell, then folded into the vertices,
    /// so that the inner loop has neither branches nor scattered stores.
    double operator()(const std::vector<double>& heights, std::vector<double>& slope) {
        slope.assign(heights.size(), 0.0);
        const auto columns = static_cast<std::size_t>(grid_.x.vertices);
        double volume = 0.0;
        for (const LevelAxis::Cell& rows : grid_.y.cells) {
            const std::size_t low = static_cast<std::size_t>(rows.lower) * columns;
            const std::size_t high = static_cast<std::size_t>(rows.upper) * columns;
            stretch(heights.data() + low, low_);
            stretch(heights.data() + high, high_);
            for (auto* line : {&volume_, &sums_[0], &sums_[1], &sums_[2], &sums_[3]}) {
                std::fill(line->begin(), line->end(), 0.0);
            }
            for (int y = rows.begin; y < rows.end; ++y) add_row(y);
            for (const LevelAxis::Cell& cell : grid_.x.cells) {
                const auto left = static_cast<std::size_t>(cell.lower);
                const auto right = static_cast<std::size_t>(cell.upper);
                for (auto x = static_cast<std::size_t>(cell.begin);
                     x < static_cast<std::size_t>(cell.end); ++x) {
                    volume += volume_[x];
                    slope[low + left] += sums_[0][x];
                    slope[low + right] += sums_[1][x];
                    slope[high + left] += sums_[2][x];
                    slope[high + right] += sums_[3][x];
                }
            }
        }
        for (std::size_t i = 0; i < slope.size(); ++i) slope[i] /= epsilon_ * area_[i];
        return volume;
    }

private:
    using Line = std::vector<double>;

    /// A row of vertices, read between its columns at every texel.
    void stretch(const double* row, Line& line) const {
        for (const LevelAxis::Cell& cell : grid_.x.cells) {
            const double left = row[cell.lower];
            const double right = row[cell.upper];
            for (auto x = static_cast<std::size_t>(cell.begin);
                 x < static_cast<std::size_t>(cell.end); ++x) {
                line[x] = left + grid_.x.fraction[x] * (right - left);
            }
        }
    }

    void add_row(int y) {
        const auto width = static_cast<std::size_t>(map_.width);
        const std::uint16_t* texels = map_.texels.data() + static_cast<std::size_t>(y) * width;
        const double up = grid_.y.fraction[static_cast<std::size_t>(y)];
        const double down = 1.0 - up;
        const double *low = low_.data(), *high = high_.data();
        const double *left = rise_left_.data(), *right = rise_right_.data();
        double* volume = volume_.data();
        double *a = sums_[0].data(), *b = sums_[1].data();
        double *c = sums_[2].data(), *d = sums_[3].data();
        for (std::size_t x = 0; x < width; ++x) {
            const double over = low[x] + up * (high[x] - low[x]) - static_cast<double>(texels[x]);
            const double now = std::abs(over);
            volume[x] += now;
            a[x] += std::abs(over + down * left[x]) - now;
            b[x] += std::abs(over + down * right[x]) - now;
            c[x] += std::abs(over + up * left[x]) - now;
            d[x] += std::abs(over + up * right[x]) - now;
        }
    }

    const HeightMap& map_;
    LevelGrid grid_;
    double epsilon_ = 0.0;
    std::vector<double> area_;     // below each vertex's hat, texels; none is 0
    Line rise_left_, rise_right_;  // epsilon times the column's weight
    Line low_, high_;              // the cell's two rows of vertices at every texel
    Line volume_, sums_[4];        // of the cell's rows, by columns: lower left first
};

/// Whether the descent ends: see VariationalSettings.
bool finished(const std::vector<double>& volumes, double lambda,
              const VariationalSettings& settings) {
    const auto patience = static_cast<std::size_t>(settings.patience);
    const std::size_t steps = volumes.size() - 1;
    if (steps >= static_cast<std::size_t>(settings.steps)) return true;
    if (lambda < settings.least_lambda) return true;
    return steps >= patience &&
           volumes[steps - patience] - volumes[steps] < settings.least_fall * volumes[0];
}

}  // namespace

VariationalLevel variational_level(const HeightMap& map, int level,
                                   const VariationalSettings& settings) {
    VariationalLevel result;
    result.map = average_level(map, level);
    const double epsilon = settings.epsilon * 65535.0;
    VolumeSlope slopes(map, level, epsilon);
    std::vector<double> heights(result.map.texels.begin(), result.map.texels.end());
    std::vector<double> before(heights), slope, next(heights.size()), next_slope;
    double volume = slopes(heights, slope);
    const double start = volume;
    const std::vector<double> units = slopes.mean_differences(heights);
    result.volumes.push_back(start);
    double lambda = 1.0;
    int run = 0;  // steps since the last one taken back
    while (volume > 0 && !finished(result.volumes, lambda, settings)) {
        const double momentum = run / (run + 3.0);
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const double moved =
                heights[i] + momentum * (heights[i] - before[i]) - lambda * units[i] * slope[i];
            next[i] = std::clamp(on_step(moved), 0.0, 65535.0);
        }
        const double next_volume = slopes(next, next_slope);
        if (next_volume < volume) {
            volume = next_volume;
            before.swap(heights);
            heights.swap(next);
            slope.swap(next_slope);
            ++run;
        } else {
            if (run == 0) slopes.set_epsilon(epsilon * (lambda /= 2));
            before = heights;
            run = 0;
        }
        result.volumes.push_back(volume);
    }
    // Rounding may undo a fall of less than half an LSB a texel: then the average stays.
    std::vector<double> rounded(heights);
    for (double& h : rounded) h = std::floor(h + 0.5);
    result.volume = difference_volume(map, slopes.grid(), rounded);
    if (result.volume < result.volumes[0]) {
        std::transform(rounded.begin(), rounded.end(), result.map.texels.begin(),
                       [](double h) { return static_cast<std::uint16_t>(h); });
    } else {
        result.volume = result.volumes[0];
    }
    return result;
}

}  // namespace repousse::host
