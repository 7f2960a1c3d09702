// x^n of cosines against std::pow.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "datapath/units/shade.h"

namespace repousse {
namespace {

double value(const Scaled& s) { return std::ldexp(static_cast<double>(s.mantissa), -s.exponent); }

// The bound that power.h states, with the logarithm's h^3 sqrt(3) / (108 ln 2) and the rounding of
// its knots, a quarter of that. Every x of 16 fraction bits.
TEST(Power, IsWithinItsBoundForEveryCosine) {
    for (const int index : {3, 4, 5}) {
        const Power power(index, index + 1);
        const double h = std::ldexp(1.0, -index);
        const double log_error =
            1.25 * h * h * h * std::sqrt(3.0) / 108 / std::log(2.0) + std::ldexp(2.0, -20);
        const double exp_error =
            h * h / 4 * std::log(2.0) * std::log(2.0) / 8 + std::ldexp(2.0, -20);
        for (const int n : {1, 2, 5, 10, 20, 32, 64, 128}) {
            double worst = 0;
            for (uint64_t x = 1; x <= 65536; ++x) {
                const double exact = std::pow(std::ldexp(static_cast<double>(x), -16), n);
                const double error =
                    std::abs(value(power(x, 16, static_cast<unsigned>(n))) - exact);
                worst = std::max(worst, error);
                ASSERT_LE(error, exact * (n * std::log(2.0) * log_error + exp_error) + 0x1p-43)
                    << "x " << x << " n " << n << " index " << index;
            }
            std::printf("2^%d log, 2^%d exp (%lld bits), n %3d: worst error 2^%.2f\n", index,
                        index + 1, static_cast<long long>(power.table_bits()), n, std::log2(worst));
        }
    }
}

TEST(Power, IsMonotoneAndExactAtTheEndsAndAtPowersOfTwo) {
    const Power power(5, 6);
    for (const unsigned n : {1U, 7U, 128U, 255U}) {
        double before = -1;
        for (uint64_t x = 0; x <= 65536; ++x) {
            const double now = value(power(x, 16, n));
            ASSERT_GE(now, before) << x << "^" << n;
            before = now;
        }
        EXPECT_EQ(value(power(0, 16, n)), 0.0);
        EXPECT_EQ(value(power(65536, 16, n)), 1.0);
        EXPECT_EQ(value(power(65600, 16, n)), 1.0);
    }
    for (int e = 0; e <= 16; ++e) {
        EXPECT_EQ(value(power(uint64_t{65536} >> e, 16, 2)), std::ldexp(1.0, -2 * e));
    }
    for (unsigned n = 1; n < 255; ++n) {
        ASSERT_GE(value(power(65000, 16, n)), value(power(65000, 16, n + 1))) << n;
    }
}

}  // namespace
}  // namespace repousse
