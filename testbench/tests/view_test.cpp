// Camera and the drawn picture. What covers which sample: fill_rule_test;
// what a sample sees of a triangle: attributes_test.
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/view/camera.h"
#include "testbench/host/view/render.h"
#include "testbench/tests/support/from_above.h"

namespace repousse::host {
namespace {

using test::from_above;

TEST(Camera, ProjectsKnownPoints) {
    const ViewProjection view = view_projection(from_above(), {200, 100});
    const ScreenPoint middle = view.project({0.5, 0.5, 0.0});
    EXPECT_NEAR(middle.x, 100.0, 1e-12);
    EXPECT_NEAR(middle.y, 50.0, 1e-12);
    EXPECT_NEAR(middle.w, 1.0, 1e-12);
    // Half a unit up at distance one and tan(fov / 2) = 1/2 is the top of the picture.
    EXPECT_NEAR(view.project({0.5, 1.0, 0.0}).y, 0.0, 1e-9);
    EXPECT_NEAR(view.project({1.5, 0.5, 0.0}).x, 200.0, 1e-9);  // twice as wide as high
    EXPECT_NEAR(view.project({1.0, 1.0, 0.5}).x, 200.0, 1e-9);  // and twice as large half as far
    EXPECT_LT(view.project({0.5, 0.5, 2.0}).w, 0.0);            // behind the eye
}

TEST(Camera, IsTheReferenceCameraOfTheViewTestRow) {
    // R8 of adaptive-tessellation.md: screen = 256 + 384 * (right, up) / depth, 512 pixels.
    CameraSettings camera;
    camera.eye = {0.5, -0.6, 0.5};
    camera.target = {0.5, 0.5, 0.0};
    camera.fov_deg = 2.0 * std::atan(256.0 / 384.0) * 180.0 / 3.14159265358979323846;
    const ViewProjection view = view_projection(camera, {512, 512});
    const glm::dvec3 p(0.2, 0.7, 0.1);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, {0.0, 0.0, 1.0}));
    const glm::dvec3 up = glm::cross(right, forward);
    const double depth = glm::dot(p - camera.eye, forward);
    const ScreenPoint s = view.project(p);
    EXPECT_NEAR(s.x, 256 + 384 * glm::dot(p - camera.eye, right) / depth, 1e-9);
    EXPECT_NEAR(s.y, 256 - 384 * glm::dot(p - camera.eye, up) / depth, 1e-9);
    EXPECT_NEAR(s.w, depth, 1e-12);
}

RenderMesh sheet(double z) {
    const Mesh mesh = make_grid(2, 2);
    RenderMesh surface;
    surface.positions = mesh.positions;
    surface.triangles = mesh.triangles;
    for (glm::dvec3& p : surface.positions) p.z = z;
    return surface;
}

ViewSettings plain_view() {
    ViewSettings view;
    view.samples = 2;
    view.background = view.horizon = {0.0, 0.0, 0.0};
    return view;
}

TEST(Render, TheNearerSurfaceHidesTheOtherInAnyOrder) {
    RenderMesh low = sheet(0.0);
    RenderMesh high = sheet(0.4);
    low.heights.assign(low.positions.size(), 0.0);
    high.heights.assign(high.positions.size(), 1.0);
    ViewSettings view = plain_view();
    view.tint = Tint::Relief;
    const std::vector<Light> lights{{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}}};
    const Picture a = render({low, high}, from_above(), {32, 32}, view, lights);
    const Picture b = render({high, low}, from_above(), {32, 32}, view, lights);
    EXPECT_EQ(a.rgb, b.rgb);
    const Picture alone = render({low}, from_above(), {32, 32}, view, lights);
    EXPECT_GT(a.pixel(16, 16)[2], alone.pixel(16, 16)[2] + 0.2f);  // snow over meadow
}

TEST(Render, LightComesFromWhereItSays) {
    ViewSettings view = plain_view();
    const std::vector<Light> above{{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}}};
    const std::vector<Light> grazing{{glm::normalize(glm::dvec3(1.0, 0.0, 0.1)), {1.0, 1.0, 1.0}}};
    const Picture bright = render({sheet(0.0)}, from_above(), {16, 16}, view, above);
    const Picture dim = render({sheet(0.0)}, from_above(), {16, 16}, view, grazing);
    EXPECT_GT(bright.pixel(8, 8)[0], 2.0f * dim.pixel(8, 8)[0]);
    EXPECT_GT(dim.pixel(8, 8)[0], 0.0f);
}

TEST(Render, AShadowFallsWhereTheLightIsBlocked) {
    RenderMesh lid = sheet(0.2);
    for (glm::dvec3& p : lid.positions) p = {0.4 + 0.1 * p.x, 0.4 + 0.2 * p.y, p.z};
    ViewSettings view = plain_view();
    view.shadows = true;
    const std::vector<Light> lights{{glm::normalize(glm::dvec3(-1.0, 0.0, 1.0)), {1.0, 1.0, 1.0}}};
    const Picture with = render({sheet(0.0), lid}, from_above(), {64, 64}, view, lights);
    view.shadows = false;
    const Picture without = render({sheet(0.0), lid}, from_above(), {64, 64}, view, lights);
    // The light comes from -x and the lid is 0.2 up: its shadow starts at x = 0.6.
    EXPECT_LT(with.pixel(41, 32)[0], 0.5f * without.pixel(41, 32)[0]);
    EXPECT_NEAR(with.pixel(10, 10)[0], without.pixel(10, 10)[0], 1e-6);
}

TEST(Render, WireframeDarkensEdgesOnlyAndTheSamePictureComesTwice) {
    ViewSettings view = plain_view();
    view.wireframe = true;
    const std::vector<Light> lights{{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}}};
    const Picture a = render({sheet(0.0)}, from_above(), {64, 64}, view, lights);
    EXPECT_EQ(a.rgb, render({sheet(0.0)}, from_above(), {64, 64}, view, lights).rgb);
    view.wireframe = false;
    const Picture bare = render({sheet(0.0)}, from_above(), {64, 64}, view, lights);
    EXPECT_LT(a.pixel(32, 10)[0], 0.6f * bare.pixel(32, 10)[0]);  // the middle edge
    EXPECT_EQ(a.pixel(20, 8)[0], bare.pixel(20, 8)[0]);           // inside a triangle
}

/// Lines of a receding strip of quads, some of it behind the eye, some near, some far.
TEST(Render, WireframeShowsEdgesOfNearAndFarTrianglesAndNoHiddenOnes) {
    const Mesh grid = make_grid(4, 8, {4.0, 40.0});
    RenderMesh plain;
    plain.positions = grid.positions;
    plain.triangles = grid.triangles;
    for (glm::dvec3& p : plain.positions) p -= glm::dvec3(2.0, 2.5, 0.0);
    CameraSettings camera;
    camera.eye = {0.13, 0.0, 1.5};
    camera.target = {0.13, 4.0, 0.0};
    const Viewport viewport{320, 240};
    const ViewProjection projection = view_projection(camera, viewport);
    ViewSettings view = plain_view();
    const std::vector<Light> lights{{{0.0, 0.0, 1.0}, {1.0, 1.0, 1.0}}};
    const Picture bare = render({plain}, camera, viewport, view, lights);
    view.wireframe = true;
    const Picture wired = render({plain}, camera, viewport, view, lights);
    const auto ratio = [&](const glm::dvec3& p) {
        const ScreenPoint s = projection.project(p);
        const int x = static_cast<int>(s.x), y = static_cast<int>(s.y);
        const bool is_seen = s.w > camera.near && s.x > 2 && s.x < 318 && s.y > 2 && s.y < 238;
        // The border of the strip may be background, which is black.
        return is_seen && bare.pixel(x, y)[1] > 0.0f ? wired.pixel(x, y)[1] / bare.pixel(x, y)[1]
                                                     : -1.0f;
    };
    int edges = 0, behind = 0, insides = 0;
    for (const auto& t : plain.triangles) {
        const glm::dvec3 &a = plain.positions[t[0]], &b = plain.positions[t[1]];
        const glm::dvec3& c = plain.positions[t[2]];
        bool crosses = false;
        for (const glm::dvec3& p : {a, b, c}) crosses = crosses || projection.project(p).w <= 0.0;
        const double far = projection.project((a + b + c) / 3.0).w;
        for (double along = 0.05; along < 1.0; along += 0.1) {
            for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
                const float dark = ratio(glm::mix(p, q, along));
                if (dark < 0.0f || far > 8.0) continue;
                EXPECT_LT(dark, 0.75f) << glm::mix(p, q, along).y;
                ++edges;
                behind += crosses;
            }
        }
        const float inside = ratio((a + b + c) / 3.0);
        if (inside < 0.0f || far > 6.0) continue;
        EXPECT_EQ(inside, 1.0f);
        ++insides;
    }
    EXPECT_GT(edges, 200);
    EXPECT_GT(behind, 10) << "no triangle reached behind the eye";
    EXPECT_GT(insides, 3);
    // Far away the lines come together; the surface darkens there, but is not blotted out.
    const ScreenPoint far = projection.project({0.1, 36.9, 0.0});
    const int x = static_cast<int>(far.x), y = static_cast<int>(far.y);
    EXPECT_GT(wired.pixel(x, y)[1], 0.3f * bare.pixel(x, y)[1]);
    // A lid of one quad hides the lines below it.
    RenderMesh lid = sheet(0.0);
    for (glm::dvec3& p : lid.positions) p = {10.0 * p.x - 5.0, 60.0 * p.y - 5.0, 0.2};
    RenderMesh none = plain;
    none.triangles.clear();
    EXPECT_EQ(render({plain, lid}, camera, viewport, view, lights).rgb,
              render({none, lid}, camera, viewport, view, lights).rgb);
}

TEST(Render, ACameraInsideTheMeshIsNoError) {
    const Mesh ball = make_icosphere(2, 1.0);
    RenderMesh surface;
    surface.positions = ball.positions;
    surface.triangles = ball.triangles;
    CameraSettings camera;
    camera.eye = {0.0, 0.1, 0.0};
    camera.target = {1.0, 0.0, 0.0};
    const Picture picture = render({surface}, camera, {40, 30}, plain_view(), {});
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) ASSERT_GT(picture.rgb[i], -1e-6f);
}

TEST(Skirt, ClosesAnOpenSheetAndNothingElse) {
    const RenderMesh skirt = make_skirt(sheet(0.0), -0.5);
    EXPECT_EQ(skirt.triangles.size(), 16u);  // 8 border edges
    const Mesh ball = make_icosphere(1, 1.0);
    RenderMesh closed;
    closed.positions = ball.positions;
    closed.triangles = ball.triangles;
    EXPECT_TRUE(make_skirt(closed, -2.0).triangles.empty());
}

TEST(Picture, SrgbRoundTrip) {
    for (int i = 0; i <= 255; ++i) {
        Picture picture;
        picture.width = picture.height = 1;
        picture.rgb.assign(3, static_cast<float>(srgb_to_linear(i / 255.0)));
        EXPECT_EQ(to_srgb8(picture)[0], i);
    }
}

}  // namespace
}  // namespace repousse::host
