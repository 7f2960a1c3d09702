#include "datapath/numbers/functions.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

// Fixed-point notation: u1.31 has one integer and 31 fraction bits. Capital letters are the values,
// small letters the integers that stand for them: D = d * 2^-32, Y = y * 2^-31.

namespace repousse {
namespace {

constexpr std::uint64_t one_at(int bit) { return std::uint64_t{1} << bit; }

/// 1 in the format of Y, u1.31; 2 needs one integer bit more.
constexpr std::int64_t kOne = std::int64_t{1} << 31;

/// A seed has index_bits + 3 fraction bits: its rounding error is an eighth of the error that comes
/// from the width of its interval.
constexpr int seed_frac(int index_bits) { return index_bits + 3; }

int leading_zeros(std::uint64_t x) { return __builtin_clzll(x); }

/// floor(sqrt(x)), bit by bit.
std::uint64_t integer_sqrt(std::uint64_t x) {
    std::uint64_t root = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const std::uint64_t trial = root | one_at(bit);
        if (trial * trial <= x) root = trial;
    }
    return root;
}

/// Renormalises a mantissa that was rounded up to 2^bits, which is one bit too long.
Scaled normalised(std::uint64_t mantissa, int exponent, int bits) {
    const int carry = static_cast<int>(mantissa >> bits);
    return {static_cast<std::int64_t>(mantissa >> carry), exponent - carry};
}

Scaled largest(int mantissa_bits) {
    return {static_cast<std::int64_t>(one_at(mantissa_bits) - 1), mantissa_bits - 1};
}

}  // namespace

Reciprocal::Reciprocal(int index_bits, int newton_steps, int mantissa_bits)
    : index_bits_(index_bits), newton_steps_(newton_steps), mantissa_bits_(mantissa_bits) {
    assert(1 <= index_bits && index_bits <= kMaxIndexBits);
    assert(0 <= newton_steps && newton_steps <= kMaxNewtonSteps);
    assert(2 <= mantissa_bits && mantissa_bits <= kMaxMantissaBits);
    // Interval i is D = (2^k + i .. 2^k + i + 1) / 2^(k+1), its middle odd / 2^(k+2). The
    // reciprocal of the middle makes the relative errors at both ends equal: 2^-(k+1) at most.
    const std::uint64_t scale = one_at(seed_frac(index_bits) + index_bits + 2);
    for (std::uint64_t i = 0; i < one_at(index_bits); ++i) {
        const std::uint64_t odd = 2 * (one_at(index_bits) + i) + 1;
        seeds_.push_back(static_cast<std::uint32_t>((scale + odd / 2) / odd));
    }
}

Scaled Reciprocal::operator()(std::uint64_t x) const {
    if (x == 0) return largest(mantissa_bits_);
    const int shift = leading_zeros(x);
    const std::uint64_t d = (x << shift) >> 32;  // D in [1/2, 1), u0.32, top bit 1

    const std::uint64_t index = (d >> (31 - index_bits_)) - one_at(index_bits_);
    const std::uint64_t seed = seeds_[static_cast<std::size_t>(index)];
    std::int64_t y = static_cast<std::int64_t>(seed << (31 - seed_frac(index_bits_)));  // u1.31

    for (int step = 0; step < newton_steps_; ++step) {
        // E = 1 - D Y. 32 x 33 bits; the product is below 2^64 because D Y < 1 + 1/2.
        const std::uint64_t dy = d * static_cast<std::uint64_t>(y);
        const auto residue = static_cast<std::int64_t>(one_at(63) - dy);  // s0.63, |E| < 1/2
        const std::int64_t e = (residue + (std::int64_t{1} << 31)) >> 32;
        // Y (1 + E): 33 x 31 bits, below 2^63. Few bits or rounding may leave 1..2, the range of
        // 1/D.
        y += (y * e + (std::int64_t{1} << 30)) >> 31;
        y = std::clamp(y, kOne, 2 * kOne);
    }

    // q = 2^(31+p) / d to nearest. Iteration leaves it within one unit of that; the remainder,
    // which is exact (q d <= 2^31 * 2^32), tells which way. There are no ties: 2^n is no odd
    // multiple.
    const int dropped = 32 - mantissa_bits_;
    std::int64_t q = (y + (std::int64_t{1} << (dropped - 1))) >> dropped;
    const auto divisor = static_cast<std::int64_t>(d);
    const auto numerator = static_cast<std::int64_t>(one_at(31 + mantissa_bits_));
    const std::int64_t twice_remainder = 2 * (numerator - q * divisor);
    q += (twice_remainder > divisor) - (twice_remainder < -divisor);
    return normalised(static_cast<std::uint64_t>(q), 63 + mantissa_bits_ - shift, mantissa_bits_);
}

InverseSqrt::InverseSqrt(int index_bits, int newton_steps, int mantissa_bits)
    : index_bits_(index_bits), newton_steps_(newton_steps), mantissa_bits_(mantissa_bits) {
    assert(2 <= index_bits && index_bits <= kMaxIndexBits);
    assert(0 <= newton_steps && newton_steps <= kMaxNewtonSteps);
    assert(2 <= mantissa_bits && mantissa_bits <= kMaxMantissaBits);
    // Middle of interval j: D = odd / 2^(k+2) in the low octave, odd / 2^(k+1) in the high one. The
    // seed is sqrt(2^(2s) / D), found as floor(2 seed) with s <= 15, hence at most 46 bits, then
    // rounded.
    const std::uint64_t half = one_at(index_bits - 1);
    for (int octave = 0; octave < 2; ++octave) {
        const int scale = 2 * seed_frac(index_bits) + 2 + index_bits + 2 - octave;
        for (std::uint64_t j = 0; j < half; ++j) {
            const std::uint64_t odd = 2 * (half + j) + 1;
            const std::uint64_t twice_seed = integer_sqrt(one_at(scale) / odd);
            seeds_.push_back(static_cast<std::uint32_t>((twice_seed + 1) / 2));
        }
    }
}

Scaled InverseSqrt::operator()(std::uint64_t x) const {
    if (x == 0) return largest(mantissa_bits_);
    const int shift = leading_zeros(x) & ~1;     // even, so that its root is a shift, too
    const std::uint64_t d = (x << shift) >> 32;  // D in [1/4, 1), u0.32

    const std::uint64_t octave = d >> 31;
    const std::uint64_t half = one_at(index_bits_ - 1);
    const std::uint64_t j = (d >> (31 + static_cast<int>(octave) - index_bits_)) - half;
    const std::uint64_t seed = seeds_[static_cast<std::size_t>(octave * half + j)];
    std::int64_t y = static_cast<std::int64_t>(seed << (31 - seed_frac(index_bits_)));  // u1.31

    for (int step = 0; step < newton_steps_; ++step) {
        // Y^2: 32 x 32 bits, u2.62, rounded to u2.30. An error of 2^-31 in Y^2 moves Y by 2^-32.
        const auto wide = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(y);
        const std::uint64_t square = (wide + one_at(31)) >> 32;
        // E = 1 - D Y^2: 32 x 32 bits, s1.62, rounded to 31 fraction bits; |E| < 1.
        const auto residue = static_cast<std::int64_t>(one_at(62) - d * square);
        const std::int64_t e = (residue + (std::int64_t{1} << 30)) >> 31;
        // Y (1 + E / 2): 32 x 32 bits with sign, below 2^63. Y = 2, for D = 1/4, is held just
        // below.
        y += (y * e + (std::int64_t{1} << 31)) >> 32;
        y = std::clamp(y, kOne, 2 * kOne - 1);
    }

    // Rounding three bits or more away takes the value just below 2 to 2 exactly.
    const int dropped = 32 - mantissa_bits_;
    const std::uint64_t q = (static_cast<std::uint64_t>(y) + one_at(dropped - 1)) >> dropped;
    return normalised(q, 31 + mantissa_bits_ - shift / 2, mantissa_bits_);
}

}  // namespace repousse
