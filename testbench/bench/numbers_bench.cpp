// What a format that is data costs: multiply-adds with prepared casts beside hand-written int64
// with the format in the code, SystemC's types and plain double. The table at the end has the
// ratios of one run; the rounds of all benchmarks are interleaved, and the best round counts.

#define SC_INCLUDE_FX
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <systemc>
#include <vector>

#include "datapath/numbers/cast.h"
#include "datapath/numbers/kernels.h"
#include "testbench/bench/best_rounds.h"

namespace {

using repousse::Cast;
using repousse::CastCounters;
using repousse::bench::Row;

constexpr std::size_t kLength = 1024;  // every array stays in the first-level cache
constexpr int kFrac = 16;

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SAME_CLONES __attribute__((target_clones("default", "avx2")))  // as the kernels have
#else
#define SAME_CLONES
#endif

/// Operands of 24 to 25 bits in s15.16, addends in s31.32, and the same as doubles.
struct Data {
    std::vector<std::int32_t> a, b;
    std::vector<std::int64_t> c;
    std::vector<double> real_a, real_b, real_c;

    Data() {
        std::mt19937_64 random(2);
        for (std::size_t i = 0; i < kLength; ++i) {
            a.push_back(static_cast<std::int32_t>(random()) >> 7);
            b.push_back(static_cast<std::int32_t>(random()) >> 8);
            c.push_back(static_cast<std::int64_t>(random()) >> 16);
            real_a.push_back(std::ldexp(a[i], -kFrac));
            real_b.push_back(std::ldexp(b[i], -kFrac));
            real_c.push_back(std::ldexp(static_cast<double>(c[i]), -2 * kFrac));
        }
    }
};

const Data& data() {
    static const Data all;
    return all;
}

/// The operands in SystemC's types, in which every one of them is exact.
template <class Value, class Exact>
struct ScData {
    std::vector<Value> a, b;
    std::vector<Exact> c;

    ScData() : a(kLength), b(kLength), c(kLength) {
        for (std::size_t i = 0; i < kLength; ++i) {
            a[i] = data().real_a[i];
            b[i] = data().real_b[i];
            c[i] = data().real_c[i];
        }
    }
};

struct Exact {
    using Value = sc_dt::sc_fixed<32, 16>;
    using Product = sc_dt::sc_fixed<64, 32>;
    using Sum = sc_dt::sc_fixed<48, 32, sc_dt::SC_RND, sc_dt::SC_SAT>;
    using Result = sc_dt::sc_fixed<32, 16, sc_dt::SC_RND, sc_dt::SC_SAT>;
};
struct Fast {
    using Value = sc_dt::sc_fixed_fast<32, 16>;
    using Product = sc_dt::sc_fixed_fast<64, 32>;
    using Sum = sc_dt::sc_fixed_fast<48, 32, sc_dt::SC_RND, sc_dt::SC_SAT>;
    using Result = sc_dt::sc_fixed_fast<32, 16, sc_dt::SC_RND, sc_dt::SC_SAT>;
};

template <class Types>
const ScData<typename Types::Value, typename Types::Product>& sc_data() {
    static const ScData<typename Types::Value, typename Types::Product> all;
    return all;
}

/// The text keeps the compiler from knowing the format.
Cast cast_to(const char* format) {
    benchmark::DoNotOptimize(format);
    return Cast(2 * kFrac, *repousse::parse_format(format));
}

constexpr const char* kSumFormat = "s31.16 SC_RND SC_SAT";
constexpr const char* kSumConvergent = "s31.16 SC_RND_CONV SC_SAT";
constexpr const char* kResultFormat = "s15.16 SC_RND SC_SAT";
constexpr const char* kResultConvergent = "s15.16 SC_RND_CONV SC_SAT";

/// Hand-written with the format in the code: SC_RND by 16 bits, added to `sum`, SC_SAT to kWidth.
template <int kWidth>
inline std::int64_t round_and_clamp(std::int64_t sum, std::int64_t x) {
    constexpr std::int64_t kHigh = (std::int64_t{1} << (kWidth - 1)) - 1;
    std::int64_t y = sum + ((x + (std::int64_t{1} << (kFrac - 1))) >> kFrac);
    y = y > kHigh ? kHigh : y;
    y = y < -kHigh - 1 ? -kHigh - 1 : y;
    return y;
}

// ---- dot: sum = SAT48(sum + RND(a b)), every step waiting for the one before ----------------

std::int64_t dot_hand_written() {
    const std::int32_t* a = data().a.data();
    const std::int32_t* b = data().b.data();
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < kLength; ++i) {
        sum = round_and_clamp<48>(sum, static_cast<std::int64_t>(a[i]) * b[i]);
    }
    return sum;
}

template <class... Counter>
std::int64_t dot_cast(const Cast& shared, Counter&... counter) {
    const Cast cast = shared;
    const std::int32_t* a = data().a.data();
    const std::int32_t* b = data().b.data();
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < kLength; ++i) {
        sum = cast.accumulate(sum, static_cast<std::int64_t>(a[i]) * b[i], counter...);
    }
    return sum;
}

template <class Types>
std::int64_t dot_systemc() {
    const auto& operands = sc_data<Types>();
    typename Types::Sum sum = 0;
    for (std::size_t i = 0; i < kLength; ++i) sum += operands.a[i] * operands.b[i];
    return static_cast<std::int64_t>(std::ldexp(sum.to_double(), kFrac));
}

double dot_double() {
    const double* a = data().real_a.data();
    const double* b = data().real_b.data();
    double sum = 0;
    for (std::size_t i = 0; i < kLength; ++i) sum += a[i] * b[i];
    return sum;
}

// ---- batch: y = SAT32(RND(a b + c)), independent elements -----------------------------------

using Results = std::array<std::int64_t, kLength>;

SAME_CLONES void batch_hand_written(const std::int32_t* a, const std::int32_t* b,
                                    const std::int64_t* c, std::int64_t* __restrict y) {
    for (std::size_t i = 0; i < kLength; ++i) {
        y[i] = round_and_clamp<32>(0, static_cast<std::int64_t>(a[i]) * b[i] + c[i]);
    }
}

SAME_CLONES void batch_double(const double* a, const double* b, const double* c,
                              double* __restrict y) {
    for (std::size_t i = 0; i < kLength; ++i) y[i] = a[i] * b[i] + c[i];
}

template <class... Counter>
Results batch_cast(const Cast& cast, Counter&... counter) {
    Results y;
    repousse::multiply_add(data().a.data(), data().b.data(), data().c.data(), y.data(), kLength,
                           cast, counter...);
    return y;
}

template <class Types>
std::vector<typename Types::Result>& batch_systemc() {
    static std::vector<typename Types::Result> y(kLength);
    const auto& operands = sc_data<Types>();
    for (std::size_t i = 0; i < kLength; ++i) {
        y[i] = operands.a[i] * operands.b[i] + operands.c[i];
    }
    return y;
}

/// Nothing may be compared in speed that does not compute the same.
bool all_agree() {
    const std::int64_t sum = dot_hand_written();
    bool agree = dot_cast(cast_to(kSumFormat)) == sum && dot_systemc<Exact>() == sum;
    Results expected;
    batch_hand_written(data().a.data(), data().b.data(), data().c.data(), expected.data());
    agree = agree && batch_cast(cast_to(kResultFormat)) == expected;
    for (std::size_t i = 0; i < kLength; ++i) {
        const double value = batch_systemc<Exact>()[i].to_double();
        agree = agree && value == std::ldexp(static_cast<double>(expected[i]), -kFrac);
    }
    return agree;
}

// ---- benchmarks and their table -------------------------------------------------------------

template <class Function>
Row row(const char* name, Function function) {
    return {name, [function] { benchmark::DoNotOptimize(function()); }};
}

/// The first row of each group is the one that the ratios are relative to.
std::vector<Row> dot_rows() {
    return {
        row("dot/prepared cast SC_RND SC_SAT", [c = cast_to(kSumFormat)] { return dot_cast(c); }),
        row("dot/hand-written int64", dot_hand_written),
        row("dot/prepared cast SC_RND_CONV SC_SAT",
            [c = cast_to(kSumConvergent)] { return dot_cast(c); }),
        row("dot/prepared cast, overflows counted",
            [c = cast_to(kSumFormat)] {
                std::uint64_t overflows = 0;
                const std::int64_t sum = dot_cast(c, overflows);
                benchmark::DoNotOptimize(overflows);
                return sum;
            }),
        row("dot/prepared cast, all counters",
            [c = cast_to(kSumFormat)] {
                CastCounters counters;
                const std::int64_t sum = dot_cast(c, counters);
                benchmark::DoNotOptimize(counters);
                return sum;
            }),
        row("dot/double", dot_double),
        row("dot/sc_fixed_fast", dot_systemc<Fast>),
        row("dot/sc_fixed", dot_systemc<Exact>),
    };
}

std::vector<Row> batch_rows() {
    return {
        row("batch/prepared cast SC_RND SC_SAT",
            [c = cast_to(kResultFormat)] { return batch_cast(c); }),
        row("batch/hand-written int64",
            [] {
                Results y;
                batch_hand_written(data().a.data(), data().b.data(), data().c.data(), y.data());
                return y;
            }),
        row("batch/prepared cast SC_RND_CONV SC_SAT",
            [c = cast_to(kResultConvergent)] { return batch_cast(c); }),
        row("batch/prepared cast, all counters",
            [c = cast_to(kResultFormat)] {
                CastCounters counters;
                const Results y = batch_cast(c, counters);
                benchmark::DoNotOptimize(counters);
                return y;
            }),
        row("batch/double",
            [] {
                std::array<double, kLength> y;
                batch_double(data().real_a.data(), data().real_b.data(), data().real_c.data(),
                             y.data());
                return y;
            }),
        row("batch/sc_fixed_fast", [] { return batch_systemc<Fast>().data(); }),
        row("batch/sc_fixed", [] { return batch_systemc<Exact>().data(); }),
    };
}

}  // namespace

int main(int argc, char** argv) {
    if (!all_agree()) {
        std::fprintf(stderr, "numbers_bench: the implementations do not agree\n");
        return 1;
    }
    return repousse::bench::run_groups(argc, argv, {dot_rows(), batch_rows()}, "multiply-add",
                                       static_cast<double>(kLength), 15, 0.02);
}

// SystemC's library asks for it; nothing is elaborated here.
int sc_main(int, char**) { return 0; }
