// InverseSqrt: exhaustive for small operands, sampled for long ones. The tables that it prints are
// the measured errors: run it to have them.

#include "datapath/numbers/functions.h"

#include <gtest/gtest.h>

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

TEST(InverseSqrt, ErrsByLittleMoreThanHalfAUnitOfTheMantissa) {
    const std::vector<std::uint64_t> small = all_up_to((1 << 18) - 1);
    const std::vector<std::uint64_t> large = long_operands(400'000);
    for (const FunctionSetting& c : kConverged) {
        const InverseSqrt inverse_sqrt(c.index_bits, c.newton_steps, c.mantissa_bits);
        ASSERT_TRUE(inverse_sqrt.converged());
        const long double errors[] = {worst_error(inverse_sqrt, 0.5L, small),
                                      worst_error(inverse_sqrt, 0.5L, large)};
        print_row("1/sqrt(x)", c, true, errors[0], errors[1]);
        const long double bound = std::ldexp(1.0L, -c.mantissa_bits) + std::ldexp(1.0L, -30) +
                                  std::ldexp(1.0L, -(c.index_bits << c.newton_steps));
        EXPECT_LE(errors[0], bound);
        EXPECT_LE(errors[1], bound);
        for (std::uint64_t x : large) {
            ASSERT_TRUE(in_mantissa_range(inverse_sqrt(x), c.mantissa_bits)) << x;
        }
    }
}

TEST(InverseSqrt, ShowsTheSeedsErrorIfItHasNotConverged) {
    const std::vector<std::uint64_t> small = all_up_to((1 << 18) - 1);
    const std::vector<std::uint64_t> large = long_operands(100'000);
    for (const FunctionSetting& c :
         {FunctionSetting{2, 0, 24}, FunctionSetting{6, 0, 24}, FunctionSetting{8, 0, 24},
          FunctionSetting{6, 1, 24}, FunctionSetting{8, 1, 24}}) {
        const InverseSqrt inverse_sqrt(c.index_bits, c.newton_steps, c.mantissa_bits);
        EXPECT_FALSE(inverse_sqrt.converged());
        const long double errors[] = {worst_error(inverse_sqrt, 0.5L, small),
                                      worst_error(inverse_sqrt, 0.5L, large)};
        print_row("1/sqrt(x)", c, false, errors[0], errors[1]);
        EXPECT_LE(errors[1], std::ldexp(1.0L, -(c.index_bits << c.newton_steps)));
        EXPECT_GT(errors[1], std::ldexp(1.0L, -c.mantissa_bits)) << "then it has converged";
    }
}

TEST(InverseSqrt, IsExactForPowersOfFour) {
    for_all_converged(2, InverseSqrt::kMaxMantissaBits, [](const FunctionSetting& c) {
        const InverseSqrt inverse_sqrt(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (int n = 0; n < 32; ++n) {
            const Scaled r = inverse_sqrt(std::uint64_t{1} << (2 * n));
            EXPECT_EQ(r.mantissa, std::int64_t{1} << (c.mantissa_bits - 1)) << n;
            EXPECT_EQ(r.exponent, n + c.mantissa_bits - 1) << n;
        }
    });
}

TEST(InverseSqrt, OfLongOperandsUsesTheLeadingBits) {
    const InverseSqrt inverse_sqrt(8, 2, 29);
    std::mt19937_64 random(kSeed);
    for (int i = 0; i < 100'000; ++i) {
        const std::uint64_t x = random() | (std::uint64_t{1} << 40);
        const long double error =
            value(inverse_sqrt(x)) * std::sqrt(static_cast<long double>(x)) - 1;
        ASSERT_LE(std::abs(error), std::ldexp(1.0L, -29) + std::ldexp(1.5L, -30)) << x;
    }
}

TEST(InverseSqrt, OfZeroIsAboveEveryOther) {
    const InverseSqrt inverse_sqrt(8, 2, 24);
    EXPECT_EQ(inverse_sqrt(0).mantissa, (1 << 24) - 1);
    EXPECT_EQ(value(inverse_sqrt(1)), 1);
    EXPECT_GT(value(inverse_sqrt(0)), 1);
}

TEST(InverseSqrt, SeedsFitTheirRom) {
    for (int index_bits = 2; index_bits <= InverseSqrt::kMaxIndexBits; ++index_bits) {
        const InverseSqrt inverse_sqrt(index_bits, 0, 24);
        ASSERT_EQ(inverse_sqrt.seeds().size(), std::size_t{1} << index_bits);
        for (std::uint32_t seed : inverse_sqrt.seeds()) ASSERT_EQ(seed >> (index_bits + 3), 1U);
    }
}

// Batches of every length, with numbers of every length.
TEST(InverseSqrt, BatchesGiveWhatSingleNumbersDo) {
    std::mt19937_64 random(kSeed);
    for (const FunctionSetting& c :
         {FunctionSetting{7, 2, 24}, {5, 0, 24}, {2, 1, 20}, {12, 2, 29}}) {
        const InverseSqrt inverse_sqrt(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (std::size_t n = 0; n <= kFunctionBatch; ++n) {
            std::vector<std::int32_t> mantissas(n), exponents(n);
            std::vector<std::int64_t> squares(n);
            for (std::int64_t& square : squares) {
                square = static_cast<std::int64_t>(random() >> (1 + random() % 63));
            }
            inverse_sqrt(squares.data(), n, mantissas.data(), exponents.data());
            for (std::size_t i = 0; i < n; ++i) {
                const auto q = static_cast<std::uint64_t>(squares[i] == 0 ? 1 : squares[i]);
                const Scaled r = inverse_sqrt(q);
                ASSERT_EQ(mantissas[i], r.mantissa) << squares[i];
                ASSERT_EQ(exponents[i], r.exponent) << squares[i];
            }
        }
    }
}

}  // namespace
}  // namespace repousse
