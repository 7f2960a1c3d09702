#include "testbench/host/map/displacement_bound.h"

#include <algorithm>
#include <cmath>

namespace repousse::host {
namespace {

/// A range of texel indices along one axis as at most two pieces of the map.
struct Pieces {
    int count = 0;
    std::array<std::array<int, 2>, 2> ends{};  // first and last, both included

    void add(int first, int last) { ends[static_cast<std::size_t>(count++)] = {first, last}; }
};

Pieces pieces(double low, double high, int size, bool wrap) {
    // Bilinear reads reach half a texel beyond a coordinate, rounding much less than one.
    constexpr double kReach = 1.5;
    const double first = std::floor(low - kReach);
    const double last = std::floor(high + kReach);
    Pieces result;
    if (!wrap) {
        const double end = size - 1;
        result.add(static_cast<int>(std::clamp(first, 0.0, end)),
                   static_cast<int>(std::clamp(last, 0.0, end)));
    } else if (last - first + 1 >= size) {
        result.add(0, size - 1);
    } else {
        const auto start = static_cast<int>(first - std::floor(first / size) * size);
        const int end = start + static_cast<int>(last - first);
        result.add(start, std::min(end, size - 1));
        if (end >= size) result.add(0, end - size);
    }
    return result;
}

}  // namespace

DisplacementBound::DisplacementBound(const HeightMap& map, double slack)
    : wrap_(map.wrap), low_(map.range_low), per_lsb_(map.world_per_lsb()), slack_(slack) {
    Level texels{map.width, map.height, {}};
    texels.blocks.reserve(map.texels.size());
    for (const uint16_t h : map.texels) texels.blocks.push_back({h, h});
    levels_.push_back(std::move(texels));
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level& fine = levels_.back();
        Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
        coarse.blocks.resize(static_cast<std::size_t>(coarse.width) *
                             static_cast<std::size_t>(coarse.height));
        for (int y = 0; y < fine.height; ++y) {
            for (int x = 0; x < fine.width; ++x) {
                coarse
                    .blocks[static_cast<std::size_t>(y / 2) *
                                static_cast<std::size_t>(coarse.width) +
                            static_cast<std::size_t>(x / 2)]
                    .include(fine.at(x, y));
            }
        }
        levels_.push_back(std::move(coarse));
    }
}

void DisplacementBound::collect(std::size_t level, int x, int y, const Box& box,
                                Range& range) const {
    const Level& blocks = levels_[level];
    if (x >= blocks.width || y >= blocks.height) return;
    const int x0 = x << level, x1 = ((x + 1) << level) - 1;
    const int y0 = y << level, y1 = ((y + 1) << level) - 1;
    if (x1 < box.x0 || x0 > box.x1 || y1 < box.y0 || y0 > box.y1) return;
    if (level == 0 || (x0 >= box.x0 && x1 <= box.x1 && y0 >= box.y0 && y1 <= box.y1)) {
        range.include(blocks.at(x, y));
        return;
    }
    for (int k = 0; k < 4; ++k) collect(level - 1, 2 * x + k % 2, 2 * y + k / 2, box, range);
}

double DisplacementBound::displacement(const Range& range) const {
    return std::max(std::abs(low_ + range.least * per_lsb_),
                    std::abs(low_ + range.greatest * per_lsb_)) +
           slack_;
}

double DisplacementBound::operator()(glm::dvec2 low, glm::dvec2 high) const {
    const Pieces columns = pieces(low.x, high.x, levels_[0].width, wrap_);
    const Pieces rows = pieces(low.y, high.y, levels_[0].height, wrap_);
    Range range;
    for (int i = 0; i < columns.count; ++i) {
        for (int j = 0; j < rows.count; ++j) {
            const auto& c = columns.ends[static_cast<std::size_t>(i)];
            const auto& r = rows.ends[static_cast<std::size_t>(j)];
            collect(levels_.size() - 1, 0, 0, {c[0], r[0], c[1], r[1]}, range);
        }
    }
    return displacement(range);
}

double DisplacementBound::of_triangle(const std::array<Uv, 3>& corners, int frac) const {
    const auto& [a, b, c] = corners;
    const auto texels = [frac](int32_t raw) { return std::ldexp(raw, -frac); };
    return (*this)({texels(std::min({a.x, b.x, c.x})), texels(std::min({a.y, b.y, c.y}))},
                   {texels(std::max({a.x, b.x, c.x})), texels(std::max({a.y, b.y, c.y}))});
}

double DisplacementBound::whole() const { return displacement(levels_.back().at(0, 0)); }

double stored_height_slack(const Profile& profile, const HeightMap& map) {
    return std::abs(map.range_high - map.range_low) / static_cast<double>(profile.height.max_raw());
}

}  // namespace repousse::host
