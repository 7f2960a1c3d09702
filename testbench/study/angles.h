#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "datapath/items.h"
#include "datapath/numbers/format.h"

namespace repousse::study {

inline constexpr double kDegrees = 57.29577951308232;

/// Random values from one seed.
class Dice {
public:
    explicit Dice(uint64_t seed) : random_(seed) {}
    /// Uniform in [low, high).
    double real(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() >> 11) * 0x1p-53);
    }
    /// A unit vector, uniform over the sphere.
    glm::dvec3 direction() {
        const double z = real(-1.0, 1.0), angle = real(0.0, 6.283185307179586);
        const double rho = std::sqrt(1.0 - z * z);
        return {rho * std::cos(angle), rho * std::sin(angle), z};
    }

protected:
    std::mt19937_64 random_;
};

/// To the nearest raw value of a signed format, saturated: the host's rounding.
inline int32_t to_raw(double value, const Format& format) {
    const double scaled = std::floor(std::ldexp(value, format.frac) + 0.5);
    return static_cast<int32_t>(std::clamp(scaled, static_cast<double>(format.min_raw()),
                                           static_cast<double>(format.max_raw())));
}

inline Vec3<int32_t> to_raw(const glm::dvec3& v, const Format& format) {
    return {to_raw(v.x, format), to_raw(v.y, format), to_raw(v.z, format)};
}

/// What raw values stand for; exact.
inline glm::dvec3 to_real(const Vec3<int32_t>& v, const Format& format) {
    return {std::ldexp(v.x, -format.frac), std::ldexp(v.y, -format.frac),
            std::ldexp(v.z, -format.frac)};
}

/// The angle between two vectors; by the cross product: an arc cosine loses small angles.
inline double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegrees;
}

}  // namespace repousse::study
