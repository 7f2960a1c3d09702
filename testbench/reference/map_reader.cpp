#include "testbench/reference/map_reader.h"

#include <algorithm>
#include <cmath>

namespace repousse::reference {

int64_t MapReader::texel(int64_t x, int64_t y) const {
    const auto inside = [this](int64_t i, int64_t size) {
        return wrap_ ? ((i % size) + size) % size : std::clamp<int64_t>(i, 0, size - 1);
    };
    const int64_t at = inside(y, map_.height) * map_.width + inside(x, map_.width);
    return map_.heights[static_cast<std::size_t>(at)];
}

double MapReader::height(const Uv& uv) const {
    if (!map_.bilinear) {
        const Uv at = texel_of(uv);
        return static_cast<double>(texel(at[0], at[1]));
    }
    // Texel centres lie at +1/2. Weights have at most 16 bits each, so every product is exact.
    const double x = static_cast<double>(uv[0]) / static_cast<double>(one_) - 0.5;
    const double y = static_cast<double>(uv[1]) / static_cast<double>(one_) - 0.5;
    const auto i = static_cast<int64_t>(std::floor(x));
    const auto j = static_cast<int64_t>(std::floor(y));
    const double s = x - std::floor(x);
    const double t = y - std::floor(y);
    const auto h = [this](int64_t a, int64_t b) { return static_cast<double>(texel(a, b)); };
    return (h(i, j) * (1 - s) + h(i + 1, j) * s) * (1 - t) +
           (h(i, j + 1) * (1 - s) + h(i + 1, j + 1) * s) * t;
}

double MapReader::slope(int64_t x, int64_t y, int axis) const {
    const int64_t size = axis == 0 ? map_.width : map_.height;
    if (size == 1) return 0.0;
    int64_t low = (axis == 0 ? x : y) - 1;
    int64_t high = low + 2;
    if (!wrap_) {
        low = std::max<int64_t>(low, 0);
        high = std::min(high, size - 1);
    }
    const int64_t rise =
        axis == 0 ? texel(high, y) - texel(low, y) : texel(x, high) - texel(x, low);
    const double run = static_cast<double>(high - low) * map_.texel_size[axis];
    return static_cast<double>(rise) * map_.scale / run;
}

glm::dvec3 MapReader::normal(const Uv& uv) const {
    Uv at = texel_of(uv);
    if (!wrap_) {
        at[0] = std::clamp<int64_t>(at[0], 0, map_.width - 1);
        at[1] = std::clamp<int64_t>(at[1], 0, map_.height - 1);
    }
    const double dx = slope(at[0], at[1], 0);
    const double dy = slope(at[0], at[1], 1);
    const double length = std::sqrt(dx * dx + dy * dy + 1.0);
    return {-dx / length, -dy / length, 1.0 / length};
}

std::array<int64_t, 2> MapReader::side(int64_t centre, int64_t half, int64_t size,
                                       bool widen) const {
    int64_t lo = floor_of(centre - half);
    int64_t hi = floor_of(centre + half);
    if (!wrap_) {
        lo = std::clamp<int64_t>(lo, 0, size);
        hi = std::clamp<int64_t>(hi, 0, size);
    }
    if (hi <= lo && widen) {
        if (!wrap_ && lo == size) lo = size - 1;
        hi = lo + 1;
    }
    return {lo, hi};
}

MapBox MapReader::box(const Uv& centre, const Uv& half, bool widen) const {
    const auto x = side(centre[0], half[0], map_.width, widen);
    const auto y = side(centre[1], half[1], map_.height, widen);
    MapBox box;
    for (int64_t j = y[0]; j < y[1]; ++j) {
        for (int64_t i = x[0]; i < x[1]; ++i) box.sum += texel(i, j), ++box.area;
    }
    return box;
}

}  // namespace repousse::reference
