#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "datapath/numbers/functions.h"

namespace repousse::test {

inline constexpr std::uint64_t kSeed = 24;

/// Index bits of the table, Newton steps, bits of the mantissa.
struct FunctionSetting {
    int index_bits;
    int newton_steps;
    int mantissa_bits;
};

/// What units are likely to be built with, and the ends of what can be.
inline constexpr FunctionSetting kConverged[] = {{5, 2, 12}, {7, 2, 16}, {9, 1, 16}, {7, 2, 24},
                                                 {8, 2, 24}, {8, 2, 29}, {4, 3, 24}, {12, 2, 29}};

/// x of 24 to 31 bits, uniform in their number, and values that are all ones or a power of two.
inline std::vector<std::uint64_t> long_operands(int count) {
    std::mt19937_64 random(kSeed);
    std::vector<std::uint64_t> operands;
    for (int bits = 24; bits <= 31; ++bits) {
        const std::uint64_t top = std::uint64_t{1} << (bits - 1);
        for (std::uint64_t x : {top, top + 1, 2 * top - 1}) operands.push_back(x);
        for (int i = 0; i < count / 8; ++i) operands.push_back(top + random() % top);
    }
    return operands;
}

inline std::vector<std::uint64_t> all_up_to(std::uint64_t last) {
    std::vector<std::uint64_t> operands;
    for (std::uint64_t x = 1; x <= last; ++x) operands.push_back(x);
    return operands;
}

inline long double value(const Scaled& scaled) {
    return std::ldexp(static_cast<long double>(scaled.mantissa), -scaled.exponent);
}

inline bool in_mantissa_range(const Scaled& scaled, int bits) {
    return scaled.mantissa >> (bits - 1) == 1;
}

/// The largest relative error against x^-power, power 1 or 1/2.
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

inline void print_row(const char* name, const FunctionSetting& c, bool converged, long double small,
                      long double large) {
    std::printf(
        "%-11s index %2d, Newton %d, mantissa %2d%s: 2^%.2f for all x < 2^18, 2^%.2f for "
        "24 to 31 bits\n",
        name, c.index_bits, c.newton_steps, c.mantissa_bits, converged ? "" : " (not converged)",
        static_cast<double>(std::log2(small)), static_cast<double>(std::log2(large)));
}

/// Calls check(configuration) for every one that has converged.
template <class Check>
void for_all_converged(int first_index_bits, int last_mantissa_bits, Check check) {
    for (int index_bits = first_index_bits; index_bits <= 12; ++index_bits) {
        for (int steps = 0; steps <= 5; ++steps) {
            for (int bits = 2; bits <= last_mantissa_bits; ++bits) {
                if (index_bits << steps > bits) check(FunctionSetting{index_bits, steps, bits});
            }
        }
    }
}

}  // namespace repousse::test
