#pragma once

#include <algorithm>
#include <cstdint>

#include "datapath/numbers/format.h"
#include "testbench/cosim/random.h"

namespace repousse::cosim {

/// The raw value of a format, of at most 32 bits, that is nearest to `x`.
inline int32_t limited(const Format& format, int64_t x) {
    return static_cast<int32_t>(std::clamp(x, format.min_raw(), format.max_raw()));
}

/// A raw value of a format, of at most 32 bits: an end of its range now and then, else of any
/// length and either sign.
inline int32_t any_raw(Random& random, const Format& format) {
    if (random.percent(5)) return limited(format, random.percent(50) ? INT64_MIN : INT64_MAX);
    return static_cast<int32_t>(random.between(format.min_raw(), format.max_raw()) >>
                                random.below(static_cast<uint32_t>(format.width)));
}

}  // namespace repousse::cosim
