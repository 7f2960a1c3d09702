// The unit `shade` in the device: colours of both methods are the bare loop's, byte for byte, in
// the hard cases too. Each case elaborates in a child process.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "testbench/host/shade_registers.h"
#include "testbench/tests/support/platform_draws.h"
#include "testbench/tests/support/platform_run.h"
#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

using Draws = std::vector<shell::Draw>;
using Rgb = Colour<int32_t>;

void expect_equal(const DeviceConfig& config, const Draws& draws,
                  const shell::PlatformOptions& options = {}) {
    EXPECT_EXIT(std::exit(test::compare(config, draws, options)), testing::ExitedWithCode(0), "");
}

/// Two lights over the ring, and a highlight.
ShadeRegisters<Fixed> two_lights(const Profile& profile, const Vec3<int32_t>& eye) {
    host::DrawInputs inputs;
    inputs.lights = {{glm::normalize(glm::dvec3(-1, -1, 2)), {0.9, 0.8, 0.7}},
                     {glm::normalize(glm::dvec3(1, 0, 0.5)), {0.2, 0.3, 0.6}}};
    inputs.shade = host::Material{};
    ShadeRegisters<Fixed> registers = *host::make_shade_registers<Fixed>(profile, inputs);
    registers.eye = eye;
    return registers;
}

template <class Draw>
Draw shaded(Draw draw, const Profile& profile) {
    draw.registers.use_shade = true;
    draw.registers.shade = two_lights(profile, draw.camera.eye);
    return draw;
}

AdaptiveDraw<Fixed> with_bump(AdaptiveDraw<Fixed> draw, const Profile& profile) {
    const SweepDraw<Fixed> other = test::sweep_draw(profile, true);
    draw.registers.use_bump = true;
    draw.tables.normals = other.tables.normals;
    return draw;
}

/// A ring by either method, shaded, with N' or with N.
Draws every_kind(const Profile& profile) {
    return {shaded(test::adaptive_draw(profile), profile),
            shaded(with_bump(test::adaptive_draw(profile), profile), profile),
            shaded(test::sweep_draw(profile, false, 2), profile),
            shaded(test::sweep_draw(profile, true, 2), profile)};
}

/// Changes the registers of each draw, runs it on the device and the bare loop, and hands over the
/// colours.
template <class Change, class Judge>
void each_colour(const Change& change, const Judge& judge) {
    const Profile profile = test::profile_with("default", {});
    Draws draws = every_kind(profile);
    for (shell::Draw& draw : draws) {
        std::visit([&](auto& d) { change(d); }, draw);
    }
    expect_equal(test::config_for(profile, draws), draws);
    const test::Expected expected = test::bare_loops(profile, draws);
    for (const shell::DrawOutput& output : expected.outputs) {
        if (const auto* triangles = std::get_if<std::vector<OutputTriangle<Fixed>>>(&output)) {
            EXPECT_GT(triangles->size(), 100u);
            for (const auto& triangle : *triangles) {
                for (const auto& v : triangle.corners) judge(v.colour);
            }
        } else {
            const auto& mesh = std::get<SweepMesh<Fixed>>(output);
            EXPECT_GT(mesh.vertices.size(), 100u);
            for (const auto& v : mesh.vertices) judge(v.colour);
        }
    }
}

const auto kNoChange = [](auto&) {};

TEST(ShadedPlatform, BothMethodsGiveTheBareLoopsBytes) {
    for (const char* name : {"default", "narrow"}) {
        const Profile profile = test::profile_with(name, {});
        const Draws draws = {shaded(test::adaptive_draw(profile), profile),
                             shaded(test::sweep_draw(profile, false, 2), profile)};
        expect_equal(test::config_for(profile, draws), draws);
    }
    int bright = 0, dark = 0;
    each_colour(kNoChange, [&](const Rgb& c) { ++(c.red > 400 ? bright : dark); });
    EXPECT_GT(bright, 100);
    EXPECT_GT(dark, 100);
}

TEST(ShadedPlatform, FramesWithAndWithoutColoursFollowEachOther) {
    const Profile profile = test::profile_with("default", {});
    Draws draws = every_kind(profile);
    draws.insert(draws.begin() + 1, test::adaptive_draw(profile));
    draws.insert(draws.begin() + 4, test::sweep_draw(profile, true, 2));
    DeviceConfig config = test::config_for(profile, draws);
    expect_equal(config, draws);
    config.include_everything();
    shell::PlatformOptions options;
    options.output_capacity = 7;
    options.allow_dmi = false;
    expect_equal(config, draws, options);
}

TEST(ShadedPlatform, WithCordic) {
    const Profile profile = test::profile_with("default", {{"normalise_kind", "1"}});
    const Draws draws = {shaded(test::adaptive_draw(profile), profile)};
    expect_equal(test::config_for(profile, draws), draws);
}

TEST(ShadedPlatform, TrianglesThatAreNotDisplacedHaveNoColour) {
    const Profile profile = test::profile_with("default", {});
    const Draws draws = {
        test::with_direct_ones(shaded(test::sweep_draw(profile, true, 4), profile), 50)};
    expect_equal(test::config_for(profile, draws), draws);
}

TEST(ShadedPlatform, MissingUnitAndBadExponentAreReported) {
    const Profile profile = test::profile_with("default", {});
    for (const shell::Draw& draw : every_kind(profile)) {
        DeviceConfig config = test::config_for(profile, {draw});
        config.shade = false;
        EXPECT_EXIT(std::exit(test::compare(config, {draw})), testing::ExitedWithCode(2),
                    "needs a unit that was not built");
        for (const int shininess : {0, 256, -1}) {
            Draws bad = {draw};
            std::visit([&](auto& d) { d.registers.shade.shininess = shininess; }, bad[0]);
            EXPECT_EXIT(std::exit(test::compare(test::config_for(profile, bad), bad)),
                        testing::ExitedWithCode(2), "a register is out of its range");
        }
    }
}

// The hard cases.

TEST(ShadedPlatform, NoLights) {
    each_colour(
        [](auto& draw) { draw.registers.shade.lights = {}; },
        [](const Rgb& c) { EXPECT_TRUE(c.red > 0 && c.red == c.green && c.red == c.blue); });
}

TEST(ShadedPlatform, ZeroNormals) {
    // They displace nothing and reflect nothing: the ambient light is left.
    each_colour(
        [](auto& draw) {
            for (auto& v : draw.vertices) v.normal = v.tangent = {};
        },
        [](const Rgb& c) { EXPECT_TRUE(c.red > 0 && c.red == c.green && c.red == c.blue); });
}

TEST(ShadedPlatform, LightFromBehind) {
    const auto from_below = [](auto& draw) {
        for (auto& light : draw.registers.shade.lights) light.direction = {0, 0, -(1 << 14)};
    };
    each_colour(from_below, [](const Rgb& c) { EXPECT_TRUE(c.red == c.green && c.red == c.blue); });
    // Two-sided, what looks away from the viewer is turned and lit.
    int lit = 0, dark = 0;
    each_colour(
        [&](auto& draw) {
            from_below(draw);
            draw.registers.shade.two_sided = true;
        },
        [&](const Rgb& c) { ++(c.red == c.blue ? dark : lit); });
    EXPECT_GT(lit, 0);
    EXPECT_GT(dark, lit);
}

TEST(ShadedPlatform, ExponentOneAndTheLargest) {
    // The same highlights, broad and narrow: the narrow ones leave more in the dark.
    int64_t sums[2] = {};
    for (const int n : {1, 255}) {
        each_colour(
            [n](auto& draw) {
                draw.registers.shade.shininess = n;
                for (auto& light : draw.registers.shade.lights) light.diffuse = {};
            },
            [&](const Rgb& c) { sums[n == 255] += c.red; });
    }
    EXPECT_GT(sums[0], sums[1]);
}

TEST(ShadedPlatform, SaturatedSum) {
    const Profile profile = test::profile_with("default", {});
    const auto most = static_cast<int32_t>(profile.light.max_raw());
    const auto white = static_cast<int32_t>(profile.colour.max_raw());
    each_colour(
        [&](auto& draw) {
            draw.registers.shade.ambient = {most, most, 0};
            for (auto& light : draw.registers.shade.lights) {
                light = {{0, 0, 1 << profile.normal.frac}, {most, 0, 0}, {most, 0, 0}};
            }
        },
        [&](const Rgb& c) {
            EXPECT_EQ(c, (Rgb{white, white, 0}));
        });
    Draws draws = every_kind(profile);
    std::get<AdaptiveDraw<Fixed>>(draws[0]).registers.shade.ambient = {most, 0, 0};
    const auto rows = test::bare_loops(profile, {draws[0]}).counters;
    EXPECT_EQ(test::value_of(rows, {"shade", "saturated", 0}),
              test::value_of(rows, {"shade", "items", 0}));
}

TEST(ShadedPlatform, TheEyeInAVertex) {
    const Profile profile = test::profile_with("default", {});
    for (shell::Draw& draw : every_kind(profile)) {
        // The corner of the grid, where the ring is flat.
        std::visit(
            [](auto& d) {
                d.camera.eye = d.vertices[0].position;
                d.registers.shade.eye = d.camera.eye;
            },
            draw);
        if (std::holds_alternative<AdaptiveDraw<Fixed>>(draw)) {
            const auto rows = test::bare_loops(profile, {draw}).counters;
            EXPECT_GE(test::value_of(rows, {"shade", "degenerate", 0}), 1u);
        }
        expect_equal(test::config_for(profile, {draw}), {draw});
    }
}

}  // namespace
}  // namespace repousse
