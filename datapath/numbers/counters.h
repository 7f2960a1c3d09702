#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace repousse {

/// A 128-bit sum: 2^64 squares of 26-bit errors need 116 bits. Value = high * 2^64 + low.
struct Sum128 {
    std::uint64_t low = 0;
    std::uint64_t high = 0;

    void add(const Sum128& other) {
        low += other.low;
        high += other.high + (low < other.low ? 1 : 0);
    }
};

inline bool operator==(const Sum128& a, const Sum128& b) {
    return a.low == b.low && a.high == b.high;
}
inline bool operator!=(const Sum128& a, const Sum128& b) { return !(a == b); }

/// What a quantising operation saw. Integers only, so that sums do not depend on the order in which
/// they were made: counting per batch and merging gives the same bits as counting value by value.
///
/// The error is what the quantization adds (result - exact, before overflow handling), in units of
/// 2^Cast::error_shift() source LSB: one source LSB unless more than 26 bits are dropped, when it
/// is cut to the unit below. Its largest magnitude needs no counting: it is one target LSB for
/// SC_TRN and SC_TRN_ZERO, half of one for the others.
struct CastCounters {
    std::uint64_t values = 0;     ///< casts counted
    std::uint64_t overflows = 0;  ///< results out of range, the overflow flag of IEEE 1666; with an
                                  ///< SC_SAT* mode (Cast::saturates()) these are the saturations
    /// Range of the quantized values before overflow handling, in target LSB: what the signal asked
    /// for, hence the width it needs. Empty (min > max) while values == 0.
    std::int64_t min = std::numeric_limits<std::int64_t>::max();
    std::int64_t max = std::numeric_limits<std::int64_t>::min();
    std::int64_t error_sum = 0;  ///< bias; |error| <= 2^26, so 2^37 values fit
    Sum128 error_squares;        ///< sum of squares

    /// Adds one cast: the quantized value before overflow handling, whether it was out of range,
    /// and the error of its quantization.
    void count(std::int64_t wanted, bool overflow, std::int64_t error) {
        ++values;
        overflows += overflow;
        min = wanted < min ? wanted : min;
        max = wanted > max ? wanted : max;
        error_sum += error;
        error_squares.add({static_cast<std::uint64_t>(error * error), 0});
    }

    /// Adds the counts of another run of the same cast.
    void merge(const CastCounters& other) {
        values += other.values;
        overflows += other.overflows;
        min = std::min(min, other.min);
        max = std::max(max, other.max);
        error_sum += other.error_sum;
        error_squares.add(other.error_squares);
    }
};

inline bool operator==(const CastCounters& a, const CastCounters& b) {
    return a.values == b.values && a.overflows == b.overflows && a.min == b.min && a.max == b.max &&
           a.error_sum == b.error_sum && a.error_squares == b.error_squares;
}
inline bool operator!=(const CastCounters& a, const CastCounters& b) { return !(a == b); }

}  // namespace repousse
