#pragma once

#include <cassert>
#include <cstdint>
#include <limits>

#include "datapath/numbers/counters.h"
#include "datapath/numbers/format.h"

namespace repousse {

/// The integers that one cast works with, computed once from (source fraction bits, target format).
///
/// Quantization. With r = bits to drop, h = 2^(r-1), neg = x < 0, odd = bit r of x (the last bit
/// kept): y = (x + bias) >> r, an arithmetic shift. In hardware the same is floor plus carry, with
/// g = bit r-1 and t = OR of the bits below it:
///
///   mode            bias              bias +if_negative +if_odd   carry into the floor
///   SC_TRN          0                 0      0          0         0
///   SC_TRN_ZERO     neg ? 2^r-1 : 0   0      2^r-1      0         neg & (g | t)
///   SC_RND          h                 h      0          0         g
///   SC_RND_MIN_INF  h-1               h-1    0          0         g & t
///   SC_RND_ZERO     h-1 + neg         h-1    1          0         g & (t | neg)
///   SC_RND_INF      h-1 + !neg        h      -1         0         g & (t | !neg)
///   SC_RND_CONV     h-1 + odd         h-1    0          1         g & (t | odd)
///
/// Overflow. low <= y <= high is left alone. Otherwise, with w = width and n = saturated bits,
/// the result is z = (y' & kept) | (y > high ? above : below), sign-extended from w bits:
///
///   mode              low         high       kept        above        below   y'
///   SC_SAT            min         max        0           max          min     y
///   SC_SAT_SYM        -max        max        0           max          -max    y
///   SC_SAT_ZERO       min         max        0           0            0       y
///   SC_WRAP n=0       min         max        2^w-1       0            0       y
///   SC_WRAP n>0       min         max        2^(w-n)-1   max & ~kept  min     y
///   SC_WRAP_SM n=0    as SC_WRAP n=0                      ~y if bit w != bit w-1, else y
///   SC_WRAP_SM n=1    as SC_WRAP n=1                      ~y if y < 0 != bit w-1, else y
///   SC_WRAP_SM n>1    as SC_WRAP n                        ~y if y < 0 == bit w-n, else y
///
/// (An unsigned format has min = 0, and SC_SAT_SYM is then SC_SAT.)
struct CastSteps {
    int left = 0;   ///< bits gained, exact; left and right are never both positive
    int right = 0;  ///< bits dropped: 0..63
    std::int64_t bias = 0;
    std::int64_t bias_if_negative = 0;
    std::int64_t bias_if_odd = 0;  ///< 0 or 1
    std::int64_t low = std::numeric_limits<std::int64_t>::min();
    std::int64_t high = std::numeric_limits<std::int64_t>::max();
    std::int64_t kept = 0;
    std::int64_t above = std::numeric_limits<std::int64_t>::max();
    std::int64_t below = std::numeric_limits<std::int64_t>::min();
    /// y' = ~y if bit flip_a of y XOR bit flip_b XOR flip_odd; a == b and 0 mean never.
    int flip_a = 0;
    int flip_b = 0;
    int flip_odd = 0;
    int unused = 0;  ///< bits above the container in an int64_t, for the sign extension
};

/// Fills the table above. Precondition: check_format(to) holds. Shifts are cut to 63 bits: dropping
/// more than that gives the same for every x of a Cast's range but -2^62 itself.
CastSteps make_steps(int source_frac, const Format& to);

/// The shape of the inner loop. General is the whole table, without a branch; the others are its
/// frequent cases and give the same. In all but General no bits are gained.
enum class CastKind : std::uint8_t {
    Clamp,         ///< constant bias and SC_SAT or SC_SAT_SYM: add, shift, two clamps
    Wrap,          ///< constant bias and SC_WRAP without saturated bits: add, shift, sign extension
    VaryingClamp,  ///< bias that looks at x, and SC_SAT or SC_SAT_SYM
    General,
};

/// A conversion into a Format, prepared once and applied to any number of raw integers.
///
/// Range: -2^62 <= x * 2^left < 2^62. Then x + bias fits int64_t: a positive bias is at most 2^62,
/// or, for SC_TRN_ZERO, at most 2^63 - 1 and added to a negative x only. prepare() checks the range
/// for a given source width; the constructor leaves it to the caller (an assert in debug builds).
class Cast {
public:
    /// Passes its argument unchanged and never overflows.
    Cast() = default;

    /// From raw integers with `source_frac` fraction bits. Preconditions as in make_steps.
    Cast(int source_frac, const Format& to) : Cast(make_steps(source_frac, to), to) {}

    /// From given steps; the format says which fast case they are, and is reported back.
    Cast(const CastSteps& steps, const Format& to);

    /// As the constructor, but refuses what is out of range: a signed source wider than 63 bits
    /// once shifted left, more than 62 bits dropped, and a format that check_format refuses. An
    /// unsigned source of n bits is a signed one of n + 1.
    static Result<Cast> prepare(int source_width, int source_frac, const Format& to);

    /// The value; no count.
    std::int64_t operator()(std::int64_t x) const { return dispatch(0, x); }

    /// Also adds 1 to `overflows` if the quantized value was out of range.
    std::int64_t operator()(std::int64_t x, std::uint64_t& overflows) const {
        return dispatch(0, x, overflows);
    }

    /// Also counts everything there is to count.
    std::int64_t operator()(std::int64_t x, CastCounters& counters) const {
        return dispatch(0, x, counters);
    }

    /// One step of a chain of multiply-adds: fit(sum + quantize(x)). `sum` is an accumulator in the
    /// target's fraction bits and has 62 bits at most, x an exact product in the source's. For
    /// SC_TRN, SC_RND and SC_RND_MIN_INF this is the cast of the exact sum; the other modes look at
    /// the sign or the last bit, here of x. Counters, if any, count as above.
    template <class... Counter>
    std::int64_t accumulate(std::int64_t sum, std::int64_t x, Counter&... counter) const {
        return dispatch(sum, x, counter...);
    }

    const Format& format() const { return format_; }
    const CastSteps& steps() const { return steps_; }
    CastKind kind() const { return kind_; }

    /// True if an overflow is a saturation: SC_SAT, SC_SAT_SYM and SC_SAT_ZERO.
    bool saturates() const {
        return format_.overflow != Overflow::SC_WRAP && format_.overflow != Overflow::SC_WRAP_SM;
    }

    /// log2 of the unit, in source LSB, in which CastCounters measures errors.
    int error_shift() const { return error_shift_; }

    /// The halves of a cast, for the batch kernels, which choose kKind (kind() or General) once.
    /// First half: x in the target's LSB, not yet in its range.
    template <CastKind kKind>
    std::int64_t quantize(std::int64_t x) const {
        assert(-(kReach >> steps_.left) <= x && x < (kReach >> steps_.left));
        if constexpr (kKind == CastKind::General) x = shift_left(x, steps_.left);
        return (x + bias<kKind>(x)) >> steps_.right;
    }

    /// Second half: y in the target's range. Overflow handling replaces every y out of range and no
    /// other, so `fit(y) != y` is the overflow flag in every mode.
    template <CastKind kKind>
    std::int64_t fit(std::int64_t y) const {
        if constexpr (kKind == CastKind::Clamp || kKind == CastKind::VaryingClamp) {
            const bool under = y < steps_.low;  // before the other clamp: both compare at once
            y = y > steps_.high ? steps_.high : y;
            y = under ? steps_.low : y;
            return y;
        } else if constexpr (kKind == CastKind::Wrap) {
            return extend(y & steps_.kept);
        } else {
            const bool over = y > steps_.high;
            const bool under = y < steps_.low;
            const std::int64_t flip = ((y >> steps_.flip_a) ^ (y >> steps_.flip_b)) & 1;
            const std::int64_t top = over ? steps_.above : steps_.below;
            const std::int64_t z = ((y ^ -(flip ^ steps_.flip_odd)) & steps_.kept) | top;
            return (over | under) ? extend(z) : y;
        }
    }

    /// What quantize<kKind>(x) adds to x, in source LSB. With t = x + bias the result stands for
    /// t - (t mod 2^r), so that is bias - (t mod 2^r); its magnitude is below 2^r.
    template <CastKind kKind>
    std::int64_t error(std::int64_t x) const {
        const std::int64_t added = bias<kKind>(x);
        const std::uint64_t mask = (std::uint64_t{1} << steps_.right) - 1;
        return added - static_cast<std::int64_t>(static_cast<std::uint64_t>(x + added) & mask);
    }

private:
    /// End of the range of sources, after the shift left.
    static constexpr std::int64_t kReach = std::int64_t{1} << 62;
    /// Squares of 26-bit errors have 52 bits, so that a kernel can add up a block of them in 64.
    static constexpr int kErrorBits = 26;

    static std::int64_t shift_left(std::int64_t x, int bits) {
        return static_cast<std::int64_t>(static_cast<std::uint64_t>(x) << bits);
    }

    /// Copies the top bit of the container into the unused bits above it.
    std::int64_t extend(std::int64_t z) const {
        return shift_left(z, steps_.unused) >> steps_.unused;
    }

    template <CastKind kKind>
    std::int64_t bias(std::int64_t x) const {
        if constexpr (kKind == CastKind::Clamp || kKind == CastKind::Wrap) return steps_.bias;
        const auto kept = static_cast<std::int64_t>(static_cast<std::uint64_t>(x) >> steps_.right);
        return steps_.bias + ((x >> 63) & steps_.bias_if_negative) + (kept & steps_.bias_if_odd);
    }

    /// The common kind is decided here, so that it is inlined into every datapath; the others stay
    /// behind a call.
    template <class... Counter>
    std::int64_t dispatch(std::int64_t sum, std::int64_t x, Counter&... counter) const {
        if (kind_ == CastKind::Clamp) return apply<CastKind::Clamp>(sum, x, counter...);
        return dispatch_others(sum, x, counter...);
    }

    template <class... Counter>
    [[gnu::noinline]] std::int64_t dispatch_others(std::int64_t sum, std::int64_t x,
                                                   Counter&... counter) const {
        if (kind_ == CastKind::Wrap) return apply<CastKind::Wrap>(sum, x, counter...);
        if (kind_ == CastKind::VaryingClamp) {
            return apply<CastKind::VaryingClamp>(sum, x, counter...);
        }
        return apply<CastKind::General>(sum, x, counter...);
    }

    template <CastKind kKind, class... Counter>
    std::int64_t apply(std::int64_t sum, std::int64_t x, Counter&... counter) const {
        const std::int64_t wanted = sum + quantize<kKind>(x);
        const std::int64_t value = fit<kKind>(wanted);
        (count<kKind>(wanted, value, x, counter), ...);
        return value;
    }

    template <CastKind kKind>
    void count(std::int64_t wanted, std::int64_t value, std::int64_t,
               std::uint64_t& overflows) const {
        overflows += value != wanted;
    }

    template <CastKind kKind>
    void count(std::int64_t wanted, std::int64_t value, std::int64_t x,
               CastCounters& counters) const {
        counters.count(wanted, value != wanted, error<kKind>(x) >> error_shift_);
    }

    CastSteps steps_;
    CastKind kind_ = CastKind::Clamp;
    int error_shift_ = 0;
    Format format_ = {kMaxWidth, 0, true};
};

}  // namespace repousse
