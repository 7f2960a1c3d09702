// The casts against definitions that are written differently: rounding by comparing distances,
// carries into the floor as the RTL has them, overflow in exact arithmetic. cast_sc_test.cpp has
// the comparison with SystemC.

#include "datapath/numbers/cast.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <string>

namespace repousse {
namespace {

__extension__ using Wide = __int128;

constexpr int kModes = 7;

Format make_format(int width, Quantization quantization, Overflow overflow, int frac = 0) {
    Format format;
    format.width = width;
    format.frac = frac;
    format.quantization = quantization;
    format.overflow = overflow;
    return format;
}

/// A target so wide that only the quantization shows.
Format wide_format(Quantization quantization) {
    return make_format(40, quantization, Overflow::SC_SAT);
}

/// floor plus the carry of the table in cast.h.
std::int64_t by_carry(std::int64_t x, int dropped, Quantization mode) {
    const std::int64_t floor = x >> dropped;
    const bool guard = ((x >> (dropped - 1)) & 1) != 0;
    const bool rest = (x & ((std::int64_t{1} << (dropped - 1)) - 1)) != 0;
    const bool negative = x < 0;
    const bool odd = (floor & 1) != 0;
    switch (mode) {
        case Quantization::SC_TRN:
            return floor;
        case Quantization::SC_TRN_ZERO:
            return floor + (negative && (guard || rest) ? 1 : 0);
        case Quantization::SC_RND:
            return floor + (guard ? 1 : 0);
        case Quantization::SC_RND_MIN_INF:
            return floor + (guard && rest ? 1 : 0);
        case Quantization::SC_RND_ZERO:
            return floor + (guard && (rest || negative) ? 1 : 0);
        case Quantization::SC_RND_INF:
            return floor + (guard && (rest || !negative) ? 1 : 0);
        case Quantization::SC_RND_CONV:
            return floor + (guard && (rest || odd) ? 1 : 0);
    }
    return floor;
}

/// The neighbour that the name of the mode promises.
std::int64_t by_distance(std::int64_t x, int dropped, Quantization mode) {
    const std::int64_t unit = std::int64_t{1} << dropped;
    const std::int64_t below = (x - ((x % unit + unit) % unit)) / unit;
    const std::int64_t above = x % unit == 0 ? below : below + 1;
    const std::int64_t to_below = x - below * unit;
    const std::int64_t to_above = above * unit - x;
    const std::int64_t toward_zero = x < 0 ? above : below;
    const std::int64_t from_zero = x < 0 ? below : above;
    if (mode == Quantization::SC_TRN) return below;
    if (mode == Quantization::SC_TRN_ZERO) return toward_zero;
    if (to_below != to_above) return to_below < to_above ? below : above;
    switch (mode) {
        case Quantization::SC_RND:
            return above;
        case Quantization::SC_RND_MIN_INF:
            return below;
        case Quantization::SC_RND_ZERO:
            return toward_zero;
        case Quantization::SC_RND_INF:
            return from_zero;
        default:
            return below % 2 == 0 ? below : above;
    }
}

TEST(Cast, QuantizesAsTheTwoDefinitionsForEvery12BitValue) {
    std::int64_t cases = 0;
    for (int mode = 0; mode < kModes; ++mode) {
        const auto quantization = static_cast<Quantization>(mode);
        for (int dropped = 1; dropped <= 7; ++dropped) {
            const Cast cast(dropped, wide_format(quantization));
            for (std::int64_t x = -2048; x < 2048; ++x, ++cases) {
                ASSERT_EQ(cast(x), by_carry(x, dropped, quantization)) << mode << " " << x;
                ASSERT_EQ(cast(x), by_distance(x, dropped, quantization)) << mode << " " << x;
            }
        }
    }
    EXPECT_EQ(cases, 200'704);
}

/// What the four plain overflow modes do, in terms of the range alone.
std::int64_t in_range(std::int64_t y, const Format& format) {
    const std::int64_t low = format.overflow == Overflow::SC_SAT_SYM && format.is_signed
                                 ? -format.max_raw()
                                 : format.min_raw();
    const std::int64_t high = format.max_raw();
    if (low <= y && y <= high) return y;
    if (format.overflow == Overflow::SC_SAT_ZERO) return 0;
    if (format.overflow != Overflow::SC_WRAP) return y > high ? high : low;
    const std::int64_t period = std::int64_t{1} << format.width;
    while (y > high) y -= period;
    while (y < low) y += period;
    return y;
}

TEST(Cast, OverflowsAsDefinedForEverySmallWidth) {
    for (int width = 1; width <= 6; ++width) {
        for (int mode = 0; mode < 8; ++mode) {
            Format format =
                make_format(width, Quantization::SC_TRN, static_cast<Overflow>(mode / 2));
            format.is_signed = mode % 2 == 0;
            const Cast cast(0, format);
            for (std::int64_t y = -300; y <= 300; ++y) {
                std::uint64_t overflows = 0;
                const std::int64_t value = cast(y, overflows);
                ASSERT_EQ(value, in_range(y, format)) << to_string(format) << " " << y;
                ASSERT_EQ(overflows, value != y ? 1U : 0U) << to_string(format) << " " << y;
            }
        }
    }
}

TEST(Cast, GainsBitsExactly) {
    const Cast cast(4, make_format(20, Quantization::SC_RND_CONV, Overflow::SC_SAT, 10));
    EXPECT_EQ(cast(-3), -3 * 64);
    EXPECT_EQ(cast(1 << 14), (1 << 19) - 1);
}

TEST(Cast, DefaultPassesEverything) {
    const Cast cast;
    CastCounters counters;
    const std::int64_t limit = std::int64_t{1} << 62;
    for (std::int64_t x : {std::int64_t{0}, limit - 1, -limit}) {
        EXPECT_EQ(cast(x), x);
        EXPECT_EQ(cast(x, counters), x);
    }
    EXPECT_EQ(counters.overflows, 0U);
}

TEST(Cast, DropsMoreBitsThanThereAre) {
    const std::int64_t most = (std::int64_t{1} << 62) - 1;
    for (int dropped : {62, 63, 64, 100}) {
        const Cast floor(dropped, wide_format(Quantization::SC_TRN));
        EXPECT_EQ(floor(most), 0);
        EXPECT_EQ(floor(-1), -1);
        const Cast nearest(dropped, wide_format(Quantization::SC_RND));
        EXPECT_EQ(nearest(most), dropped == 62 ? 1 : 0);
        EXPECT_EQ(nearest(-most), dropped == 62 ? -1 : 0);
        const Cast zero(dropped, wide_format(Quantization::SC_TRN_ZERO));
        EXPECT_EQ(zero(-most), 0);
    }
}

TEST(Cast, PrepareRefusesWhatCouldLeaveInt64) {
    const Format format = make_format(32, Quantization::SC_RND, Overflow::SC_SAT, 16);
    EXPECT_TRUE(Cast::prepare(63, 32, format));
    EXPECT_FALSE(Cast::prepare(64, 32, format));
    EXPECT_FALSE(Cast::prepare(0, 32, format));
    EXPECT_TRUE(Cast::prepare(55, 8, format));
    EXPECT_FALSE(Cast::prepare(56, 8, format)) << "8 bits gained make it 64";
    EXPECT_TRUE(Cast::prepare(63, 78, format));
    EXPECT_FALSE(Cast::prepare(63, 79, format));
    EXPECT_FALSE(Cast::prepare(32, 16, make_format(64, Quantization::SC_TRN, Overflow::SC_WRAP)));
    EXPECT_EQ(Cast::prepare(56, 8, format).error().message(),
              "a cast from 56 bits, 8 of them fraction, to s15.16 SC_RND SC_SAT needs 64 bits, "
              "expected 1 to 63; narrow the operands or drop fraction bits before");
}

TEST(Cast, KnowsItsFastCases) {
    using Q = Quantization;
    using O = Overflow;
    const auto kind = [](Q q, O o, int dropped) {
        return Cast(dropped, make_format(8, q, o)).kind();
    };
    EXPECT_EQ(kind(Q::SC_RND, O::SC_SAT, 3), CastKind::Clamp);
    EXPECT_EQ(kind(Q::SC_TRN, O::SC_SAT_SYM, 3), CastKind::Clamp);
    EXPECT_EQ(kind(Q::SC_TRN, O::SC_WRAP, 3), CastKind::Wrap);
    EXPECT_EQ(kind(Q::SC_RND_CONV, O::SC_SAT, 3), CastKind::VaryingClamp);
    EXPECT_EQ(kind(Q::SC_RND_CONV, O::SC_SAT, 0), CastKind::Clamp) << "nothing to round";
    EXPECT_EQ(kind(Q::SC_RND_CONV, O::SC_WRAP, 3), CastKind::General);
    EXPECT_EQ(kind(Q::SC_TRN, O::SC_SAT, -3), CastKind::General);
}

RC_GTEST_PROP(Cast, AccumulatesAsIfTheExactSumWereCast, ()) {
    const int mode = *rc::gen::element(0, 2, 3);  // SC_TRN, SC_RND, SC_RND_MIN_INF
    const int dropped = *rc::gen::inRange(1, 20);
    const auto overflow = static_cast<Overflow>(*rc::gen::inRange(0, 5));
    const Cast cast(dropped, make_format(30, static_cast<Quantization>(mode), overflow));
    const std::int64_t sum = *rc::gen::inRange(-(1LL << 29), 1LL << 29);
    const std::int64_t x = *rc::gen::inRange(-(1LL << 45), 1LL << 45);
    RC_ASSERT(cast.accumulate(sum, x) == cast(sum * (std::int64_t{1} << dropped) + x));
}

TEST(CastCounters, HoldWhatTheDefinitionsSay) {
    for (int dropped : {0, 5, 26, 27, 40}) {
        const Cast cast(dropped, make_format(8, Quantization::SC_RND_INF, Overflow::SC_SAT));
        const int shift = dropped > 26 ? dropped - 26 : 0;
        EXPECT_EQ(cast.error_shift(), shift);
        CastCounters counters;
        std::uint64_t overflows = 0;
        std::int64_t min = INT64_MAX;
        std::int64_t max = INT64_MIN;
        Wide sum = 0;
        Wide squares = 0;
        std::uint64_t state = 7;
        for (int i = 0; i < 5000; ++i) {
            state = state * 6364136223846793005U + 1442695040888963407U;
            const std::int64_t x =
                static_cast<std::int64_t>(state) >> (55 - dropped > 1 ? 55 - dropped : 2);
            const std::int64_t y =
                dropped == 0 ? x : by_distance(x, dropped, Quantization::SC_RND_INF);
            EXPECT_EQ(cast(x, counters), in_range(y, cast.format()));
            overflows += y < -128 || y > 127 ? 1 : 0;
            min = y < min ? y : min;
            max = y > max ? y : max;
            const Wide error = (static_cast<Wide>(y) * (Wide{1} << dropped) - x) >> shift;
            sum += error;
            squares += error * error;
        }
        EXPECT_EQ(counters.values, 5000U);
        EXPECT_EQ(counters.overflows, overflows);
        EXPECT_EQ(counters.min, min);
        EXPECT_EQ(counters.max, max);
        EXPECT_EQ(Wide{counters.error_sum}, sum);
        EXPECT_EQ(counters.error_squares.low, static_cast<std::uint64_t>(squares));
        EXPECT_EQ(counters.error_squares.high, static_cast<std::uint64_t>(squares >> 64));
        EXPECT_GT(overflows, 0U);
        EXPECT_LT(overflows, 5000U);
    }
}

TEST(CastCounters, CarryIntoTheHighWord) {
    Sum128 sum{~std::uint64_t{0}, 4};
    sum.add({1, 2});
    EXPECT_EQ(sum, (Sum128{0, 7}));
}

}  // namespace
}  // namespace repousse
