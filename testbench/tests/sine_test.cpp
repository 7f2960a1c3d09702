// Sine: every angle of every table against the library's.

#include "datapath/numbers/sine.h"

#include <gtest/gtest.h>

#include <cmath>

namespace repousse {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kLsb = 0x1p-20;

TEST(Sine, KnotsAreTheNearestNumbers) {
    const std::vector<int32_t> knots = sine_knots();
    ASSERT_EQ(knots.size(), (std::size_t{1} << Sine::kMaxIndexBits) + 1);
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const double exact = std::sin(kPi / 2 * static_cast<double>(i) / 1024);
        ASSERT_NEAR(knots[i] * kLsb, exact, 0.501 * kLsb) << i;
    }
    EXPECT_EQ(knots.front(), 0);
    EXPECT_EQ(knots.back(), 1 << 20);
}

TEST(Sine, EveryAngleOfOneTurnEitherWayIsWithinTheBound) {
    for (int index_bits = 2; index_bits <= Sine::kMaxIndexBits; ++index_bits) {
        for (const int frac : {1, 2, 5, 11, 15, 16}) {
            const Sine sine(index_bits, frac);
            const double h = kPi / 2 / (1 << index_bits);
            const double bound = h * h / 8 + 1.5 * kLsb;
            double worst = 0;
            for (int32_t a = -(2 << frac); a <= 2 << frac; ++a) {
                const double angle = kPi * std::ldexp(a, -frac);
                worst = std::max(worst, std::abs(sine.sin(a) * kLsb - std::sin(angle)));
                worst = std::max(worst, std::abs(sine.cos(a) * kLsb - std::cos(angle)));
            }
            EXPECT_LE(worst, bound) << index_bits << " index bits, " << frac;
        }
    }
}

TEST(Sine, SymmetriesHoldToTheBit) {
    const Sine sine(6, 15);
    const int32_t quarter = 1 << 14, one = 1 << 20;
    EXPECT_EQ(sine.sin(0), 0);
    EXPECT_EQ(sine.sin(quarter), one);
    EXPECT_EQ(sine.cos(2 * quarter), -one);
    for (int32_t a = -2 * quarter; a <= 2 * quarter; ++a) {
        ASSERT_EQ(sine.sin(-a), -sine.sin(a));
        ASSERT_EQ(sine.cos(-a), sine.cos(a));
        ASSERT_EQ(sine.sin(quarter - a), sine.cos(a));
        ASSERT_EQ(sine.sin(a + 4 * quarter), sine.sin(a));
        if (a < quarter && a >= -quarter) {
            ASSERT_LE(sine.sin(a), sine.sin(a + 1));
        }
    }
}

}  // namespace
}  // namespace repousse
