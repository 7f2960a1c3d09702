#include "datapath/numbers/cordic.h"

#include <algorithm>

// With f fraction bits wanted there are n = f + 5 steps of bits = f + 10 bits each. What is left of
// an angle after n steps is 2^-(n-1) at most, an eighth of an LSB of the result in each of two
// angles at right angles: 0.09 LSB in a component. Shifts floor, which costs a unit of 2^-(f+10) a
// step at most: 3 * 23 steps are 0.07 LSB.

namespace repousse {
namespace {

struct Pair {
    int64_t a = 0, b = 0;
};

/// (a, b) turned by atan(2^-i) from a to b if `sign` is 0, from b to a if it is -1, and lengthened
/// by sqrt(1 + 4^-i).
Pair turned(const Pair& p, int i, int64_t sign) {
    const int64_t da = ((p.b >> i) ^ sign) - sign;
    const int64_t db = ((p.a >> i) ^ sign) - sign;
    return {p.a - da, p.b + db};
}

/// 0 for v >= 0, -1 for v < 0.
int64_t sign_of(int64_t v) { return v >> 63; }

int64_t absolute(int64_t v) { return (v ^ sign_of(v)) - sign_of(v); }

/// floor(sqrt(x)), bit by bit.
uint64_t integer_sqrt(uint64_t x) {
    uint64_t root = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const uint64_t trial = root | uint64_t{1} << bit;
        if (trial * trial <= x) root = trial;
    }
    return root;
}

}  // namespace

Cordic::Cordic(int frac)
    : steps_(std::clamp(frac, kMinFrac, kMaxFrac) + 5),
      bits_(std::clamp(frac, kMinFrac, kMaxFrac) + 10) {
    // K^2 < 2.72 in u2.60, its root in u1.30.
    uint64_t square = uint64_t{1} << 60;
    for (int i = 0; i < steps_; ++i) square += square >> 2 * i;
    const int dropped = 30 - bits_;
    gain_ = static_cast<int64_t>((integer_sqrt(square) + (uint64_t{1} << dropped >> 1)) >> dropped);
    const uint64_t divisor = square >> 30;
    start_ = static_cast<int64_t>(((uint64_t{1} << (30 + bits_)) + divisor / 2) / divisor);
}

std::array<int64_t, 3> Cordic::operator()(int64_t x, int64_t y, int64_t z) const {
    // The longest component's top bit goes to bit kInputBits - 1, then to bit bits_ - 1. Where
    // bits_ is less, the bits that fall off are below the result's.
    const int64_t ax = absolute(x), ay = absolute(y), az = absolute(z);
    const auto any = static_cast<uint64_t>(ax | ay | az);
    const int zeros = __builtin_clzll(any | 1) - (64 - kInputBits);
    const int gained = std::max(0, bits_ - kInputBits), lost = std::max(0, kInputBits - bits_);
    const auto scaled = [&](int64_t v) { return v << zeros << gained >> lost; };
    const int64_t half = int64_t{1} << (bits_ - 1);

    // K r < 2^bits * 1.65 * sqrt(2) < 2^(bits+2), and with the sign bits + 3.
    uint64_t clockwise = 0;  // bit i: step i turned from b to a
    Pair plane{scaled(ax), scaled(ay)};
    for (int i = 0; i < steps_; ++i) {
        const int64_t sign = ~sign_of(plane.b);
        clockwise |= static_cast<uint64_t>(sign & 1) << i;
        plane = turned(plane, i, sign);
    }

    // K |v| K < 2^bits * 2.72 * sqrt(3) < 2^(bits+3), and with the sign bits + 4. The product with
    // K has 2 bits + 1, 57 in all.
    Pair rise{plane.a, (scaled(az) * gain_ + half) >> bits_};
    Pair axis{start_, 0};
    for (int i = 0; i < steps_; ++i) {
        const int64_t sign = ~sign_of(rise.b);
        rise = turned(rise, i, sign);
        axis = turned(axis, i, ~sign);
    }

    // Results are at most one, but for rounding: bits + 2 with the sign.
    const int64_t unit_z = (axis.b * gain_ + half) >> bits_;
    Pair level{axis.a, 0};
    for (int i = 0; i < steps_; ++i) {
        level = turned(level, i, static_cast<int64_t>(clockwise >> i & 1) - 1);
    }

    const int64_t some = -static_cast<int64_t>(any != 0);
    const auto signed_as = [&](int64_t v, int64_t as) {
        return ((v ^ sign_of(as)) - sign_of(as)) & some;
    };
    return {signed_as(level.a, x), signed_as(level.b, y), signed_as(unit_z, z)};
}

}  // namespace repousse
