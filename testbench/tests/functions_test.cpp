// Reciprocal and InverseSqrt: exhaustive for small operands, sampled for long ones. The tables that
// it prints are the measured errors: run it to have them.

#include "datapath/numbers/functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

namespace repousse {
namespace {

__extension__ typedef unsigned __int128 Wide;

constexpr std::uint64_t kSeed = 24;

struct Configuration {
    int index_bits;
    int newton_steps;
    int mantissa_bits;
};

/// What units are likely to be built with, and the ends of what can be.
constexpr Configuration kConverged[] = {{5, 2, 12}, {7, 2, 16}, {9, 1, 16}, {7, 2, 24},
                                        {8, 2, 24}, {8, 2, 29}, {4, 3, 24}, {12, 2, 29}};

/// x of 24 to 31 bits, uniform in their number, and values that are all ones or a power of two.
std::vector<std::uint64_t> long_operands(int count) {
    std::mt19937_64 random(kSeed);
    std::vector<std::uint64_t> operands;
    for (int bits = 24; bits <= 31; ++bits) {
        const std::uint64_t top = std::uint64_t{1} << (bits - 1);
        for (std::uint64_t x : {top, top + 1, 2 * top - 1}) operands.push_back(x);
        for (int i = 0; i < count / 8; ++i) operands.push_back(top + random() % top);
    }
    return operands;
}

/// 2^exponent / x rounded to nearest; there are no ties unless x is a power of two.
std::uint64_t rounded_quotient(int exponent, std::uint64_t x) {
    return static_cast<std::uint64_t>(((Wide{1} << exponent) + x / 2) / x);
}

long double value(const Scaled& scaled) {
    return std::ldexp(static_cast<long double>(scaled.mantissa), -scaled.exponent);
}

/// a <= b in exact arithmetic.
bool not_above(const Scaled& a, const Scaled& b) {
    const int shared = std::min(a.exponent, b.exponent);
    return (Wide(a.mantissa) << (b.exponent - shared)) <=
           (Wide(b.mantissa) << (a.exponent - shared));
}

bool in_mantissa_range(const Scaled& scaled, int bits) {
    return scaled.mantissa >> (bits - 1) == 1;
}

template <class Function>
long double worst_error(const Function& function, long double power,
                        const std::vector<std::uint64_t>& operands) {
    long double worst = 0;
    for (std::uint64_t x : operands) {
        const long double exact =
            power == 1 ? 1.0L / x : 1.0L / std::sqrt(static_cast<long double>(x));
        worst = std::max(worst, std::abs(value(function(x)) / exact - 1));
    }
    return worst;
}

std::vector<std::uint64_t> all_up_to(std::uint64_t last) {
    std::vector<std::uint64_t> operands;
    for (std::uint64_t x = 1; x <= last; ++x) operands.push_back(x);
    return operands;
}

void print_row(const char* name, const Configuration& c, bool converged, long double small,
               long double large) {
    std::printf(
        "%-11s index %2d, Newton %d, mantissa %2d%s: 2^%.2f for all x < 2^18, 2^%.2f for "
        "24 to 31 bits\n",
        name, c.index_bits, c.newton_steps, c.mantissa_bits, converged ? "" : " (not converged)",
        static_cast<double>(std::log2(small)), static_cast<double>(std::log2(large)));
}

// ---- Reciprocal -----------------------------------------------------------------------------

TEST(Reciprocal, IsTheRoundedQuotient) {
    const std::vector<std::uint64_t> large = long_operands(400'000);
    for (const Configuration& c : kConverged) {
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

/// Calls check(configuration) for every one that has converged.
template <class Check>
void for_all_converged(int first_index_bits, int last_mantissa_bits, Check check) {
    for (int index_bits = first_index_bits; index_bits <= 12; ++index_bits) {
        for (int steps = 0; steps <= 5; ++steps) {
            for (int bits = 2; bits <= last_mantissa_bits; ++bits) {
                if (index_bits << steps > bits) check(Configuration{index_bits, steps, bits});
            }
        }
    }
}

TEST(Reciprocal, IsTheRoundedQuotientInEveryConfigurationThatHasConverged) {
    const std::vector<std::uint64_t> large = long_operands(1'000);
    int configurations = 0;
    for_all_converged(1, Reciprocal::kMaxMantissaBits, [&](const Configuration& c) {
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
    for (const Configuration& c : kConverged) {
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
    for (const Configuration& c :
         {Configuration{1, 0, 24}, Configuration{6, 0, 24}, Configuration{8, 0, 24},
          Configuration{6, 1, 24}, Configuration{8, 1, 24}, Configuration{12, 1, 31}}) {
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
    for (const Configuration& c : kConverged) {
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
    for (const Configuration& c : kConverged) {
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

// ---- InverseSqrt ----------------------------------------------------------------------------

TEST(InverseSqrt, ErrsByLittleMoreThanHalfAUnitOfTheMantissa) {
    const std::vector<std::uint64_t> small = all_up_to((1 << 18) - 1);
    const std::vector<std::uint64_t> large = long_operands(400'000);
    for (const Configuration& c : kConverged) {
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
    for (const Configuration& c :
         {Configuration{2, 0, 24}, Configuration{6, 0, 24}, Configuration{8, 0, 24},
          Configuration{6, 1, 24}, Configuration{8, 1, 24}}) {
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
    for_all_converged(2, InverseSqrt::kMaxMantissaBits, [](const Configuration& c) {
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
TEST(Functions, BatchesGiveWhatSingleNumbersDo) {
    std::mt19937_64 random(kSeed);
    for (const Configuration& c : {Configuration{7, 2, 24}, {5, 0, 24}, {2, 1, 20}, {12, 2, 29}}) {
        const Reciprocal reciprocal(c.index_bits, c.newton_steps, c.mantissa_bits);
        const InverseSqrt inverse_sqrt(c.index_bits, c.newton_steps, c.mantissa_bits);
        for (std::size_t n = 0; n <= kFunctionBatch; ++n) {
            std::vector<std::int32_t> x(n), mantissas(n), exponents(n);
            std::vector<std::int64_t> squares(n);
            for (std::size_t i = 0; i < n; ++i) {
                x[i] = static_cast<std::int32_t>(random() >> (33 + random() % 31) | 1);
                squares[i] = static_cast<std::int64_t>(random() >> (1 + random() % 63));
            }
            reciprocal(x.data(), n, mantissas.data(), exponents.data());
            for (std::size_t i = 0; i < n; ++i) {
                const Scaled r = reciprocal(static_cast<std::uint64_t>(x[i]));
                ASSERT_EQ(mantissas[i], r.mantissa) << x[i];
                ASSERT_EQ(exponents[i], r.exponent) << x[i];
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
