// What the host writes into the registers of `shade`: the scene's lights times a material.

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "testbench/host/shade_registers.h"
#include "testbench/host/view/picture.h"
#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

using host::make_shade_registers;

host::DrawInputs inputs_with(std::vector<host::Light> lights) {
    host::DrawInputs inputs;
    inputs.lights = std::move(lights);
    inputs.shade = host::Material{};
    inputs.shade->mark = {"s.toml", 20, 1};
    inputs.view.eye = {1.5, -2.25, 0.125};
    return inputs;
}

double real(int32_t raw, const Format& format) { return std::ldexp(double(raw), -format.frac); }

TEST(ShadeRegistersOfAScene, AreLightsTimesTheMaterialInLinearLight) {
    const Profile profile = test::profile_with("default", {});
    const glm::dvec3 towards = glm::normalize(glm::dvec3(-1, 2, 3));
    host::DrawInputs inputs = inputs_with({{towards, {1.5, 0.5, 0}}, {{0, 0, 1}, {1, 1, 1}}});
    inputs.shade->diffuse = {0.5, 0.25, 1};
    inputs.shade->specular = {0, 1, 0.75};
    inputs.shade->ambient = {0.1, 0, 1};
    inputs.shade->shininess = 255;
    inputs.shade->two_sided = true;
    const auto registers = make_shade_registers<Fixed>(profile, inputs);
    ASSERT_TRUE(registers.ok()) << registers.error().message();
    const auto linear = [](double srgb) { return host::srgb_to_linear(srgb); };
    const double half = std::ldexp(0.5, -profile.light.frac);
    const auto light = [&](int32_t raw) { return real(raw, profile.light); };
    const Light<Fixed>& first = registers->lights[0];
    EXPECT_NEAR(light(first.diffuse.red), 1.5 * linear(0.5), half);  // above 1: linear already
    EXPECT_NEAR(light(first.diffuse.green), linear(0.5) * linear(0.25), half);
    EXPECT_EQ(first.diffuse.blue, 0);
    EXPECT_EQ(first.specular.red, 0);
    EXPECT_NEAR(light(first.specular.green), linear(0.5), half);
    EXPECT_NEAR(real(first.direction.x, profile.normal), towards.x, std::ldexp(0.5, -14));
    EXPECT_EQ(registers->lights[1].diffuse.blue, 1 << profile.light.frac);
    EXPECT_EQ(registers->lights[1].direction, (Vec3<int32_t>{0, 0, 1 << profile.normal.frac}));
    EXPECT_TRUE(registers->lights[2].diffuse == Colour<int32_t>{});
    EXPECT_NEAR(light(registers->ambient.red), linear(0.1), half);
    EXPECT_EQ(registers->ambient.green, 0);
    EXPECT_EQ(registers->shininess, 255);
    EXPECT_TRUE(registers->two_sided);
    EXPECT_EQ(real(registers->eye.y, profile.position), -2.25);

    const auto ref = make_shade_registers<Real>(profile, inputs);
    ASSERT_TRUE(ref.ok());
    EXPECT_EQ(ref->lights[0].diffuse.red, 1.5 * linear(0.5));
    EXPECT_EQ(ref->lights[0].direction.z, towards.z);
    EXPECT_EQ(ref->eye.z, 0.125);
}

TEST(ShadeRegistersOfAScene, MoreLightsThanTheProfileHasAreRefused) {
    const host::Light light;
    const Profile one = test::profile_with("default", {{"lights", "1"}});
    EXPECT_TRUE(make_shade_registers<Fixed>(one, inputs_with({light})).ok());
    const auto refused = make_shade_registers<Fixed>(one, inputs_with({light, light, light}));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(
        refused.error().message().rfind(
            "s.toml:20:1: the scene has 3 lights, and the unit `shade` of the profile has 1", 0),
        0u)
        << refused.error().message();
    EXPECT_FALSE(make_shade_registers<Real>(one, inputs_with({light, light})).ok());
    const host::DrawInputs eight = inputs_with(std::vector<host::Light>(8, light));
    EXPECT_TRUE(make_shade_registers<Fixed>(test::profile_with("default", {}), eight).ok());
}

TEST(ShadeRegistersOfAScene, WhatTheFormatsCannotHoldIsRefused) {
    const Profile profile = test::profile_with("default", {});
    host::DrawInputs inputs = inputs_with({{{0, 0, 1}, {1, 1, 1}}, {{0, 0, 1}, {1, 16, 1}}});
    inputs.shade->diffuse = {1, 1, 1};
    const auto bright = make_shade_registers<Fixed>(profile, inputs);
    ASSERT_FALSE(bright.ok());
    EXPECT_EQ(bright.error().message().rfind(
                  "s.toml:20:1: light 2 times the diffuse colour 16.000000 does not fit u2.10", 0),
              0u)
        << bright.error().message();
    inputs = inputs_with({});
    inputs.view.eye = {1e6, 0, 0};
    EXPECT_FALSE(make_shade_registers<Fixed>(profile, inputs).ok());
}

TEST(ShadeRegistersOfAScene, NoLightLeavesTheAmbientColour) {
    const auto registers =
        make_shade_registers<Fixed>(test::profile_with("default", {}), inputs_with({}));
    ASSERT_TRUE(registers.ok());
    EXPECT_GT(registers->ambient.red, 0);
    for (const Light<Fixed>& light : registers->lights) {
        EXPECT_TRUE(light.diffuse == Colour<int32_t>{} && light.specular == Colour<int32_t>{});
    }
}

TEST(ShadeRegistersOfAScene, ColoursComeBackAsLinearLight) {
    const Profile profile = test::profile_with("default", {});
    const auto most = static_cast<int32_t>(profile.colour.max_raw());
    EXPECT_EQ(host::linear_light<Fixed>({0, 512, most}, profile),
              glm::dvec3(0, 0.5, real(most, profile.colour)));
    EXPECT_EQ(host::linear_light<Real>({0.25, 1.5, 0}, profile), glm::dvec3(0.25, 1, 0));
    EXPECT_EQ(host::to_srgb8(1.0), 255);
    EXPECT_EQ(host::to_srgb8(-1.0), 0);
    EXPECT_EQ(host::to_srgb8(0.5), 188);
}

}  // namespace
}  // namespace repousse
