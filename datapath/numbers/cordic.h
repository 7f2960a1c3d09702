#pragma once

#include <array>
#include <cstdint>

namespace repousse {

/// How a vector gets to unit length; the profile entry `normalise_kind`.
enum class NormaliseKind {
    InverseSqrt = 0,  ///< times 1/sqrt(x^2 + y^2 + z^2), by a table and Newton steps
    Cordic = 1,       ///< rotations by arctangents of powers of two: shifts and additions
};

/// v / |v| of integer vectors by CORDIC, without multipliers but for two by a constant. The vector
/// is turned onto the x axis, first about z, then about y; the same turns, backwards, bring the
/// unit vector of that axis to v / |v|. No angle is ever formed: a turn is the signs of its steps.
///
///  1. |x|, |y|, |z|, shifted so that the longest has `bits()` bits: the error does not depend on
///  the
///     length of v;
///  2. n steps turn (x, y) to (K r, 0), r^2 = x^2 + y^2; K = prod sqrt(1 + 4^-i) = 1.6468;
///  3. n steps turn (K r, K z) to (., 0), and with it (1/K^2, 0) to (cos, sin) / K of the
///  elevation;
///  4. the steps of 2 turn (cos / K, 0) back to x and y of the result; its z is K (sin / K).
///
/// Everything is integer, and no step depends on the data but by signs, which are masks: the same
/// widths do in hardware (cordic.cpp has them beside each line).
class Cordic {
public:
    static constexpr int kInputBits = 24;
    static constexpr int kMinFrac = 4;
    static constexpr int kMaxFrac = 18;

    /// For results that are to be rounded to `frac` fraction bits, cut to kMinFrac..kMaxFrac: the
    /// error before that rounding is below a quarter of the last bit kept.
    explicit Cordic(int frac);

    /// Components of at most kInputBits with sign, to components with `bits()` fraction bits, each
    /// within 2^-(frac + 2) of v / |v|. The zero vector stays zero; -v gives the opposite result.
    std::array<int64_t, 3> operator()(int64_t x, int64_t y, int64_t z) const;

    /// The turns of each of 2, 3 and 4.
    int steps() const { return steps_; }
    /// Bits of the longest component after step 1, and fraction bits of the result.
    int bits() const { return bits_; }

    /// K and 1/K^2 in `bits()` fraction bits, to nearest.
    int64_t gain() const { return gain_; }
    int64_t start() const { return start_; }

private:
    int steps_;
    int bits_;
    int64_t gain_;
    int64_t start_;
};

}  // namespace repousse
