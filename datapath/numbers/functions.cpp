#include "datapath/numbers/functions.h"

#include <cassert>
#include <cstddef>
#include <limits>

#include "datapath/numbers/vector_clones.h"

// Fixed-point notation: u1.31 has one integer and 31 fraction bits. Capital letters are the values,
// small letters the integers that stand for them: D = d * 2^-32, Y = y * 2^-31.

namespace repousse {
namespace {

constexpr std::uint64_t one_at(int bit) { return std::uint64_t{1} << bit; }

/// A seed has index_bits + 3 fraction bits: its rounding error is an eighth of the error that comes
/// from the width of its interval.
constexpr int seed_frac(int index_bits) { return index_bits + 3; }

/// The least value of a Y that is held as its difference from 2: Y = 1.
constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();

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

// ---- the iteration of 1/x
// ------------------------------------------------------------------------
//
// Y lies in [1, 2], both ends included; it is held as y - 2^32, which has 32 bits, and products are
// formed modulo 2^64 from factors of 32 bits, as vector registers have them.

std::int32_t below_two(std::uint64_t y) { return static_cast<std::int32_t>(y - one_at(32)); }

/// E = 1 - D Y, |E| < 1/2, rounded to s.31. D Y < 1 + 1/2, so the exact one is s0.63.
inline std::int32_t residue(std::uint32_t d, std::int32_t y) {
    const auto low = static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(d)} * y);
    const std::uint64_t high = static_cast<std::uint64_t>(d) + static_cast<std::uint64_t>(y);
    const std::uint64_t exact = one_at(63) - (low + (high << 32));
    return static_cast<std::int32_t>((exact + one_at(31)) >> 32);
}

/// Y (1 + E), clamped: few bits or rounding may leave 1..2, the range of 1/D. Y E is below 2^63.
inline std::int32_t corrected(std::int32_t y, std::int32_t e) {
    const std::int64_t product = std::int64_t{y} * e + e * (std::int64_t{1} << 32);
    std::int64_t next = y + ((product + (std::int64_t{1} << 30)) >> 31);
    next = next > 0 ? 0 : next;
    next = next < kLeast ? kLeast : next;
    return static_cast<std::int32_t>(next);
}

/// 2^(31+p) / d to nearest. Iteration leaves it within one unit of that; the remainder, which is
/// exact (q d <= 2^31 * 2^32), tells which way. There are no ties: 2^n is no odd multiple.
inline std::uint32_t nearest_quotient(std::uint32_t d, std::int32_t y, int p) {
    const int dropped = 32 - p;
    const std::uint64_t rounded = static_cast<std::uint64_t>(y) + one_at(32) + one_at(dropped - 1);
    const auto q = static_cast<std::uint32_t>(rounded >> dropped);
    const std::int64_t divisor = d;
    const std::uint64_t product = std::uint64_t{q} * d;
    const auto twice_remainder = static_cast<std::int64_t>(2 * (one_at(31 + p) - product));
    return q + (twice_remainder > divisor) - (twice_remainder < -divisor);
}

REPOUSSE_VECTOR_CLONES
void reciprocal_step(const std::uint32_t* d, std::int32_t* y, std::size_t n) {
    std::int32_t e[kFunctionBatch];
    for (std::size_t i = 0; i < n; ++i) e[i] = residue(d[i], y[i]);
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) y[i] = corrected(y[i], e[i]);
}

REPOUSSE_VECTOR_CLONES
void nearest_quotients(const std::uint32_t* d, const std::int32_t* y, std::size_t n, int p,
                       std::int32_t* mantissas, std::int32_t* exponents) {
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t q = nearest_quotient(d[i], y[i], p);
        const std::uint32_t carry = q >> p;
        mantissas[i] = static_cast<std::int32_t>(q >> carry);
        exponents[i] -= static_cast<std::int32_t>(carry);
    }
}

// ---- the iteration of 1/sqrt(x)
// ------------------------------------------------------------------

/// Y^2: 32 x 32 bits, u2.62, rounded to u2.30. An error of 2^-31 in Y^2 moves Y by 2^-32.
inline std::uint32_t square(std::uint32_t y) {
    return static_cast<std::uint32_t>((std::uint64_t{y} * y + one_at(31)) >> 32);
}

/// E = 1 - D Y^2: 32 x 32 bits, s1.62, rounded to 31 fraction bits; |E| < 1.
inline std::int32_t residue(std::uint32_t d, std::uint32_t square) {
    return static_cast<std::int32_t>((one_at(62) + one_at(30) - std::uint64_t{d} * square) >> 31);
}

/// Y (1 + E / 2), clamped; Y = 2, for D = 1/4, is held just below. The product has 32 x 32 bits
/// with sign; y = 2^32 + (y - 2^32) makes its factor signed.
inline std::uint32_t corrected(std::uint32_t y, std::int32_t e) {
    const std::int64_t product = std::int64_t{static_cast<std::int32_t>(y)} * e;
    const auto rounded = static_cast<std::uint64_t>(product + (std::int64_t{1} << 31));
    const std::int32_t change = static_cast<std::int32_t>(rounded >> 32) + e;
    const auto next = static_cast<std::int32_t>(y + static_cast<std::uint32_t>(change));
    // Y - 2 is negative; a sum that is not has left the range, on the side of the change.
    const std::int32_t end = change < 0 ? kLeast : -1;
    return static_cast<std::uint32_t>(next < 0 ? next : end);
}

/// Rounding three bits or more away takes the value just below 2 to 2 exactly.
inline std::uint32_t rounded(std::uint32_t y, int p) {
    const int dropped = 32 - p;
    return static_cast<std::uint32_t>((y + one_at(dropped - 1)) >> dropped);
}

REPOUSSE_VECTOR_CLONES
void inverse_sqrt_step(const std::uint32_t* d, std::uint32_t* y, std::size_t n) {
    std::uint32_t squares[kFunctionBatch];
    std::int32_t e[kFunctionBatch];
    for (std::size_t i = 0; i < n; ++i) squares[i] = square(y[i]);
    for (std::size_t i = 0; i < n; ++i) e[i] = residue(d[i], squares[i]);
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) y[i] = corrected(y[i], e[i]);
}

REPOUSSE_VECTOR_CLONES
void rounded_roots(const std::uint32_t* y, std::size_t n, int p, std::int32_t* mantissas,
                   std::int32_t* exponents) {
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t q = rounded(y[i], p);
        const std::uint32_t carry = q >> p;
        mantissas[i] = static_cast<std::int32_t>(q >> carry);
        exponents[i] -= static_cast<std::int32_t>(carry);
    }
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

inline Reciprocal::Start Reciprocal::start(std::uint64_t x) const {
    const int shift = leading_zeros(x);
    const std::uint64_t d = (x << shift) >> 32;  // D in [1/2, 1), u0.32, top bit 1
    const std::uint64_t index = (d >> (31 - index_bits_)) - one_at(index_bits_);
    const std::uint64_t seed = seeds_[static_cast<std::size_t>(index)];
    const std::uint64_t y = seed << (31 - seed_frac(index_bits_));
    return {static_cast<std::uint32_t>(d), below_two(y), shift};
}

Scaled Reciprocal::operator()(std::uint64_t x) const {
    if (x == 0) return largest(mantissa_bits_);
    const Start s = start(x);
    std::int32_t y = s.y;
    for (int step = 0; step < newton_steps_; ++step) y = corrected(y, residue(s.d, y));
    const std::uint32_t q = nearest_quotient(s.d, y, mantissa_bits_);
    return normalised(q, 63 + mantissa_bits_ - s.shift, mantissa_bits_);
}

REPOUSSE_VECTOR_CLONES
void Reciprocal::operator()(const std::int32_t* x, std::size_t n, std::int32_t* mantissas,
                            std::int32_t* exponents) const {
    assert(n <= kFunctionBatch);
    std::uint32_t d[kFunctionBatch];
    std::int32_t y[kFunctionBatch];
    for (std::size_t i = 0; i < n; ++i) {
        const Start s = start(static_cast<std::uint64_t>(x[i]));
        d[i] = s.d;
        y[i] = s.y;
        exponents[i] = 63 + mantissa_bits_ - s.shift;
    }
    for (int step = 0; step < newton_steps_; ++step) reciprocal_step(d, y, n);
    nearest_quotients(d, y, n, mantissa_bits_, mantissas, exponents);
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

inline InverseSqrt::Start InverseSqrt::start(std::uint64_t x) const {
    const int shift = leading_zeros(x) & ~1;     // even, so that its root is a shift, too
    const std::uint64_t d = (x << shift) >> 32;  // D in [1/4, 1), u0.32
    const std::uint64_t octave = d >> 31;
    const std::uint64_t half = one_at(index_bits_ - 1);
    const std::uint64_t j = (d >> (31 + static_cast<int>(octave) - index_bits_)) - half;
    const std::uint64_t seed = seeds_[static_cast<std::size_t>(octave * half + j)];
    const std::uint64_t y = seed << (31 - seed_frac(index_bits_));  // u1.31
    return {static_cast<std::uint32_t>(d), static_cast<std::uint32_t>(y), shift};
}

Scaled InverseSqrt::operator()(std::uint64_t x) const {
    if (x == 0) return largest(mantissa_bits_);
    const Start s = start(x);
    std::uint32_t y = s.y;
    for (int step = 0; step < newton_steps_; ++step) y = corrected(y, residue(s.d, square(y)));
    return normalised(rounded(y, mantissa_bits_), 31 + mantissa_bits_ - s.shift / 2,
                      mantissa_bits_);
}

REPOUSSE_VECTOR_CLONES
void InverseSqrt::operator()(const std::int64_t* x, std::size_t n, std::int32_t* mantissas,
                             std::int32_t* exponents) const {
    assert(n <= kFunctionBatch);
    std::uint32_t d[kFunctionBatch], y[kFunctionBatch];
    for (std::size_t i = 0; i < n; ++i) {
        const Start s = start(static_cast<std::uint64_t>(x[i] == 0 ? 1 : x[i]));
        d[i] = s.d;
        y[i] = s.y;
        exponents[i] = 31 + mantissa_bits_ - s.shift / 2;
    }
    for (int step = 0; step < newton_steps_; ++step) inverse_sqrt_step(d, y, n);
    rounded_roots(y, n, mantissa_bits_, mantissas, exponents);
}

}  // namespace repousse
