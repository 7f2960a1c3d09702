#pragma once

#include <cstdint>

namespace repousse {

/// floor(a / b) for b > 0.
inline int64_t floor_divide(int64_t a, int64_t b) {
    const int64_t q = a / b;
    return q - static_cast<int64_t>(a % b < 0);
}

/// The exact form of a / b: floor, and twice the rest. 0 < b < 2^30, so that twice the rest fits.
inline void divide(int64_t a, int64_t b, int64_t& quotient, int32_t& doubled_rest) {
    quotient = floor_divide(a, b);
    doubled_rest = static_cast<int32_t>(2 * (a - quotient * b));
}

}  // namespace repousse
