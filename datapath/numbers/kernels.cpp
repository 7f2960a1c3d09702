#include "datapath/numbers/kernels.h"

#include <type_traits>

#include "datapath/numbers/vector_clones.h"

namespace repousse {
namespace {

/// Batches are cut into blocks of this constant length, which -O2 vectorises (it leaves loops alone
/// that would need a scalar rest), and the rest goes value by value. A block's sum of squared
/// errors has at most 6 + 52 bits.
constexpr std::size_t kBlock = 64;

/// y[i] = cast(exact(i)), i in [from, from + kBlock). The cast is copied, since a store to y might
/// change the caller's.
template <CastKind kKind, class Exact>
inline void run(std::size_t from, std::int64_t* y, const Cast& shared, Exact exact) {
    const Cast cast = shared;
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < kBlock; ++i) {
        y[from + i] = cast.fit<kKind>(cast.quantize<kKind>(exact(from + i)));
    }
}

/// The same, and counts as CastCounters::count does, for casts with error_shift() = 0. The exact
/// operands are made in a loop of their own: one loop needs more vector registers than there are.
template <CastKind kKind, class Exact>
inline CastCounters run_counted(std::size_t from, std::int64_t* y, const Cast& shared,
                                Exact exact) {
    const Cast cast = shared;
    std::int64_t exacts[kBlock];
    for (std::size_t i = 0; i < kBlock; ++i) exacts[i] = exact(from + i);

    CastCounters block;
    std::int64_t min = block.min;
    std::int64_t max = block.max;
    std::int64_t in_range = 0;
    std::int64_t error_sum = 0;
    std::int64_t error_squares = 0;
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < kBlock; ++i) {
        const std::int64_t x = exacts[i];
        const std::int64_t wanted = cast.quantize<kKind>(x);
        const std::int64_t value = cast.fit<kKind>(wanted);
        const std::int64_t error = cast.error<kKind>(x);
        y[from + i] = value;
        in_range += value == wanted;
        min = wanted < min ? wanted : min;
        max = wanted > max ? wanted : max;
        error_sum += error;
        error_squares += error * error;
    }
    block.values = kBlock;
    block.overflows = kBlock - static_cast<std::uint64_t>(in_range);
    block.min = min;
    block.max = max;
    block.error_sum = error_sum;
    block.error_squares.low = static_cast<std::uint64_t>(error_squares);
    return block;
}

/// Calls `kernel` with the kind of the cast as a constant.
template <class Kernel>
inline void choose(const Cast& cast, Kernel kernel) {
    using Kind = CastKind;
    switch (cast.kind()) {
        case Kind::Clamp:
            return kernel(std::integral_constant<Kind, Kind::Clamp>());
        case Kind::Wrap:
            return kernel(std::integral_constant<Kind, Kind::Wrap>());
        case Kind::VaryingClamp:
            return kernel(std::integral_constant<Kind, Kind::VaryingClamp>());
        case Kind::General:
            return kernel(std::integral_constant<Kind, Kind::General>());
    }
}

template <class Exact>
inline void batch(std::int64_t* y, std::size_t n, const Cast& cast, Exact exact) {
    const std::size_t in_blocks = n - n % kBlock;
    choose(cast, [&](auto kind) {
        for (std::size_t i = 0; i < in_blocks; i += kBlock) run<kind()>(i, y, cast, exact);
    });
    for (std::size_t i = in_blocks; i < n; ++i) y[i] = cast(exact(i));
}

template <class Exact>
inline void batch(std::int64_t* y, std::size_t n, const Cast& cast, CastCounters& counters,
                  Exact exact) {
    const std::size_t in_blocks = cast.error_shift() == 0 ? n - n % kBlock : 0;
    choose(cast, [&](auto kind) {
        for (std::size_t i = 0; i < in_blocks; i += kBlock) {
            counters.merge(run_counted<kind()>(i, y, cast, exact));
        }
    });
    for (std::size_t i = in_blocks; i < n; ++i) y[i] = cast(exact(i), counters);
}

}  // namespace

REPOUSSE_VECTOR_CLONES void cast_array(const std::int64_t* x, std::int64_t* y, std::size_t n,
                                       const Cast& cast) {
    batch(y, n, cast, [=](std::size_t i) { return x[i]; });
}

REPOUSSE_VECTOR_CLONES void cast_array(const std::int64_t* x, std::int64_t* y, std::size_t n,
                                       const Cast& cast, CastCounters& counters) {
    batch(y, n, cast, counters, [=](std::size_t i) { return x[i]; });
}

REPOUSSE_VECTOR_CLONES void add(const std::int64_t* a, const std::int64_t* b, std::int64_t* y,
                                std::size_t n, const Cast& cast) {
    batch(y, n, cast, [=](std::size_t i) { return a[i] + b[i]; });
}

REPOUSSE_VECTOR_CLONES void add(const std::int64_t* a, const std::int64_t* b, std::int64_t* y,
                                std::size_t n, const Cast& cast, CastCounters& counters) {
    batch(y, n, cast, counters, [=](std::size_t i) { return a[i] + b[i]; });
}

REPOUSSE_VECTOR_CLONES void multiply_add(const std::int32_t* a, const std::int32_t* b,
                                         const std::int64_t* c, std::int64_t* y, std::size_t n,
                                         const Cast& cast) {
    batch(y, n, cast, [=](std::size_t i) { return static_cast<std::int64_t>(a[i]) * b[i] + c[i]; });
}

REPOUSSE_VECTOR_CLONES void multiply_add(const std::int32_t* a, const std::int32_t* b,
                                         const std::int64_t* c, std::int64_t* y, std::size_t n,
                                         const Cast& cast, CastCounters& counters) {
    batch(y, n, cast, counters,
          [=](std::size_t i) { return static_cast<std::int64_t>(a[i]) * b[i] + c[i]; });
}

}  // namespace repousse
