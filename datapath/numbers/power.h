#pragma once

#include <cstdint>
#include <vector>

#include "datapath/numbers/functions.h"
#include "datapath/numbers/log2.h"

namespace repousse {

/// x^n of a cosine 0 <= x <= 1, as 2^(n log2 x): quadratic pieces of the logarithm, one product,
/// linear pieces of 2^-f, and a shift. One pair of tables serves every n, so that a material is a
/// register and not a table to be loaded.
///
/// - Monotone in x, and in n for x < 1; exact for x = 0, x = 1, and wherever x is a power of two.
/// - |error| <= x^n (n ln 2 * e_log + e_exp), relative to 1, where e_log is OctaveLog2's error plus
///   2^-20 and e_exp = h^2 (ln 2)^2 / 8 + 2^-19 for pieces of width h. That is before the caller
///   rounds mantissa * 2^-exponent.
class Power {
public:
    static constexpr int kFractionBits = 20;  ///< of the mantissa, which is in (1/2, 1]
    static constexpr int kMaxExpIndexBits = 12;
    static constexpr int kMaxExponent = 63;  ///< results of 2^-44 and less are 0

    /// A piece of 2^-f: knot - fall * t, 0 <= t < 1, both with kFractionBits fraction bits.
    struct Piece {
        uint32_t knot = 0;
        uint32_t fall = 0;
    };

    /// Tables of 2^log_index_bits (1..OctaveLog2::kMaxIndexBits) and 2^exp_index_bits
    /// (1..kMaxExpIndexBits) pieces (assert).
    Power(int log_index_bits, int exp_index_bits);

    /// (x * 2^-frac)^n for 0 <= x <= 2^frac, frac of at most 24 bits, and 1 <= n < 256; x beyond
    /// 2^frac counts as 1. The mantissa of 0 is 0.
    Scaled operator()(uint64_t x, int frac, unsigned n) const;

    const OctaveLog2& log2() const { return log2_; }
    const std::vector<Piece>& pieces() const { return pieces_; }
    int index_bits() const { return index_bits_; }

    /// Widths of a word of the exponential's ROM, {knot, fall} with the knot on top.
    int knot_bits() const { return kFractionBits + 1; }
    int fall_bits() const { return kFractionBits - index_bits_; }  ///< fall < 0.7 h
    int word_bits() const { return knot_bits() + fall_bits(); }
    uint64_t word(std::size_t i) const;

    /// The size of both ROMs.
    int64_t table_bits() const {
        return log2_.table_bits() + static_cast<int64_t>(pieces_.size()) * word_bits();
    }

private:
    OctaveLog2 log2_;
    int index_bits_;
    std::vector<Piece> pieces_;
};

}  // namespace repousse
