#pragma once

#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "testbench/study/angles.h"

namespace repousse::test {

using study::to_raw;
using study::to_real;

/// Random values for unit tests, from one seed.
class Dice : public study::Dice {
public:
    using study::Dice::Dice;

    /// Uniform in [low, high], both included.
    int64_t integer(int64_t low, int64_t high) {
        return low + static_cast<int64_t>(random_() % (static_cast<uint64_t>(high - low) + 1));
    }
    /// Any raw value of a format; its ends more often than chance would have it.
    int32_t raw(const Format& format) {
        const auto pick = random_() % 16;
        if (pick == 0) return static_cast<int32_t>(format.min_raw());
        if (pick == 1) return static_cast<int32_t>(format.max_raw());
        return static_cast<int32_t>(integer(format.min_raw(), format.max_raw()));
    }
    bool flip() { return random_() % 2 == 0; }
};

/// The largest difference of two vectors' components.
inline double farthest(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::fmax(d.x, std::fmax(d.y, d.z));
}

}  // namespace repousse::test
