// shade: what the unit rounds, against Phong's illumination in doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "testbench/tests/support/shade_bench.h"

namespace repousse {
namespace {

using test::Dice;
using test::Lamp;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 67;

class ShadeError : public test::ShadeUnit {};

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

// Everything that the unit rounds, against doubles that round nothing: P', N, L and V included.
// A vertex near the place of the highlight in half of the cases. Bounds in the sheet.
TEST_P(ShadeError, ErrorAgainstDoublesForEveryExponent) {
    Dice dice(kSeed);
    const bool is_default = std::string(GetParam()) == "default";
    for (const bool bumped : {false, true}) {
        for (const int n : {1, 2, 5, 10, 20, 32, 64, 128}) {
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
TEST_P(ShadeError, TheLengthOfTheNormalDoesNotShowInTheHighlight) {
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

TEST_P(ShadeError, LevelRefIsTheTextbook) {
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

// Near and far, all directions, both ends of `position`: within 1.2 LSB of the exact direction.
TEST_P(ShadeError, TheViewVectorIsAccurateAtEveryDistance) {
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

INSTANTIATE_TEST_SUITE_P(Profile, ShadeError, testing::Values("default", "narrow"));

}  // namespace
}  // namespace repousse
