#include "datapath/numbers/kernels.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "testbench/tests/support/cast_cases.h"

namespace repousse::test {
namespace {

using Values = std::vector<std::int64_t>;

constexpr std::uint64_t kSeed = 43;
constexpr std::int64_t kUntouched = 0x5eed;

/// The lengths around the kernels' block: none, the rest alone, blocks alone, both.
constexpr int kLengths[] = {0, 1, 63, 64, 65, 200, 1024};

/// Runs a kernel with and without counters and compares every element, every counter, and the
/// element behind the end with casting value by value.
void expect_as_value_by_value(const Cast& cast, const Values& exact,
                              const std::function<void(std::int64_t*)>& plain,
                              const std::function<void(std::int64_t*, CastCounters&)>& counted) {
    CastCounters expected_counters;
    Values expected;
    for (std::int64_t x : exact) expected.push_back(cast(x, expected_counters));
    expected.push_back(kUntouched);

    Values y(expected.size(), kUntouched);
    plain(y.data());
    EXPECT_EQ(y, expected) << to_string(cast.format());

    Values y_counted(expected.size(), kUntouched);
    CastCounters counters;
    counted(y_counted.data(), counters);
    EXPECT_EQ(y_counted, expected) << to_string(cast.format());
    EXPECT_TRUE(counters == expected_counters) << to_string(cast.format());
}

/// Every pair of modes, with targets around 30 bits so that 50-bit sources overflow now and then.
template <class Check>
void for_all_modes(Check check) {
    std::mt19937_64 random(kSeed);
    for (const CastGroup& group : all_cast_groups()) {
        for (int length : kLengths) {
            CastTarget target = random_target(group, random);
            target.format.width = 28 + static_cast<int>(random() % 6);
            target.format.saturated_bits = group.saturated_bits(target.format.width, random);
            // Up to 31 bits dropped, so that both errors kept whole and errors cut short occur.
            target.dropped = static_cast<int>(random() % 36) - 4;
            target.format.frac = -target.dropped;
            check(Cast(0, target.format), length, random);
        }
    }
}

Values random_values(int length, int bits, std::mt19937_64& random) {
    Values values;
    for (int i = 0; i < length; ++i) {
        values.push_back(static_cast<std::int64_t>(random()) >> (64 - bits));
    }
    return values;
}

TEST(Kernels, CastArrayIsTheCastOfEachElement) {
    for_all_modes([](const Cast& cast, int length, std::mt19937_64& random) {
        const Values x = random_values(length, 50, random);
        expect_as_value_by_value(
            cast, x, [&](auto* y) { cast_array(x.data(), y, x.size(), cast); },
            [&](auto* y, auto& counters) { cast_array(x.data(), y, x.size(), cast, counters); });
    });
}

TEST(Kernels, AddIsTheCastOfTheSum) {
    for_all_modes([](const Cast& cast, int length, std::mt19937_64& random) {
        const Values a = random_values(length, 50, random);
        const Values b = random_values(length, 48, random);
        Values exact;
        for (std::size_t i = 0; i < a.size(); ++i) exact.push_back(a[i] + b[i]);
        expect_as_value_by_value(
            cast, exact, [&](auto* y) { add(a.data(), b.data(), y, a.size(), cast); },
            [&](auto* y, auto& counters) { add(a.data(), b.data(), y, a.size(), cast, counters); });
    });
}

TEST(Kernels, MultiplyAddIsTheCastOfTheExactSum) {
    for_all_modes([](const Cast& cast, int length, std::mt19937_64& random) {
        std::vector<std::int32_t> a;
        std::vector<std::int32_t> b;
        for (std::int64_t v : random_values(length, 26, random)) {
            a.push_back(static_cast<std::int32_t>(v));
            b.push_back(static_cast<std::int32_t>(random()) >> 8);
        }
        const Values c = random_values(length, 50, random);
        Values exact;
        for (std::size_t i = 0; i < c.size(); ++i) {
            exact.push_back(std::int64_t{a[i]} * b[i] + c[i]);
        }
        expect_as_value_by_value(
            cast, exact,
            [&](auto* y) { multiply_add(a.data(), b.data(), c.data(), y, c.size(), cast); },
            [&](auto* y, auto& counters) {
                multiply_add(a.data(), b.data(), c.data(), y, c.size(), cast, counters);
            });
    });
}

TEST(Kernels, MayWriteOverAnOperand) {
    std::mt19937_64 random(kSeed);
    const Cast cast(12, *parse_format("s20.4 SC_RND SC_SAT"));
    const Values a = random_values(200, 30, random);
    const Values b = random_values(200, 30, random);
    Values expected(a.size());
    add(a.data(), b.data(), expected.data(), a.size(), cast);
    Values over = b;
    add(a.data(), over.data(), over.data(), a.size(), cast);
    EXPECT_EQ(over, expected);
    CastCounters counters;
    over = a;
    add(over.data(), b.data(), over.data(), a.size(), cast, counters);
    EXPECT_EQ(over, expected);
}

TEST(Kernels, CountersOfTwoBatchesAddUp) {
    std::mt19937_64 random(kSeed);
    const Cast cast(12, *parse_format("s9.4 SC_RND_CONV SC_SAT"));
    const Values x = random_values(300, 24, random);
    Values y(x.size());
    CastCounters whole;
    cast_array(x.data(), y.data(), 300, cast, whole);
    CastCounters parts;
    cast_array(x.data(), y.data(), 100, cast, parts);
    cast_array(x.data() + 100, y.data() + 100, 200, cast, parts);
    EXPECT_TRUE(parts == whole);
    EXPECT_EQ(whole.values, 300U);
    EXPECT_GT(whole.overflows, 0U);
}

}  // namespace
}  // namespace repousse::test
