#pragma once

#include <cstddef>
#include <cstdint>

#include "datapath/sweep_items.h"

namespace repousse::setup {

// What the files of triangle_setup share.

inline int64_t floor_divide(int64_t a, int64_t b) {
    const int64_t q = a / b;
    return q - static_cast<int64_t>(a % b < 0);
}

// The exact form of a / b: floor, and twice the rest. Divisors are at most 2^26.
inline void divide(int64_t a, int64_t b, int64_t& quotient, int32_t& doubled_rest) {
    quotient = floor_divide(a, b);
    doubled_rest = static_cast<int32_t>(2 * (a - quotient * b));
}

inline int32_t at_least_one(int32_t steps) { return steps > 1 ? steps : 1; }

inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Whether an edge's steps are counted from `from`: the same answer for both triangles on the edge.
// Corners without ids of their own are told apart by their number.
inline bool is_canonical(const SweepTriangle& triangle, int from, int to) {
    const uint32_t p = triangle.corners[index(from)].id, q = triangle.corners[index(to)].id;
    return p != q ? p < q : from < to;
}

}  // namespace repousse::setup
