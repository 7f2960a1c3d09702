#include "datapath/numbers/cast.h"

#include <algorithm>
#include <string>

namespace repousse {
namespace {

constexpr std::int64_t one_at(int bit) { return std::int64_t{1} << bit; }

/// Ones in the low `bits` bits, 0..63.
constexpr std::int64_t ones(int bits) {
    return static_cast<std::int64_t>((std::uint64_t{1} << bits) - 1);
}

/// The quantization table of CastSteps, for right > 0.
void set_bias(CastSteps& steps, Quantization mode) {
    const std::int64_t half = one_at(steps.right - 1);
    switch (mode) {
        case Quantization::SC_TRN:
            break;
        case Quantization::SC_TRN_ZERO:
            steps.bias_if_negative = ones(steps.right);
            break;
        case Quantization::SC_RND:
            steps.bias = half;
            break;
        case Quantization::SC_RND_MIN_INF:
            steps.bias = half - 1;
            break;
        case Quantization::SC_RND_ZERO:
            steps.bias = half - 1;
            steps.bias_if_negative = 1;
            break;
        case Quantization::SC_RND_INF:
            steps.bias = half;
            steps.bias_if_negative = -1;
            break;
        case Quantization::SC_RND_CONV:
            steps.bias = half - 1;
            steps.bias_if_odd = 1;
            break;
    }
}

/// The rows SC_SAT, SC_SAT_SYM and SC_SAT_ZERO of the overflow table.
void set_saturation(CastSteps& steps, const Format& to) {
    if (to.overflow == Overflow::SC_SAT_SYM && to.is_signed) steps.low = -steps.high;
    const bool zero = to.overflow == Overflow::SC_SAT_ZERO;
    steps.kept = 0;
    steps.above = zero ? 0 : steps.high;
    steps.below = zero ? 0 : steps.low;
}

/// The rows SC_WRAP and SC_WRAP_SM of the overflow table. The flip compares two bits, the sign bit
/// being bit 63; with n > 1 it happens when they are equal.
void set_wrapping(CastSteps& steps, const Format& to) {
    const int saturated = std::min(to.saturated_bits, to.width);
    steps.kept = ones(to.width - saturated);
    steps.above = saturated == 0 ? 0 : steps.high & ~steps.kept;
    steps.below = saturated == 0 ? 0 : steps.low;
    if (to.overflow != Overflow::SC_WRAP_SM) return;
    steps.flip_a = saturated == 0 ? to.width : 63;
    steps.flip_b = saturated <= 1 ? to.width - 1 : to.width - saturated;
    steps.flip_odd = saturated > 1 ? 1 : 0;
}

CastKind kind_of(const CastSteps& steps, const Format& to) {
    if (steps.left > 0) return CastKind::General;
    const bool constant_bias = steps.bias_if_negative == 0 && steps.bias_if_odd == 0;
    if (to.overflow == Overflow::SC_SAT || to.overflow == Overflow::SC_SAT_SYM) {
        return constant_bias ? CastKind::Clamp : CastKind::VaryingClamp;
    }
    const bool plain_wrap = to.overflow == Overflow::SC_WRAP && to.saturated_bits == 0;
    return constant_bias && plain_wrap ? CastKind::Wrap : CastKind::General;
}

bool saturates(Overflow mode) {
    return mode == Overflow::SC_SAT || mode == Overflow::SC_SAT_SYM ||
           mode == Overflow::SC_SAT_ZERO;
}

}  // namespace

CastSteps make_steps(int source_frac, const Format& to) {
    CastSteps steps;
    const int dropped = source_frac - to.frac;
    steps.left = std::clamp(-dropped, 0, 63);
    steps.right = std::clamp(dropped, 0, 63);
    if (steps.right > 0) set_bias(steps, to.quantization);

    steps.low = to.min_raw();
    steps.high = to.max_raw();
    // The container of an unsigned format is seen as one bit wider, so that its sign bit is 0.
    steps.unused = 64 - to.width - (to.is_signed ? 0 : 1);
    if (saturates(to.overflow)) {
        set_saturation(steps, to);
    } else {
        set_wrapping(steps, to);
    }
    return steps;
}

Cast::Cast(const CastSteps& steps, const Format& to)
    : steps_(steps),
      kind_(kind_of(steps, to)),
      error_shift_(std::max(steps.right - kErrorBits, 0)),
      format_(to) {}

Result<Cast> Cast::prepare(int source_width, int source_frac, const Format& to) {
    if (Status status = check_format(to); !status) return status.error();
    const int dropped = source_frac - to.frac;
    const std::string route = std::to_string(source_width) + " bits, " +
                              std::to_string(source_frac) + " of them fraction, to " +
                              to_string(to);
    if (source_width < 1 || source_width + std::max(-dropped, 0) > 63) {
        return Error{ErrorKind::Input, "",
                     "a cast from " + route + " needs " +
                         std::to_string(source_width + std::max(-dropped, 0)) + " bits",
                     "1 to 63", "narrow the operands or drop fraction bits before"};
    }
    if (dropped > 62) {
        return Error{ErrorKind::Input, "",
                     "a cast from " + route + " drops " + std::to_string(dropped) + " bits",
                     "62 at most", ""};
    }
    return Cast(source_frac, to);
}

}  // namespace repousse
