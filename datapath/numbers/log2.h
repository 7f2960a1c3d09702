#pragma once

#include <cstdint>
#include <vector>

namespace repousse {

/// log2 of a positive integer: the place of its leading one, and a small table of log2(1 + u) over
/// one octave, 0 <= u < 1, interpolated in pieces of equal width h = 2^-index_bits.
///
/// A piece is y + d t, or y + d t + q t (1 - t), where t runs from 0 to 1 over it. It is stored as
/// its knot y, its rise d to the next knot, and its bend q. Neighbours share their knots, so the
/// function is continuous; it is monotone, too:
///   linear     the knots rise, and one sum is floored once;
///   quadratic  a step of t adds d, and takes off 2 q at most, which is less;
///   octaves    the last piece ends at 1 + y0 at most, where the next octave begins.
///
/// Linear knots stand half the chord's greatest gap above the curve, which makes the error equal on
/// both sides: h^2 / (16 ln 2) at most. Quadratic knots lie on the curve, and pieces meet it in
/// their middle: the error is cubic, h^3 sqrt(3) / (108 ln 2) at most.
class OctaveLog2 {
public:
    enum class Pieces : uint8_t { Linear, Quadratic };

    static constexpr int kMantissaBits = 20;  ///< of u; what lies below is dropped: 2^-19.5 at most
    static constexpr int kFractionBits = 20;  ///< of the result
    static constexpr int kMaxIndexBits = 16;

    struct Piece {
        uint32_t knot = 0;
        uint32_t rise = 0;
        uint32_t bend = 0;  ///< 0 in linear tables
    };

    /// A table of 2^index_bits pieces, 1..kMaxIndexBits (assert).
    OctaveLog2(Pieces kind, int index_bits);

    /// log2(x) with kFractionBits fraction bits; 0 for x = 0.
    int64_t operator()(uint64_t x) const;

    Pieces kind() const { return kind_; }
    const std::vector<Piece>& pieces() const { return pieces_; }

    /// Widths of a word of the ROM, which is {knot, rise, bend} with the knot on top. The knot's
    /// rounding stays below a quarter of the interpolation's error.
    int knot_bits() const { return frac_; }
    int rise_bits() const { return frac_ - index_bits_ + 1; }  ///< d < 1.45 h
    int bend_bits() const;                                     ///< q < 0.73 h^2
    int word_bits() const { return knot_bits() + rise_bits() + bend_bits(); }
    uint64_t word(std::size_t i) const;

    /// The size of the ROM.
    int64_t table_bits() const { return static_cast<int64_t>(pieces_.size()) * word_bits(); }

private:
    Pieces kind_;
    int index_bits_;
    int frac_;  // fraction bits of knot, rise and bend
    std::vector<Piece> pieces_;
};

}  // namespace repousse
