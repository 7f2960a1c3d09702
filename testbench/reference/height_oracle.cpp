#include "testbench/reference/height_oracle.h"

#include <algorithm>
#include <cstdlib>

namespace repousse::reference {
namespace {

__extension__ using Wide = __int128;

/// [lo, hi) along one axis.
struct Interval {
    int64_t lo, hi;
};

Interval interval(const HeightOracle& o, int64_t centre, int64_t half, int64_t size) {
    const int64_t one = int64_t{1} << o.frac;
    Interval i{floor_divide(centre - half, one), floor_divide(centre + half, one)};
    if (!o.wrap) {
        i.lo = std::clamp<int64_t>(i.lo, 0, size);
        i.hi = std::clamp<int64_t>(i.hi, 0, size);
    }
    if (!o.sum && i.lo == i.hi) {
        if (!o.wrap && i.lo == size) {
            i.lo = size - 1;
        } else {
            i.hi = i.lo + 1;
        }
    }
    return i;
}

}  // namespace

int64_t floor_divide(int64_t a, int64_t b) { return (a - floor_modulo(a, b)) / b; }
int64_t floor_modulo(int64_t a, int64_t b) { return (a % b + b) % b; }

HeightOracle::Box HeightOracle::box(Point centre, Point half) const {
    const Interval x = interval(*this, centre[0], half[0], width);
    const Interval y = interval(*this, centre[1], half[1], height);
    Box box;
    for (int64_t j = y.lo; j < y.hi; ++j) {
        for (int64_t i = x.lo; i < x.hi; ++i) {
            const int64_t texel = floor_modulo(j, height) * width + floor_modulo(i, width);
            box.total += heights[static_cast<std::size_t>(texel)];
            ++box.texels;
        }
    }
    return box;
}

bool HeightOracle::operator()(Point u1, Point u2, Point u12) const {
    Point e{std::abs(u1[0] - u2[0]), std::abs(u1[1] - u2[1])};
    if (!literal) e[0] = e[1] = std::max(e[0], e[1]);
    const Box end1 = box(u1, {e[0] / 8, e[1] / 8});
    const Box end2 = box(u2, {e[0] / 8, e[1] / 8});
    const Box mid = box(u12, {e[0] / 4, e[1] / 4});
    const Wide s12 = mid.total;
    const Wide s = Wide(end1.total) + end2.total;
    if (sum) {
        const Wide d = s12 - 2 * s;
        return (d < 0 ? -d : d) > 2 * Wide(threshold);
    }
    const Wide a12 = mid.texels;
    const Wide a = Wide(end1.texels) + end2.texels;
    const Wide d = s12 * a - s * a12;
    return (d < 0 ? -d : d) > Wide(threshold) * a12 * a;
}

}  // namespace repousse::reference
