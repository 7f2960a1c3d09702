#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace repousse {

/// An unnormalised floating-point result: value = mantissa * 2^-exponent.
struct Scaled {
    std::int64_t mantissa = 0;
    int exponent = 0;
};

/// Most numbers in one batch. No power of two: arrays that lie behind each other would have their
/// elements of one index in the same few places of a cache.
inline constexpr std::size_t kFunctionBatch = 240;

/// 1/x of a positive integer: leading-zero normalisation, a table of seeds, Newton's iteration, and
/// one exact correction. Everything is integer; no product exceeds 64 bits, so the same widths do
/// in hardware (functions.cpp has them beside each line).
///
/// With `converged()`, the mantissa is 1/x rounded to nearest, x being cut to its 32 leading bits:
/// - |relative error| <= 2^-mantissa_bits for x < 2^32, plus 2^-31 beyond;
/// - monotone: x <= y implies 1/x >= 1/y;
/// - 1/2^n is exact: mantissa 2^(mantissa_bits-1), exponent n + mantissa_bits - 1.
/// Otherwise the seeds' error shows: about 2^-(index_bits << newton_steps), and neither
/// monotonicity nor exactness is promised.
class Reciprocal {
public:
    static constexpr int kMaxIndexBits = 12;
    static constexpr int kMaxNewtonSteps = 5;
    static constexpr int kMaxMantissaBits = 31;

    /// A table of 2^index_bits seeds (1..kMaxIndexBits), 0..kMaxNewtonSteps iterations, and results
    /// of 2..kMaxMantissaBits bits. Values out of range are a programming mistake (assert).
    Reciprocal(int index_bits, int newton_steps, int mantissa_bits);

    /// 2^(mantissa_bits-1) <= mantissa < 2^mantissa_bits. x = 0 gives the largest mantissa with the
    /// exponent of x = 1: a value just below 2, larger than every other result.
    Scaled operator()(std::uint64_t x) const;

    /// The same for n <= kFunctionBatch positive numbers below 2^31, to two arrays.
    void operator()(const std::int32_t* x, std::size_t n, std::int32_t* mantissas,
                    std::int32_t* exponents) const;

    /// True if the configuration has the properties listed above.
    bool converged() const { return index_bits_ << newton_steps_ > mantissa_bits_; }

    /// The table as a ROM holds it: seed * 2^-(index_bits + 3) approximates 1/D at the middle of an
    /// interval of D in [1/2, 1). The top bit of the index_bits + 4 is always 1.
    const std::vector<std::uint32_t>& seeds() const { return seeds_; }

private:
    /// A number brought into [1/2, 1), and where the iteration starts.
    struct Start {
        std::uint32_t d;
        std::int32_t y;
        int shift;
    };
    Start start(std::uint64_t x) const;

    int index_bits_;
    int newton_steps_;
    int mantissa_bits_;
    std::vector<std::uint32_t> seeds_;
};

/// 1/sqrt(x) of a positive integer, by the same means but without the correction, whose product
/// would need 3 * 32 bits.
///
/// x being cut to its 31 or 32 leading bits, and i standing for index_bits << newton_steps:
/// - |relative error| <= 2^-mantissa_bits + 2^-i + 2^-30 for x < 2^31, plus 2^-31 beyond;
/// - with `converged()`, 1/sqrt(4^n) is exact: mantissa 2^(mantissa_bits-1), exponent
///   n + mantissa_bits - 1.
class InverseSqrt {
public:
    static constexpr int kMaxIndexBits = 12;
    static constexpr int kMaxNewtonSteps = 5;
    static constexpr int kMaxMantissaBits = 29;

    /// As Reciprocal's; index_bits is at least 2, since one of them says which octave x is in.
    InverseSqrt(int index_bits, int newton_steps, int mantissa_bits);

    /// Mantissa and x = 0 as for Reciprocal.
    Scaled operator()(std::uint64_t x) const;

    /// The same for n <= kFunctionBatch numbers, to two arrays. x = 0 gives what x = 1 does.
    void operator()(const std::int64_t* x, std::size_t n, std::int32_t* mantissas,
                    std::int32_t* exponents) const;

    /// True if the iteration's error is below half a unit of the mantissa.
    bool converged() const { return index_bits_ << newton_steps_ > mantissa_bits_; }

    /// The table as a ROM holds it: seed * 2^-(index_bits + 3) approximates 1/sqrt(D), first for
    /// the intervals of D in [1/4, 1/2), then for those in [1/2, 1).
    const std::vector<std::uint32_t>& seeds() const { return seeds_; }

private:
    /// A number brought into [1/4, 1), and where the iteration starts.
    struct Start {
        std::uint32_t d;
        std::uint32_t y;
        int shift;
    };
    Start start(std::uint64_t x) const;

    int index_bits_;
    int newton_steps_;
    int mantissa_bits_;
    std::vector<std::uint32_t> seeds_;
};

}  // namespace repousse
