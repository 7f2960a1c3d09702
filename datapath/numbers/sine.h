#pragma once

#include <cstdint>
#include <vector>

namespace repousse {

/// Sine and cosine of an angle in half turns, by a table of a quarter wave in linear pieces.
///
/// - Odd and even, periodic, sine and cosine each other's mirror, to the bit; exact at the
/// quarters.
/// - |error| <= h^2 / 8 + 1.5 * 2^-kFractionBits for pieces of h = (pi / 2) / 2^index_bits: the
///   chord lies below the curve, knots and product are rounded.
class Sine {
public:
    static constexpr int kFractionBits = 20;  ///< of results, and of the knots
    static constexpr int kMaxIndexBits = 10;

    /// A table of 2^index_bits (2 .. kMaxIndexBits) pieces; angles have `angle_frac` (1 .. 16)
    /// fraction bits (assert).
    Sine(int index_bits, int angle_frac);

    /// Of any angle, taken modulo one turn; -2^kFractionBits .. 2^kFractionBits.
    int32_t sin(int32_t angle) const { return wave(static_cast<uint32_t>(angle)); }
    int32_t cos(int32_t angle) const { return wave(static_cast<uint32_t>(angle) + quarter_); }

    /// The ends of the pieces: 2^index_bits + 1, from 0 to one.
    const std::vector<int32_t>& knots() const { return knots_; }

    /// The size of the ROM: a knot and the rise to the next one for each piece.
    int64_t table_bits() const {
        return (static_cast<int64_t>(knots_.size()) - 1) *
               (kFractionBits + kFractionBits - index_bits_ + 1);
    }

private:
    int32_t wave(uint32_t angle) const;

    int index_bits_;
    uint32_t quarter_;  // a quarter turn: half of a half turn
    std::vector<int32_t> knots_;
};

/// The knots of the largest table; a smaller one has every 2^n-th of them.
std::vector<int32_t> sine_knots();

}  // namespace repousse
