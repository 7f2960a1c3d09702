#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "datapath/units/shade.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse::test {

/// A light in doubles.
struct Lamp {
    glm::dvec3 direction, diffuse, specular;
};

/// A unit under a shipped profile, and registers for it.
class ShadeUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = profile_with(GetParam(), {});
    Shade<Fixed> unit_{profile_};
    const double lsb_ = std::ldexp(1.0, -profile_.colour.frac);

    int32_t light(double x) const {
        return static_cast<int32_t>(std::lround(std::ldexp(x, profile_.light.frac)));
    }
    Colour<int32_t> light(const glm::dvec3& c) const {
        return {light(c.x), light(c.y), light(c.z)};
    }
    glm::dvec3 real(const Colour<int32_t>& c) const {
        return to_real({c.red, c.green, c.blue}, profile_.colour);
    }
    glm::dvec3 real_light(const Colour<int32_t>& c) const {
        return to_real({c.red, c.green, c.blue}, profile_.light);
    }
    int32_t one() const { return 1 << profile_.normal.frac; }

    /// `count` lights whose sum stays below one, and registers that hold them.
    ShadeRegisters<Fixed> random_scene(Dice& dice, int count, int shininess,
                                       std::vector<Lamp>& lamps) const {
        ShadeRegisters<Fixed> r;
        const auto colour = [&](double most) {
            return light(glm::dvec3(dice.real(0, most), dice.real(0, most), dice.real(0, most)));
        };
        r.ambient = colour(0.1);
        r.shininess = shininess;
        lamps.clear();
        for (int i = 0; i < count; ++i) {
            Light<Fixed>& l = r.lights[static_cast<std::size_t>(i)];
            const glm::dvec3 direction = dice.direction();
            l.direction = to_raw(direction, profile_.normal);
            l.diffuse = colour(0.4 / count);
            l.specular = colour(0.45 / count);
            lamps.push_back({direction, real_light(l.diffuse), real_light(l.specular)});
        }
        return r;
    }

    /// One white light from above, no ambient light.
    ShadeRegisters<Fixed> white_from_above(double diffuse, double specular, int shininess) const {
        ShadeRegisters<Fixed> r;
        r.lights[0].direction = {0, 0, one()};
        r.lights[0].diffuse = light(glm::dvec3(diffuse));
        r.lights[0].specular = light(glm::dvec3(specular));
        r.shininess = shininess;
        return r;
    }
    Colour<int32_t> grey(double x) const {
        const auto v = std::lround(
            std::min(std::ldexp(x, profile_.colour.frac), double(profile_.colour.max_raw())));
        const auto raw = static_cast<int32_t>(v);
        return {raw, raw, raw};
    }
};

}  // namespace repousse::test
