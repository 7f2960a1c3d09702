#include "datapath/numbers/power.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace repousse {
namespace {

static_assert(OctaveLog2::kFractionBits == Power::kFractionBits, "one product between the tables");

/// 2^-(i/n) for n = 2^bits and i = 0..n, with 31 fraction bits. 2^-(1/2), 2^-(1/4), ... are
/// repeated square roots; what the roots and the products floor stays below 2^-26 in all.
std::vector<uint64_t> falling_octave(int bits) {
    const auto root = [](uint64_t x) {  // of u0.62
        uint64_t r = 0;
        for (int bit = 31; bit >= 0; --bit) {
            const uint64_t trial = r | (uint64_t{1} << bit);
            if (trial * trial <= x) r = trial;
        }
        return r;
    };
    std::vector<uint64_t> values((std::size_t{1} << bits) + 1, uint64_t{1} << 31);
    uint64_t factor = uint64_t{1} << 30;
    values.back() = factor;
    for (int bit = bits - 1; bit >= 0; --bit) {
        factor = root(factor << 31);
        for (std::size_t i = 0; i + 1 < values.size(); ++i) {
            if ((i >> bit & 1U) != 0) values[i] = (values[i] * factor + (uint64_t{1} << 30)) >> 31;
        }
    }
    return values;
}

}  // namespace

Power::Power(int log_index_bits, int exp_index_bits)
    : log2_(OctaveLog2::Pieces::Quadratic, log_index_bits), index_bits_(exp_index_bits) {
    assert(1 <= exp_index_bits && exp_index_bits <= kMaxExpIndexBits);
    // Knots stand on the curve, so that whole octaves are exact and join.
    const std::vector<uint64_t> exact = falling_octave(exp_index_bits);
    const int dropped = 31 - kFractionBits;
    const auto knot = [&](std::size_t i) {
        return static_cast<uint32_t>((exact[i] + (uint64_t{1} << (dropped - 1))) >> dropped);
    };
    for (std::size_t i = 0; i + 1 < exact.size(); ++i) {
        pieces_.push_back({knot(i), knot(i) - knot(i + 1)});
    }
}

uint64_t Power::word(std::size_t i) const {
    return (uint64_t{pieces_[i].knot} << fall_bits()) | pieces_[i].fall;
}

Scaled Power::operator()(uint64_t x, int frac, unsigned n) const {
    if (x == 0) return {0, kMaxExponent};
    const uint64_t one = uint64_t{1} << frac;
    x = x > one ? one : x;
    // -log2 of the cosine, at least 0 because the logarithm's last piece ends at 1: 5 + 20 bits.
    // Times n: 33 bits.
    const int64_t depth = (int64_t{frac} << kFractionBits) - log2_(x);
    const uint64_t product = static_cast<uint64_t>(depth) * n;
    const uint64_t octaves = product >> kFractionBits;
    const uint64_t f = product & ((uint64_t{1} << kFractionBits) - 1);
    const int m = kFractionBits - index_bits_;  // bits of t
    const Piece& piece = pieces_[static_cast<std::size_t>(f >> m)];
    // fall * t: 2 m bits at most. Floored, the mantissa is above 1/2 or is the next octave's 1.
    const uint64_t t = f & ((uint64_t{1} << m) - 1);
    const uint64_t mantissa = ((uint64_t{piece.knot} << m) - piece.fall * t) >> m;
    const uint64_t most = kMaxExponent - kFractionBits;
    if (octaves > most) return {0, kMaxExponent};
    return {static_cast<int64_t>(mantissa), kFractionBits + static_cast<int>(octaves)};
}

}  // namespace repousse
