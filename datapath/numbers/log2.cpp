#include "datapath/numbers/log2.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace repousse {
namespace {

constexpr int kPreciseBits = 32;  // fraction bits of the logarithms that tables are made from
constexpr int64_t kOne = int64_t{1} << kPreciseBits;

/// log2 of x in [1, 2), u1.31, bit by bit: squaring doubles the logarithm. Each of the products,
/// u2.62, is rounded to 31 fraction bits; what that does to the logarithm halves with every step,
/// so that the sum stays below 2^-30.
int64_t precise_log2(uint64_t x) {
    int64_t log = 0;
    for (int bit = 0; bit < kPreciseBits; ++bit) {
        x = (x * x + (uint64_t{1} << 30)) >> 31;
        const uint64_t above_two = x >> 32;
        log = 2 * log + static_cast<int64_t>(above_two);
        x = (x + above_two) >> above_two;
    }
    return log;
}

/// log2(1 + i / n) for n = 2^bits, i = 0..n.
std::vector<int64_t> octave(int bits) {
    std::vector<int64_t> values;
    for (uint64_t i = 0; i >> bits == 0; ++i) {
        values.push_back(precise_log2((uint64_t{1} << 31) + (i << (31 - bits))));
    }
    values.push_back(kOne);
    return values;
}

int64_t rounded(int64_t x, int dropped) { return (x + (int64_t{1} << (dropped - 1))) >> dropped; }

}  // namespace

OctaveLog2::OctaveLog2(Pieces kind, int index_bits)
    : kind_(kind),
      index_bits_(index_bits),
      frac_(kind == Pieces::Linear ? std::min(kFractionBits, 2 * index_bits + 5)
                                   : std::min(kFractionBits, 3 * index_bits + 8)) {
    assert(1 <= index_bits && index_bits <= kMaxIndexBits);
    const std::vector<int64_t> exact = octave(index_bits + 1);  // ends and middles of the pieces
    const std::size_t n = std::size_t{1} << index_bits;
    const int dropped = kPreciseBits - frac_;

    // How far the curve rises above the middle of each piece's chord.
    std::vector<int64_t> gap;
    for (std::size_t i = 0; i < n; ++i) {
        gap.push_back(exact[2 * i + 1] - (exact[2 * i] + exact[2 * i + 2]) / 2);
    }
    std::vector<int64_t> knots;
    for (std::size_t i = 0; i <= n; ++i) {
        const int64_t both = gap[i == 0 ? 0 : i - 1] + gap[i == n ? n - 1 : i];
        const int64_t lift = kind == Pieces::Linear ? both / 4 : 0;
        knots.push_back(rounded(exact[2 * i] + lift, dropped));
    }
    // In the largest tables the rounding of the knots is as large as the bend.
    const int64_t most_bend = (int64_t{1} << bend_bits()) - 1;
    for (std::size_t i = 0; i < n; ++i) {
        const int64_t ends = (knots[i] + knots[i + 1]) * (int64_t{1} << dropped);
        const int64_t bend =
            kind == Pieces::Linear ? 0 : rounded(4 * exact[2 * i + 1] - 2 * ends, dropped);
        pieces_.push_back({static_cast<uint32_t>(knots[i]),
                           static_cast<uint32_t>(knots[i + 1] - knots[i]),
                           static_cast<uint32_t>(std::clamp<int64_t>(bend, 0, most_bend))});
    }
}

int OctaveLog2::bend_bits() const {
    return kind_ == Pieces::Linear ? 0 : std::max(frac_ - 2 * index_bits_, 1);
}

uint64_t OctaveLog2::word(std::size_t i) const {
    const Piece& p = pieces_[i];
    return (((uint64_t{p.knot} << rise_bits()) | p.rise) << bend_bits()) | p.bend;
}

int64_t OctaveLog2::operator()(uint64_t x) const {
    if (x == 0) return 0;
    const int exponent = 63 - __builtin_clzll(x);
    // Normalised with the leading one dropped; in two steps, since a shift by 64 is no shift.
    const uint64_t u = (x << (63 - exponent) << 1) >> (64 - kMantissaBits);
    const int m = kMantissaBits - index_bits_;  // bits of t: 4..19
    const uint64_t one = uint64_t{1} << m;
    const uint64_t t = u & (one - 1);
    const Piece& piece = pieces_[static_cast<std::size_t>(u >> m)];
    // Fraction bits frac + m: 39 at most, as are the bits of rise * t. t (1 - t) is cut to m bits.
    const uint64_t arch = (t * (one - t)) >> m;
    const uint64_t sum = (uint64_t{piece.knot} << m) + piece.rise * t + piece.bend * arch;
    return (static_cast<int64_t>(exponent) << kFractionBits) +
           static_cast<int64_t>(sum >> (frac_ + m - kFractionBits));
}

}  // namespace repousse
