// What the host hands to the device: texture coordinates, caps, registers and tables in the
// profile's formats, and what it refuses.

#include "testbench/host/draw.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/reference_input.h"

namespace repousse {
namespace {

using testing::HasSubstr;

const Profile kDefault = test::profile_with("default", {});
const Profile kNarrow = test::profile_with("narrow", {});

test::Object object() {
    test::Object object;
    object.mesh = host::make_grid(3, 3);
    object.map = host::make_donut_map(64, 48);
    object.settings.normal_threshold = 0.2;
    object.settings.height_threshold = 4096;
    return object;
}

TEST(Draw, TextureCoordinatesAreFlooredNotRounded) {
    const host::HeightMap map = host::make_constant_map(256, 100, 0);
    const auto edges = host::UvSpan::Edges;
    EXPECT_EQ(host::texel_uv({2. / 3, 1}, map, edges, 8), (Uv{43690, 25600}));  // 43690.67
    EXPECT_EQ(host::texel_uv({-1. / 3, -0.001}, map, edges, 4), (Uv{-1366, -2}));
    EXPECT_EQ(host::texel_uv({0, 1}, map, host::UvSpan::Centres, 8), (Uv{128, 99 * 256 + 128}));
    EXPECT_EQ(host::texel_uv({1, 0.5}, map, edges, 0), (Uv{256, 50}));
}

TEST(Draw, NaturalCapReachesOneTexel) {
    const auto cap = [](int quads, int texels, int frac) {
        const host::Mesh mesh = host::make_grid(quads, quads);
        const host::HeightMap map = host::make_constant_map(texels, 16, 0);
        host::DrawInputs in;
        in.mesh = &mesh;
        in.map = &map;
        return host::natural_cap(in, frac);
    };
    EXPECT_EQ(cap(3, 256, 16), 7);  // 85.33 texels
    EXPECT_EQ(cap(4, 256, 8), 6);   // 64 texels exactly
    EXPECT_EQ(cap(1, 4096, 4), 12);
    EXPECT_EQ(cap(16, 16, 8), 0);  // one texel an edge
    EXPECT_EQ(cap(32, 16, 8), 0);
    EXPECT_EQ(cap(1, 16384, 8), 14);
}

TEST(Draw, ScaleAndBiasStandForTheRange) {
    for (const Profile* profile : {&kDefault, &kNarrow}) {
        for (const double range : {1e-3, 0.09, 0.12, 1.0, 7.9}) {
            test::Object o = object();
            o.map.range_low = -0.25 * range;
            o.map.range_high = 0.75 * range;
            const auto draw = host::make_draw<Fixed>(*profile, o.inputs());
            ASSERT_TRUE(draw) << draw.error().message();
            const double scale = std::ldexp(draw->map.scale_mantissa, -draw->map.scale_exponent);
            const double exact = range / double(profile->height.max_raw());
            EXPECT_NEAR(scale, exact, std::ldexp(exact, -kScaleBits + 1));
            EXPECT_LT(draw->map.scale_mantissa, 1 << kScaleBits);
            EXPECT_EQ(draw->map.bias,
                      std::lround(std::ldexp(o.map.range_low, profile->displacement.frac)));
        }
    }
}

TEST(Draw, NarrowHeightsAreRoundedAndThresholdsFollow) {
    test::Object o = object();
    for (std::size_t i = 0; i < o.map.texels.size(); ++i) o.map.texels[i] = uint16_t(i * 29);
    const auto draw = host::make_draw<Fixed>(kNarrow, o.inputs());
    ASSERT_TRUE(draw);
    for (std::size_t i = 0; i < o.map.texels.size(); ++i) {
        ASSERT_EQ(draw->tables.heights[i], std::min((o.map.texels[i] + 8) / 16, 4095));
    }
    EXPECT_EQ(draw->registers.height_test.threshold, 4096u / 16);
    EXPECT_EQ(draw->registers.normal_threshold, std::lround(0.2 * 512));
    const auto wide = host::make_draw<Fixed>(kDefault, o.inputs());
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->tables.heights, o.map.texels);
    EXPECT_EQ(wide->registers.height_test.threshold, 4096u);
}

TEST(Draw, OnlyTheTablesThatAreCalledForAreMade) {
    test::Object o = object();
    auto draw = host::make_draw<Fixed>(kDefault, o.inputs());
    EXPECT_EQ(draw->tables.normals.size(), 64u * 48);
    EXPECT_EQ(draw->tables.sums.size(), 65u * 49);
    o.settings.normal_threshold.reset();
    o.settings.height_threshold.reset();
    draw = host::make_draw<Fixed>(kDefault, o.inputs());
    EXPECT_TRUE(draw->tables.normals.empty());
    EXPECT_TRUE(draw->tables.sums.empty());
    EXPECT_FALSE(draw->registers.use_bump);
    host::DrawInputs in = o.inputs();
    in.bump = true;
    draw = host::make_draw<Fixed>(kDefault, in);
    EXPECT_EQ(draw->tables.normals.size(), 64u * 48);
    EXPECT_TRUE(draw->registers.use_bump);
}

// Two is the largest threshold that a scene may ask for, and no value of N' itself.
TEST(Draw, TheLargestThresholdsFit) {
    test::Object o = object();
    o.settings.normal_threshold = 2.0;
    o.settings.view_threshold_px = 4096;
    o.settings.height_threshold = 65535;
    for (const Profile* profile : {&kDefault, &kNarrow}) {
        const auto draw = host::make_draw<Fixed>(*profile, o.inputs());
        ASSERT_TRUE(draw) << draw.error().message();
        EXPECT_EQ(draw->registers.normal_threshold, 2 << profile->displaced_normal.frac);
        EXPECT_EQ(draw->registers.view_threshold, int64_t(4096) << profile->screen.frac);
    }
}

TEST(Draw, WhatTheProfileCannotHoldIsRefusedWithAdvice) {
    const auto refused = [](const Profile& profile, const test::Object& o,
                            const host::ViewFrame& view = {}) {
        host::DrawInputs in = o.inputs();
        in.view = view;
        const auto draw = host::make_draw<Fixed>(profile, in);
        if (draw) return std::string("accepted");
        EXPECT_EQ(draw.error().kind, ErrorKind::Input);
        return draw.error().message();
    };
    test::Object o = object();
    EXPECT_EQ(refused(kDefault, o), "accepted");
    o.mesh.positions[5].y = 40000;
    EXPECT_THAT(refused(kDefault, o), HasSubstr("position 40000"));
    EXPECT_THAT(refused(kDefault, o), HasSubstr("wider profile"));
    o = object();
    o.mesh.uv[3].x = 300;  // 19200 texels
    EXPECT_THAT(refused(kDefault, o), HasSubstr("texture coordinate"));
    o = object();
    o.map.range_high = 3000;
    EXPECT_THAT(refused(kDefault, o), HasSubstr("displacement"));
    o = object();
    o.settings.view_threshold_px = 4;
    host::ViewFrame view;
    view.eye = {1e5, 0, 0};
    EXPECT_THAT(refused(kDefault, o, view), HasSubstr("camera position"));
    // A periodic map: an edge must not span more than a box may, nor leave half a period.
    o = object();
    o.map.wrap = true;
    o.mesh.uv[0].x = -0.75;
    EXPECT_THAT(refused(kDefault, o), HasSubstr("half a period"));
}

TEST(Draw, LevelRefKeepsDoublesAndFullHeights) {
    const test::Object o = object();
    const Profile profile = host::reference_profile(kNarrow);
    const auto draw = host::make_draw<Real>(profile, o.inputs());
    ASSERT_TRUE(draw) << draw.error().message();
    EXPECT_EQ(draw->tables.heights, o.map.texels);
    EXPECT_EQ(draw->map.scale_mantissa, 0.12 / 65535);
    EXPECT_EQ(draw->vertices[5].position.x, o.mesh.positions[5].x);
    EXPECT_EQ(draw->vertices[5].uv, host::texel_uv(o.mesh.uv[5], o.map, o.uv, kNarrow.uv.frac));
    EXPECT_EQ(draw->registers.normal_threshold, 0.2);
    EXPECT_EQ(draw->registers.height_test.threshold, 4096u);
}

TEST(Draw, ViewFrameIsOrthonormalAndLooksAtTheTarget) {
    host::CameraSettings camera;
    camera.eye = {1, 2, 3};
    camera.target = {0, 0.5, 0};
    camera.fov_deg = 90;
    const host::ViewFrame frame = host::view_frame(camera, {640, 480});
    EXPECT_NEAR(glm::dot(frame.right, frame.up), 0, 1e-15);
    EXPECT_NEAR(glm::dot(frame.right, frame.forward), 0, 1e-15);
    EXPECT_NEAR(glm::length(frame.up), 1, 1e-15);
    EXPECT_GT(frame.up.z, 0);
    EXPECT_NEAR(glm::dot(frame.forward, glm::normalize(camera.target - camera.eye)), 1, 1e-15);
    EXPECT_NEAR(frame.focal.x, 240, 1e-9);  // half the height, at 90 degrees
    EXPECT_NEAR(frame.focal.y, -240, 1e-9);
    EXPECT_EQ(frame.centre, glm::dvec2(320, 240));
}

}  // namespace
}  // namespace repousse
