// The prepared casts against SystemC's sc_fix and sc_ufix: value and overflow flag of 12 million
// casts, every pair of modes. A second test shows that the first can fail.

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "datapath/numbers/cast.h"
#include "testbench/tests/support/cast_cases.h"
#include "testbench/tests/support/sc_fix_oracle.h"

namespace repousse::test {
namespace {

constexpr std::uint64_t kSeed = 1666;
constexpr int kSourcesPerTarget = 96;  // SystemC's set-up of a format costs as much as some casts

CastResult ours(const Cast& cast, std::int64_t x) {
    std::uint64_t overflows = 0;
    const std::int64_t value = cast(x, overflows);
    return {value, overflows != 0};
}

/// The full table, whatever fast case the cast has.
CastResult by_general_path(const Cast& cast, std::int64_t x) {
    const std::int64_t wanted = cast.quantize<CastKind::General>(x);
    const std::int64_t value = cast.fit<CastKind::General>(wanted);
    return {value, value != wanted};
}

std::string describe(const CastTarget& target, std::int64_t x) {
    return to_string(target.format) + ", " + std::to_string(target.dropped) +
           " bits dropped, x = " + std::to_string(x);
}

/// Gives the target a random position of the binary point: only differences may matter.
Cast place(CastTarget& target, std::mt19937_64& random) {
    const int source_frac = static_cast<int>(random() % 60) - 20;
    target.format.frac = source_frac - target.dropped;
    return Cast(source_frac, target.format);
}

class CastAgainstScFix : public testing::TestWithParam<bool> {};

TEST_P(CastAgainstScFix, ValuesAndFlagsAreEqual) {
    constexpr std::int64_t kCases = 6'000'000;
    const bool is_signed = GetParam();
    std::vector<CastGroup> groups;
    for (const CastGroup& group : all_cast_groups()) {
        if (group.is_signed == is_signed) groups.push_back(group);
    }
    std::mt19937_64 random(kSeed + (is_signed ? 1 : 0));
    std::int64_t cases = 0;
    std::int64_t overflows = 0;
    std::int64_t mismatches = 0;
    while (cases < kCases) {
        for (const CastGroup& group : groups) {
            CastTarget target = random_target(group, random);
            const Cast cast = place(target, random);
            ScFixOracle oracle(target.format, target.dropped);
            for (int i = 0; i < kSourcesPerTarget; ++i, ++cases) {
                const std::int64_t x = random_source(target, random);
                const CastResult expected = oracle(x);
                overflows += expected.overflow ? 1 : 0;
                const bool equal = ours(cast, x) == expected &&
                                   by_general_path(cast, x) == expected &&
                                   cast(x) == expected.value;
                if (equal) continue;
                if (++mismatches <= 10) {
                    ADD_FAILURE() << describe(target, x) << ": " << cast(x) << ", sc_fix has "
                                  << expected.value << " overflow " << expected.overflow;
                }
            }
        }
    }
    std::cout << (is_signed ? "sc_fix: " : "sc_ufix: ") << cases << " casts, " << groups.size()
              << " groups of modes, " << overflows << " overflows, seed " << kSeed << ": "
              << mismatches << " mismatches\n";
    EXPECT_EQ(mismatches, 0);
    EXPECT_GT(overflows, cases / 4) << "the cases no longer reach the ends of the range";
    EXPECT_LT(overflows, cases * 3 / 4) << "the cases hardly ever stay in range";
}

INSTANTIATE_TEST_SUITE_P(Signs, CastAgainstScFix, testing::Values(false, true),
                         [](const auto& sign) { return sign.param ? "sc_fix" : "sc_ufix"; });

/// A wrong entry in the table of CastSteps.
struct Mutant {
    const char* name;
    std::function<void(CastSteps&, const Format&)> apply;
};

/// A mutant that touches one quantization mode, where there is anything to round.
Mutant quantization_mutant(const char* name, Quantization mode,
                           const std::function<void(CastSteps&)>& change) {
    return {name, [=](CastSteps& steps, const Format& format) {
                if (format.quantization == mode && steps.right > 0) change(steps);
            }};
}

/// A mutant that touches one overflow mode.
Mutant overflow_mutant(const char* name, Overflow mode,
                       const std::function<void(CastSteps&, const Format&)>& change) {
    return {name, [=](CastSteps& steps, const Format& format) {
                if (format.overflow == mode) change(steps, format);
            }};
}

std::vector<Mutant> mutants() {
    using Q = Quantization;
    using O = Overflow;
    return {
        quantization_mutant("SC_TRN adds one", Q::SC_TRN, [](auto& s) { s.bias = 1; }),
        quantization_mutant("SC_TRN_ZERO adds 2^r", Q::SC_TRN_ZERO,
                            [](auto& s) { ++s.bias_if_negative; }),
        quantization_mutant("SC_RND sends ties down", Q::SC_RND, [](auto& s) { --s.bias; }),
        quantization_mutant("SC_RND_MIN_INF sends ties up", Q::SC_RND_MIN_INF,
                            [](auto& s) { ++s.bias; }),
        quantization_mutant("SC_RND_ZERO sends negative ties down", Q::SC_RND_ZERO,
                            [](auto& s) { s.bias_if_negative = 0; }),
        quantization_mutant("SC_RND_INF sends negative ties up", Q::SC_RND_INF,
                            [](auto& s) { s.bias_if_negative = 0; }),
        quantization_mutant("SC_RND_CONV sends ties down", Q::SC_RND_CONV,
                            [](auto& s) { s.bias_if_odd = 0; }),
        quantization_mutant("SC_RND_CONV sends ties up", Q::SC_RND_CONV,
                            [](auto& s) {
                                ++s.bias;
                                s.bias_if_odd = 0;
                            }),
        overflow_mutant("SC_SAT lets max + 1 pass", O::SC_SAT, [](auto& s, auto&) { ++s.high; }),
        overflow_mutant("SC_SAT_SYM allows -max - 1", O::SC_SAT_SYM,
                        [](auto& s, auto& f) { s.low = f.min_raw(); }),
        overflow_mutant("SC_SAT_ZERO saturates", O::SC_SAT_ZERO,
                        [](auto& s, auto&) {
                            s.above = s.high;
                            s.below = s.low;
                        }),
        overflow_mutant("SC_WRAP extends the wrong sign bit", O::SC_WRAP,
                        [](auto& s, auto& f) { s.unused += f.width > 1 ? 1 : 0; }),
        overflow_mutant("SC_WRAP n keeps n - 1", O::SC_WRAP,
                        [](auto& s, auto& f) {
                            if (f.saturated_bits > 0) s.kept = 2 * s.kept + 1;
                        }),
        overflow_mutant("SC_WRAP n sets every bit", O::SC_WRAP,
                        [](auto& s, auto& f) {
                            if (f.saturated_bits > 0) s.above = s.high;
                        }),
        overflow_mutant("SC_WRAP_SM 0 never inverts", O::SC_WRAP_SM,
                        [](auto& s, auto& f) {
                            if (f.saturated_bits == 0) s.flip_a = s.flip_b;
                        }),
        overflow_mutant("SC_WRAP_SM 1 looks at bit w", O::SC_WRAP_SM,
                        [](auto& s, auto& f) {
                            if (f.saturated_bits == 1 && f.width < 63) s.flip_b = f.width;
                        }),
        overflow_mutant("SC_WRAP_SM n inverts the others", O::SC_WRAP_SM,
                        [](auto& s, auto& f) {
                            if (f.saturated_bits > 1) s.flip_odd = 0;
                        }),
    };
}

TEST(CastAgainstScFix, EveryWrongTableIsCaughtIn100000Cases) {
    struct Case {
        CastTarget target;
        int source_frac;
        std::int64_t x;
        CastResult expected;
    };
    const std::vector<CastGroup> groups = all_cast_groups();
    std::mt19937_64 random(kSeed);
    std::vector<Case> cases;
    while (cases.size() < 100'000) {
        const CastGroup& group = groups[random() % groups.size()];
        CastTarget target = random_target(group, random);
        place(target, random);
        ScFixOracle oracle(target.format, target.dropped);
        for (int i = 0; i < 16; ++i) {
            const std::int64_t x = random_source(target, random);
            cases.push_back({target, target.format.frac + target.dropped, x, oracle(x)});
        }
    }
    for (const Mutant& mutant : mutants()) {
        std::int64_t caught = 0;
        for (const Case& c : cases) {
            CastSteps steps = make_steps(c.source_frac, c.target.format);
            mutant.apply(steps, c.target.format);
            const Cast cast(steps, c.target.format);
            caught += ours(cast, c.x) == c.expected ? 0 : 1;
        }
        std::cout << "mutant '" << mutant.name << "': " << caught << " mismatches\n";
        EXPECT_GT(caught, 0) << mutant.name;
    }
}

}  // namespace
}  // namespace repousse::test
