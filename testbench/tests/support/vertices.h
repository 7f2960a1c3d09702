#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"

namespace repousse::test {

/// Random values for unit tests, from one seed.
class Dice {
public:
    explicit Dice(uint64_t seed) : random_(seed) {}

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
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    /// A unit vector, uniform over the sphere.
    glm::dvec3 direction() {
        const double z = real(-1.0, 1.0);
        const double angle = real(0.0, 6.283185307179586);
        const double rho = std::sqrt(1.0 - z * z);
        return {rho * std::cos(angle), rho * std::sin(angle), z};
    }
    bool flip() { return random_() % 2 == 0; }

private:
    std::mt19937_64 random_;
};

/// To the nearest raw value of a signed format, saturated: the host's rounding.
inline int32_t to_raw(double value, const Format& format) {
    const double scaled = std::floor(std::ldexp(value, format.frac) + 0.5);
    return static_cast<int32_t>(
        std::fmin(std::fmax(scaled, double(format.min_raw())), double(format.max_raw())));
}

inline Vec3<int32_t> to_raw(const glm::dvec3& v, const Format& format) {
    return {to_raw(v.x, format), to_raw(v.y, format), to_raw(v.z, format)};
}

/// What raw values stand for; exact.
inline glm::dvec3 to_real(const Vec3<int32_t>& v, const Format& format) {
    return {std::ldexp(v.x, -format.frac), std::ldexp(v.y, -format.frac),
            std::ldexp(v.z, -format.frac)};
}

/// The largest difference of two vectors' components.
inline double farthest(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::fmax(d.x, std::fmax(d.y, d.z));
}

}  // namespace repousse::test
