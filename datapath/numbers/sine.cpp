#include "datapath/numbers/sine.h"

#include <array>
#include <cassert>
#include <cstddef>

namespace repousse {
namespace {

constexpr int kExact = 31;  // fraction bits of the cosines and sines below

uint64_t root(uint64_t x) {
    uint64_t r = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const uint64_t trial = r | (uint64_t{1} << bit);
        if (trial * trial <= x) r = trial;
    }
    return r;
}

struct Turn {
    uint64_t cos, sin;
};

/// By the sum of both angles, which is at most a quarter turn.
Turn operator+(const Turn& a, const Turn& b) {
    const uint64_t half = uint64_t{1} << (kExact - 1);
    const uint64_t product = a.sin * b.sin;
    const uint64_t cosines = a.cos * b.cos;
    return {cosines > product ? (cosines - product + half) >> kExact : 0,
            (a.sin * b.cos + a.cos * b.sin + half) >> kExact};
}

}  // namespace

// cos(x/2) = sqrt((1 + cos x) / 2), sin(x/2) = sqrt((1 - cos x) / 2) from the quarter turn down; an
// angle is the sum of those its bits stand for. What roots and products lose stays below 2^-26.
std::vector<int32_t> sine_knots() {
    constexpr uint64_t kOne = uint64_t{1} << kExact;
    constexpr int kDropped = kExact - Sine::kFractionBits;
    std::array<Turn, Sine::kMaxIndexBits + 1> halves;
    halves[Sine::kMaxIndexBits] = {0, kOne};
    for (std::size_t i = Sine::kMaxIndexBits; i-- > 0;) {
        const Turn& twice = halves[i + 1];
        halves[i].cos = root((kOne + twice.cos) << (kExact - 1));
        // 2 sin(x/2) cos(x/2) = sin x loses nothing where the angle is small.
        halves[i].sin = ((twice.sin << (kExact - 1)) + halves[i].cos / 2) / halves[i].cos;
    }
    std::vector<int32_t> knots;
    for (std::size_t i = 0; i <= std::size_t{1} << Sine::kMaxIndexBits; ++i) {
        Turn turn{kOne, 0};
        for (std::size_t bit = 0; bit < halves.size(); ++bit) {
            if ((i >> bit & 1U) != 0) turn = turn + halves[bit];
        }
        knots.push_back(
            static_cast<int32_t>((turn.sin + (uint64_t{1} << (kDropped - 1))) >> kDropped));
    }
    return knots;
}

Sine::Sine(int index_bits, int angle_frac)
    : index_bits_(index_bits), quarter_(uint32_t{1} << (angle_frac - 1)) {
    assert(2 <= index_bits && index_bits <= kMaxIndexBits);
    assert(1 <= angle_frac && angle_frac <= 16);
    const std::vector<int32_t> all = sine_knots();
    for (std::size_t i = 0; i < all.size(); i += std::size_t{1} << (kMaxIndexBits - index_bits)) {
        knots_.push_back(all[i]);
    }
}

int32_t Sine::wave(uint32_t angle) const {
    const bool falls = (angle & quarter_) != 0;
    const bool negative = (angle & 2 * quarter_) != 0;
    const uint32_t from_start = angle & (quarter_ - 1);
    const uint32_t place = falls ? quarter_ - from_start : from_start;  // 0 .. a quarter
    // index_bits bits of the place choose the piece, the others are t: 15 bits at most, times a
    // rise of at most 19.
    const uint64_t raised = uint64_t{place} << index_bits_;
    const auto index = static_cast<std::size_t>(raised / quarter_);
    const uint64_t t = raised % quarter_;
    int32_t value = knots_[index];
    if (t != 0) {
        const auto rise = static_cast<uint64_t>(knots_[index + 1] - value);
        value += static_cast<int32_t>((rise * t + quarter_ / 2) / quarter_);
    }
    return negative ? -value : value;
}

}  // namespace repousse
