// shade: Phong's illumination against doubles, and x^n of cosines against std::pow.

#include "datapath/units/shade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 67;
constexpr int kExponents[] = {1, 2, 5, 10, 20, 32, 64, 128};

// --- x^n ------------------------------------------------------------------------------------

double value(const Scaled& s) { return std::ldexp(static_cast<double>(s.mantissa), -s.exponent); }

// The bound that power.h states, with the logarithm's h^3 sqrt(3) / (108 ln 2) and the rounding of
// its knots, a quarter of that. Every x of 16 fraction bits.
TEST(Power, IsWithinItsBoundForEveryCosine) {
    for (const int index : {3, 4, 5}) {
        const Power power(index, index + 1);
        const double h = std::ldexp(1.0, -index);
        const double log_error =
            1.25 * h * h * h * std::sqrt(3.0) / 108 / std::log(2.0) + std::ldexp(2.0, -20);
        const double exp_error =
            h * h / 4 * std::log(2.0) * std::log(2.0) / 8 + std::ldexp(2.0, -20);
        for (const int n : kExponents) {
            double worst = 0;
            for (uint64_t x = 1; x <= 65536; ++x) {
                const double exact = std::pow(std::ldexp(static_cast<double>(x), -16), n);
                const double error =
                    std::abs(value(power(x, 16, static_cast<unsigned>(n))) - exact);
                worst = std::max(worst, error);
                ASSERT_LE(error, exact * (n * std::log(2.0) * log_error + exp_error) + 0x1p-43)
                    << "x " << x << " n " << n << " index " << index;
            }
            std::printf("2^%d log, 2^%d exp (%lld bits), n %3d: worst error 2^%.2f\n", index,
                        index + 1, static_cast<long long>(power.table_bits()), n, std::log2(worst));
        }
    }
}

TEST(Power, IsMonotoneAndExactAtTheEndsAndAtPowersOfTwo) {
    const Power power(5, 6);
    for (const unsigned n : {1U, 7U, 128U, 255U}) {
        double before = -1;
        for (uint64_t x = 0; x <= 65536; ++x) {
            const double now = value(power(x, 16, n));
            ASSERT_GE(now, before) << x << "^" << n;
            before = now;
        }
        EXPECT_EQ(value(power(0, 16, n)), 0.0);
        EXPECT_EQ(value(power(65536, 16, n)), 1.0);
        EXPECT_EQ(value(power(65600, 16, n)), 1.0);
    }
    for (int e = 0; e <= 16; ++e) {
        EXPECT_EQ(value(power(uint64_t{65536} >> e, 16, 2)), std::ldexp(1.0, -2 * e));
    }
    for (unsigned n = 1; n < 255; ++n) {
        ASSERT_GE(value(power(65000, 16, n)), value(power(65000, 16, n + 1))) << n;
    }
}

// --- the unit ---------------------------------------------------------------------------------

/// The scene in doubles.
struct Lamp {
    glm::dvec3 direction, diffuse, specular;
};

/// Phong's model as it is written in textbooks.
glm::dvec3 phong(const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& ambient, int shininess,
                 const std::vector<Lamp>& lamps) {
    glm::dvec3 colour = ambient;
    for (const Lamp& lamp : lamps) {
        const double lit = glm::dot(n, lamp.direction);
        if (lit <= 0) continue;
        const glm::dvec3 mirrored = 2 * lit * n - lamp.direction;
        const double gleam = std::clamp(glm::dot(mirrored, v), 0.0, 1.0);
        colour += lamp.diffuse * lit;
        if (gleam > 0) colour += lamp.specular * std::pow(gleam, shininess);
    }
    return colour;
}

/// Phong's highlight ends abruptly where a light leaves the surface's hemisphere, so a vertex whose
/// normal is rounded may be on the other side.
bool terminator(const glm::dvec3& n, const std::vector<Lamp>& lamps, double width) {
    return std::any_of(lamps.begin(), lamps.end(), [&](const Lamp& lamp) {
        return std::abs(glm::dot(n, lamp.direction)) < width;
    });
}

class ShadeUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
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

// Everything that the unit rounds, against doubles that round nothing: P', N, L and V included.
// A vertex near the place of the highlight in half of the cases. Bounds in the sheet.
TEST_P(ShadeUnit, ErrorAgainstDoublesForEveryExponent) {
    Dice dice(kSeed);
    const bool is_default = std::string(GetParam()) == "default";
    for (const bool bumped : {false, true}) {
        for (const int n : kExponents) {
            double worst = 0, squares = 0;
            int compared = 0;
            const int scenes = 400, points = 50;
            const Format& of_n = bumped ? profile_.displaced_normal : profile_.normal;
            for (int s = 0; s < scenes; ++s) {
                std::vector<Lamp> lamps;
                const int count = 1 + s % profile_.lights;
                ShadeRegisters<Fixed> r = random_scene(dice, count, n, lamps);
                const double size = std::ldexp(1.0, profile_.position.integer_bits() - 3);
                const glm::dvec3 eye = dice.direction() * dice.real(size / 8, size);
                r.eye = to_raw(eye, profile_.position);
                unit_.configure(r);
                for (int i = 0; i < points; ++i) {
                    const glm::dvec3 p = dice.direction() * dice.real(0, size / 16);
                    const glm::dvec3 v = glm::normalize(eye - p);
                    const glm::dvec3 l = lamps[0].direction;
                    glm::dvec3 normal = dice.direction();
                    if (i % 2 == 0) {
                        normal = glm::normalize(glm::normalize(l + v) + dice.direction() * 0.2);
                    }
                    const Vec3<int32_t> raw =
                        bumped ? unit_.widened(to_raw(normal, profile_.displaced_normal))
                               : to_raw(normal, profile_.normal);
                    if (terminator(normal, lamps, std::ldexp(2.0, -of_n.frac))) continue;
                    ++compared;
                    const glm::dvec3 exact = phong(normal, v, real_light(r.ambient), n, lamps);
                    const glm::dvec3 got = real(unit_(to_raw(p, profile_.position), raw));
                    const double error = test::farthest(got, exact);
                    worst = std::max(worst, error);
                    squares += glm::dot(got - exact, got - exact) / 3;
                }
            }
            const double rms = std::sqrt(squares / compared);
            std::printf("%s, N in %s, n %3d: worst %.5f, rms %.6f (1/255 = 0.00392)\n", GetParam(),
                        bumped ? "displaced_normal" : "normal          ", n, worst, rms);
            if (is_default) {
                EXPECT_LE(worst, bumped ? 0.0025 + 2e-5 * n : 0.001 + 2e-5 * n);
                EXPECT_LE(rms, 0.0004);
            }
        }
    }
    EXPECT_EQ(unit_.counters().saturated, 0u);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
}

// The length of N is made up for to the first order: without that, the power would turn a length
// that is wrong by 2^-12 into an error of 2 n 2^-12 of the highlight, 6 % at n = 128.
TEST_P(ShadeUnit, TheLengthOfTheNormalDoesNotShowInTheHighlight) {
    const ShadeRegisters<Fixed> r = white_from_above(0, 0.9, 128);
    unit_.configure(r);
    const int32_t off = std::max(1, one() >> 11);
    const auto straight = unit_.illuminate({0, 0, one()}, {0, 0, one()});
    const auto longer = unit_.illuminate({0, 0, one() + off}, {0, 0, one()});
    const auto shorter = unit_.illuminate({0, 0, one() - off}, {0, 0, one()});
    EXPECT_EQ(straight, grey(real_light(r.lights[0].specular).x));
    EXPECT_NEAR(longer.red, straight.red, 2 + 0.001 / lsb_);
    EXPECT_NEAR(shorter.red, straight.red, 2 + 0.001 / lsb_);
}

TEST_P(ShadeUnit, LevelRefIsTheTextbook) {
    Dice dice(kSeed + 1);
    Shade<Real> unit(profile_);
    for (int s = 0; s < 2000; ++s) {
        ShadeRegisters<Real> r;
        std::vector<Lamp> lamps;
        const glm::dvec3 eye = dice.direction() * 20.0;
        const glm::dvec3 p = dice.direction();
        const glm::dvec3 n = dice.direction();
        r.eye = {eye.x, eye.y, eye.z};
        r.ambient = {0.1, 0.2, 0.3};
        r.shininess = 1 + s % 128;
        for (int i = 0; i < profile_.lights; ++i) {
            const glm::dvec3 d = dice.direction();
            auto& l = r.lights[static_cast<std::size_t>(i)];
            l = {{d.x, d.y, d.z}, {0.5, 0.25, 0.125}, {1, 0.5, 2}};
            lamps.push_back({d, {0.5, 0.25, 0.125}, {1, 0.5, 2}});
        }
        unit.configure(r);
        const Colour<double> c = unit({p.x, p.y, p.z}, {n.x, n.y, n.z});
        const glm::dvec3 exact =
            phong(n, glm::normalize(eye - p), {0.1, 0.2, 0.3}, r.shininess, lamps);
        ASSERT_LE(test::farthest({c.red, c.green, c.blue}, exact), 1e-11);
    }
}

TEST_P(ShadeUnit, HighlightIsFullWhereTheMirroredLightMeetsTheEye) {
    for (int n = 1; n <= 128; ++n) {
        unit_.configure(white_from_above(0.25, 0.5, n));
        EXPECT_EQ(unit_.illuminate({0, 0, one()}, {0, 0, one()}), grey(0.75)) << n;
        // Across the mirror's direction there is diffuse light alone.
        EXPECT_EQ(unit_.illuminate({0, 0, one()}, {one(), 0, 0}), grey(0.25)) << n;
    }
}

TEST_P(ShadeUnit, ALightBehindTheSurfaceGivesNothing) {
    ShadeRegisters<Fixed> r = white_from_above(0.5, 0.5, 1);
    r.ambient = light(glm::dvec3(0.25));
    unit_.configure(r);
    EXPECT_EQ(unit_.illuminate({0, 0, -one()}, {0, 0, one()}), grey(0.25));
    EXPECT_EQ(unit_.illuminate({one(), 0, 0}, {one(), 0, 0}), grey(0.25));  // it grazes
    r.two_sided = true;
    unit_.configure(r);
    EXPECT_EQ(unit_.illuminate({0, 0, -one()}, {0, 0, one()}),
              unit_.illuminate({0, 0, one()}, {0, 0, one()}));
    // Seen from below, the light above is still behind the surface.
    EXPECT_EQ(unit_.illuminate({0, 0, one()}, {0, 0, -one()}), grey(0.25));
}

TEST_P(ShadeUnit, BrightLightSaturatesAndIsCounted) {
    ShadeRegisters<Fixed> r = white_from_above(0, 0, 1);
    const auto most = static_cast<int32_t>(profile_.light.max_raw());
    for (auto& l : r.lights) l = {{0, 0, one()}, {most, most, 0}, {most, 0, 0}};
    r.ambient = {most, 0, 0};
    unit_.configure(r);
    const auto c = unit_.illuminate({0, 0, one()}, {0, 0, one()});
    const auto white = static_cast<int32_t>(profile_.colour.max_raw());
    EXPECT_EQ(c, (Colour<int32_t>{white, white, 0}));
    EXPECT_EQ(unit_.counters().saturated, 2u);
    EXPECT_EQ(unit_.counters().items, 1u);
}

TEST_P(ShadeUnit, LightsBeyondTheProfilesAreNotUsed) {
    Shade<Fixed> one_light(test::profile_with(GetParam(), {{"lights", "1"}}));
    ShadeRegisters<Fixed> r = white_from_above(0.25, 0, 1);
    r.lights[1] = r.lights[0];
    one_light.configure(r);
    unit_.configure(r);
    EXPECT_EQ(one_light.illuminate({0, 0, one()}, {0, 0, one()}), grey(0.25));
    EXPECT_EQ(unit_.illuminate({0, 0, one()}, {0, 0, one()}), grey(0.5));
}

TEST_P(ShadeUnit, VectorsWithoutDirectionLeaveTheAmbientLight) {
    ShadeRegisters<Fixed> r = white_from_above(0.25, 0.5, 10);
    r.ambient = light(glm::dvec3(0.125));
    r.eye = {7, -7, 7};
    unit_.configure(r);
    EXPECT_EQ(unit_({0, 0, 0}, {0, 0, 0}), grey(0.125));  // the mean of opposite normals
    EXPECT_EQ(unit_.counters().degenerate, 0u);
    EXPECT_EQ(unit_(r.eye, {0, 0, one()}), grey(0.375));  // at the eye: no highlight
    EXPECT_EQ(unit_.counters().degenerate, 1u);
}

// Near and far, all directions, both ends of `position`: within 1.2 LSB of the exact direction.
TEST_P(ShadeUnit, TheViewVectorIsAccurateAtEveryDistance) {
    Dice dice(kSeed + 2);
    const double lsb = std::ldexp(1.0, -profile_.normal.frac);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
        ShadeRegisters<Fixed> r;
        const int bits = static_cast<int>(dice.integer(2, profile_.position.width - 1));
        const int64_t reach = (int64_t{1} << bits) - 1;
        const auto any = [&] { return static_cast<int32_t>(dice.integer(-reach, reach)); };
        Vec3<int32_t> p = {any(), any(), any()};
        r.eye = {any(), any(), any()};
        if (i % 100 == 0) {
            const auto low = static_cast<int32_t>(profile_.position.min_raw());
            const auto high = static_cast<int32_t>(profile_.position.max_raw());
            p = {low, dice.flip() ? low : high, dice.flip() ? low : 0};
            r.eye = {high, dice.flip() ? low : high, 0};
        }
        const glm::dvec3 v(double(r.eye.x) - p.x, double(r.eye.y) - p.y, double(r.eye.z) - p.z);
        if (glm::length(v) == 0) continue;
        unit_.configure(r);
        const glm::dvec3 got = to_real(unit_.view_vector(p), profile_.normal);
        worst = std::max(worst, test::farthest(got, glm::normalize(v)) / lsb);
    }
    std::printf("%s: worst view vector %.3f LSB\n", GetParam(), worst);
    EXPECT_LE(worst, 1.2);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
}

// Raw vectors of any length, as a damaged normal map makes them: nothing leaves its range.
TEST_P(ShadeUnit, AnyInputGivesAColour) {
    Dice dice(kSeed + 3);
    for (int i = 0; i < 100'000; ++i) {
        ShadeRegisters<Fixed> r;
        const auto vector = [&] {
            return Vec3<int32_t>{dice.raw(profile_.normal), dice.raw(profile_.normal),
                                 dice.raw(profile_.normal)};
        };
        const auto colour = [&] {
            return Colour<int32_t>{dice.raw(profile_.light), dice.raw(profile_.light),
                                   dice.raw(profile_.light)};
        };
        r.ambient = colour();
        r.shininess = static_cast<int>(dice.integer(1, 255));
        r.two_sided = dice.flip();
        for (auto& l : r.lights) l = {vector(), colour(), colour()};
        unit_.configure(r);
        const auto c = unit_.illuminate(vector(), vector());
        for (const int32_t x : {c.red, c.green, c.blue}) {
            ASSERT_GE(x, 0);
            ASSERT_LE(x, profile_.colour.max_raw());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Profile, ShadeUnit, testing::Values("default", "narrow"));

}  // namespace
}  // namespace repousse
