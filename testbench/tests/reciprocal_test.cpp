// Reciprocal: exhaustive for small operands, sampled for long ones. The tables that it prints are
// the measured errors: run it to have them.

#include "datapath/numbers/functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "testbench/tests/support/function_errors.h"

namespace repousse {
namespace {

using test::all_up_to;
using test::for_all_converged;
using test::FunctionSetting;
using test::in_mantissa_range;
using test::kConverged;
using test::kSeed;
using test::long_operands;
using test::print_row;
using test::value;
using test::worst_error;

__extension__ using Wide = unsigned __int128;

/// 2^exponent / x rounded to nearest; there are no ties unless x is a power of two.
std::uint64_t rounded_quotient(int exponent, std::uint64_t x) {
    return static_cast<std::uint64_t>(((Wide{1} << exponent) + x / 2) / x);
}

/// a <= b in exact arithmetic.
bool not_above(const Scaled& a, const Scaled& b) {
    const int shared = std::min(a.exponent, b.exponent);
    return (Wide(a.mantissa) << (b.exponent - shared)) <=
           (Wide(b.mantissa) << (a.exponent - shared));
}

TEST(Reciprocal, IsTheRoundedQuotient) {
    const std::vector<std::uint64_t> large = long_operands(400'000);
    for (const FunctionSetting& c : kConverged) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        ASSERT_TRUE(reciprocal.converged());
        const auto expect_rounded = [&](std::uint64_t x) {
            const Scaled r = reciprocal(x);
            return in_mantissa_range(r, c.mantissa_bits) &&
                   static_cast<std::uint64_t>(r.mantissa) == rounded_quotient(r.exponent, x);
        };
        for (std::uint64_t x = 1; x < (1U << 18); ++x) ASSERT_TRUE(expect_rounded(x)) << x;
        for (std::uint64_t x : large) ASSERT_TRUE(expect_rounded(x)) << x;
    }
}

TEST(Reciprocal, IsTheRoundedQuotientInEveryConfigurationThatHasConverged) {
    const std::vector<std::uint64_t> large = long_operands(1'000);
    int configurations = 0;
    for_all_converged(1, Reciprocal::kMaxMantissaBits, [&](const FunctionSetting& c) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        ++configurations;
        std::vector<std::uint64_t> operands = large;
        for (std::uint64_t x = 1; x < 2048; ++x) operands.push_back(x);
        for (std::uint64_t x : operands) {
            const Scaled r = reciprocal(x);
            ASSERT_EQ(static_cast<std::uint64_t>(r.mantissa), rounded_quotient(r.exponent, x))
                << c.index_bits << " " << c.newton_steps << " " << c.mantissa_bits << " " << x;
        }
    });
    EXPECT_GT(configurations, 1000);
}

TEST(Reciprocal, IsRoundedForTheLongestMantissaToo) {
    const Reciprocal reciprocal(8, 2, 31);
    ASSERT_TRUE(reciprocal.converged());
    for (std::uint64_t x : long_operands(2'000'000)) {
        const Scaled r = reciprocal(x);
        ASSERT_EQ(static_cast<std::uint64_t>(r.mantissa), rounded_quotient(r.exponent, x)) << x;
    }
}

TEST(Reciprocal, ErrsByHalfAUnitOfTheMantissa) {
    const std::vector<std::uint64_t> small = all_up_to((1 << 18) - 1);
    const std::vector<std::uint64_t> large = long_operands(400'000);
    for (const FunctionSetting& c : kConverged) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        const long double errors[] = {worst_error(reciprocal, 1, small),
                                      worst_error(reciprocal, 1, large)};
        print_row("1/x", c, true, errors[0], errors[1]);
        const long double bound = std::ldexp(1.0L, -c.mantissa_bits) * (1 + 1e-9L);
        EXPECT_LE(errors[0], bound);
        EXPECT_LE(errors[1], bound);
    }
}

TEST(Reciprocal, ShowsTheSeedsErrorIfItHasNotConverged) {
    const std::vector<std::uint64_t> small = all_up_to((1 << 18) - 1);
    const std::vector<std::uint64_t> large = long_operands(100'000);
    for (const FunctionSetting& c :
         {FunctionSetting{1, 0, 24}, FunctionSetting{6, 0, 24}, FunctionSetting{8, 0, 24},
          FunctionSetting{6, 1, 24}, FunctionSetting{8, 1, 24}, FunctionSetting{12, 1, 31}}) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        EXPECT_FALSE(reciprocal.converged());
        const long double errors[] = {worst_error(reciprocal, 1, small),
                                      worst_error(reciprocal, 1, large)};
        print_row("1/x", c, false, errors[0], errors[1]);
        const long double order = std::ldexp(1.0L, -(c.index_bits << c.newton_steps));
        EXPECT_LE(errors[1], order);
        EXPECT_GT(errors[1], std::ldexp(1.0L, -c.mantissa_bits)) << "then it has converged";
    }
}

TEST(Reciprocal, NeverGrows) {
    for (const FunctionSetting& c : kConverged) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (std::uint64_t x = 0; x < (1U << 18); ++x) {
            ASSERT_TRUE(not_above(reciprocal(x + 1), reciprocal(x))) << x;
        }
        for (std::uint64_t x : long_operands(100'000)) {
            ASSERT_TRUE(not_above(reciprocal(x + 1), reciprocal(x))) << x;
            const std::uint64_t longer = (x << 20) + 0xfffff;
            ASSERT_TRUE(not_above(reciprocal(longer + 1), reciprocal(longer))) << longer;
        }
    }
}

TEST(Reciprocal, MayGrowIfItHasNotConverged) {
    const Reciprocal reciprocal(6, 1, 24);
    int grown = 0;
    for (std::uint64_t x = 1; x < (1U << 18); ++x) {
        grown += not_above(reciprocal(x + 1), reciprocal(x)) ? 0 : 1;
    }
    EXPECT_GT(grown, 0) << "the test above could not fail";
}

TEST(Reciprocal, IsExactForPowersOfTwo) {
    for (const FunctionSetting& c : kConverged) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (int n = 0; n < 64; ++n) {
            const Scaled r = reciprocal(std::uint64_t{1} << n);
            EXPECT_EQ(r.mantissa, std::int64_t{1} << (c.mantissa_bits - 1));
            EXPECT_EQ(r.exponent, n + c.mantissa_bits - 1);
        }
    }
}

TEST(Reciprocal, OfLongOperandsUsesTheLeading32Bits) {
    const Reciprocal reciprocal(8, 2, 31);
    std::mt19937_64 random(kSeed);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t x = random() | (std::uint64_t{1} << 40);
        const long double error = value(reciprocal(x)) * x - 1;
        ASSERT_LE(std::abs(error), std::ldexp(1.0L, -31) * 2) << x;
    }
}

TEST(Reciprocal, OfZeroIsAboveEveryOther) {
    const Reciprocal reciprocal(8, 2, 24);
    const Scaled zero = reciprocal(0);
    EXPECT_EQ(zero.mantissa, (1 << 24) - 1);
    EXPECT_EQ(zero.exponent, 23);
    EXPECT_EQ(value(reciprocal(1)), 1);
    EXPECT_GT(value(zero), 1);
}

TEST(Reciprocal, SeedsFitTheirRom) {
    for (int index_bits = 1; index_bits <= Reciprocal::kMaxIndexBits; ++index_bits) {
        const Reciprocal reciprocal(index_bits, 0, 24);
        ASSERT_EQ(reciprocal.seeds().size(), std::size_t{1} << index_bits);
        for (std::uint32_t seed : reciprocal.seeds()) ASSERT_EQ(seed >> (index_bits + 3), 1U);
    }
}

// Batches of every length, with numbers of every length.
TEST(Reciprocal, BatchesGiveWhatSingleNumbersDo) {
    std::mt19937_64 random(kSeed);
    for (const FunctionSetting& c :
         {FunctionSetting{7, 2, 24}, {5, 0, 24}, {2, 1, 20}, {12, 2, 29}}) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (std::size_t n = 0; n <= kFunctionBatch; ++n) {
            std::vector<std::int32_t> x(n), mantissas(n), exponents(n);
            for (std::int32_t& number : x) {
                number = static_cast<std::int32_t>(random() >> (33 + random() % 31) | 1);
            }
            reciprocal(x.data(), n, mantissas.data(), exponents.data());
            for (std::size_t i = 0; i < n; ++i) {
                const Scaled r = reciprocal(static_cast<std::uint64_t>(x[i]));
                ASSERT_EQ(mantissas[i], r.mantissa) << x[i];
                ASSERT_EQ(exponents[i], r.exponent) << x[i];
            }
        }
    }
}

}  // namespace
}  // namespace repousse
