// shade: highlights, lights behind the surface, saturation, vectors without direction.

#include <gtest/gtest.h>

#include "testbench/tests/support/shade_bench.h"

namespace repousse {
namespace {

using test::Dice;

constexpr uint64_t kSeed = 67;

class ShadeUnit : public test::ShadeUnit {};

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
