#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <glm/geometric.hpp>

#include "datapath/units/bump.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse::test {

inline constexpr double kPi = 3.14159265358979323846;

struct BumpCase {
    const char* profile;
    const char* kind;
};

/// A unit of each kind under each shipped profile.
class BumpKinds : public testing::TestWithParam<BumpCase> {
protected:
    const Profile profile_ = profile_with(GetParam().profile, {{"bump_kind", GetParam().kind}});
    const BumpKind kind_ = static_cast<BumpKind>(profile_.bump_kind);
    Bump<Fixed> unit_{profile_};

    /// A map of one texel, or of 3 x 3 with the heights around the middle one.
    void texel(Dice& dice) {
        map_.width = map_.height = kind_ == BumpKind::Slopes ? 3 : 1;
        normal_ = to_raw(upward(dice), profile_.map_normal);
        stored_ = {int16_t(normal_.x), int16_t(normal_.y), int16_t(normal_.z)};
        for (uint16_t& h : heights_) {
            h = static_cast<uint16_t>(dice.integer(0, profile_.height.max_raw()));
        }
        turn_ = {int16_t(to_raw(dice.real(-.45, .45), profile_.angle)),
                 int16_t(to_raw(dice.real(-.45, .45), profile_.angle))};
        // Slopes of up to 4 from one end of the heights to the other.
        const auto mantissa = static_cast<int32_t>(dice.integer(1 << 23, (1 << 24) - 1));
        map_.slope_u = {mantissa, profile_.height.width + 22};
        map_.slope_v = {(1 << 24) - 1, profile_.height.width + 23};
        map_.normals = {&stored_, 1};
        map_.heights = heights_;
        map_.turns = {&turn_, 1};
        unit_.configure(map_);
    }
    glm::dvec3 upward(Dice& dice) {
        glm::dvec3 d = dice.direction();
        d.z = std::abs(d.z) + 0.05;
        return glm::normalize(d);
    }
    /// What the texel stands for, in double.
    glm::dvec3 exact_vector() const {
        const auto scale = [](const SlopeScale<Fixed>& s) {
            return std::ldexp(s.mantissa, -s.exponent);
        };
        const double a = kPi * std::ldexp(turn_.about_b, -profile_.angle.frac);
        const double b = kPi * std::ldexp(turn_.about_t, -profile_.angle.frac);
        switch (kind_) {
            case BumpKind::Slopes:
                return {-(heights_[5] - heights_[3]) * scale(map_.slope_u),
                        -(heights_[7] - heights_[1]) * scale(map_.slope_v), 1.0};
            case BumpKind::Turns:
                return {std::sin(a), std::cos(a) * std::sin(b), std::cos(a) * std::cos(b)};
            case BumpKind::Normals:
                break;
        }
        return to_real(normal_, profile_.map_normal);
    }
    Vertex<Fixed> vertex(const Vec3<int32_t>& n, const Vec3<int32_t>& t, int hand = 1) const {
        Vertex<Fixed> v;
        v.normal = n;
        v.tangent = t;
        v.handedness = int8_t(hand);
        const int32_t middle = kind_ == BumpKind::Slopes ? 3 << profile_.uv.frac >> 1 : 0;
        v.uv = {middle, middle};
        return v;
    }
    glm::dvec3 found(Vertex<Fixed>& v) {
        unit_(v);
        return to_real(v.displaced_normal, profile_.displaced_normal);
    }
    /// Rounding of a component of N' alone, as an angle: it has three.
    double last_rounding_deg() const {
        return study::kDegrees * std::sqrt(3.0) * 0.5 *
               std::ldexp(1.02, -profile_.displaced_normal.frac);
    }

    MapView<Fixed> map_;
    Vec3<int32_t> normal_;
    Vec3<int16_t> stored_;
    std::array<uint16_t, 9> heights_{};
    Turn<int16_t> turn_;
};

inline const auto kBumpCases =
    testing::Values(BumpCase{"default", "0"}, BumpCase{"default", "1"}, BumpCase{"default", "2"},
                    BumpCase{"narrow", "0"}, BumpCase{"narrow", "1"}, BumpCase{"narrow", "2"});
inline std::string bump_case_name(const testing::TestParamInfo<BumpCase>& c) {
    return std::string(c.param.profile) + "_" + c.param.kind;
}

}  // namespace repousse::test
