#pragma once

#include <cstddef>
#include <cstdint>

#include "datapath/numbers/cast.h"

namespace repousse {

/// Batches of one operation with one cast. The arrays hold n raw integers each, one array for one
/// signal (structure of arrays); y may be the same array as an operand, but must not overlap one
/// otherwise. The kind of the cast is looked at once per batch, and the loops vectorise.
///
/// Each operation exists with and without counters, with the same results. The exact operand of the
/// cast must be in the range of a Cast (datapath/numbers/cast.h).

/// y[i] = cast(x[i])
void cast_array(const std::int64_t* x, std::int64_t* y, std::size_t n, const Cast& cast);
void cast_array(const std::int64_t* x, std::int64_t* y, std::size_t n, const Cast& cast,
                CastCounters& counters);

/// y[i] = cast(a[i] + b[i]); the cast's source has the fraction bits that a and b have in common.
void add(const std::int64_t* a, const std::int64_t* b, std::int64_t* y, std::size_t n,
         const Cast& cast);
void add(const std::int64_t* a, const std::int64_t* b, std::int64_t* y, std::size_t n,
         const Cast& cast, CastCounters& counters);

/// y[i] = cast(a[i] * b[i] + c[i]); the cast's source has the fraction bits of c, which are those
/// of a and b together. Factors of at most 32 bits let the product be one vector instruction.
void multiply_add(const std::int32_t* a, const std::int32_t* b, const std::int64_t* c,
                  std::int64_t* y, std::size_t n, const Cast& cast);
void multiply_add(const std::int32_t* a, const std::int32_t* b, const std::int64_t* c,
                  std::int64_t* y, std::size_t n, const Cast& cast, CastCounters& counters);

}  // namespace repousse
