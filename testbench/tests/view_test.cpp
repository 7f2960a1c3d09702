// Camera, fill rule, clipping and the drawn picture.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/view/camera.h"
#include "testbench/host/view/clip.h"
#include "testbench/host/view/render.h"

namespace repousse::host {
namespace {

CameraSettings from_above() {
    CameraSettings camera;
    camera.eye = {0.5, 0.5, 1.0};
    camera.target = {0.5, 0.5, 0.0};
    camera.up = {0.0, 1.0, 0.0};
    camera.fov_deg = 2.0 * std::atan(0.5) * 180.0 / 3.14159265358979323846;
    return camera;
}

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

/// Every pixel's centre under a watertight sheet is covered once, whatever its triangles.
void expect_once(const Mesh& mesh, const CameraSettings& camera, const Viewport& viewport) {
    const auto counts = coverage(mesh.positions, mesh.triangles, view_projection(camera, viewport),
                                 viewport.width_px, viewport.height_px);
    int wrong = 0;
    for (const std::uint32_t count : counts) wrong += count != 1;
    EXPECT_EQ(wrong, 0);
}

TEST(FillRule, AWatertightSheetCoversEachCentreOnce) {
    // Vertices on pixel centres and corners: every centre is on some edge.
    for (const int quads : {1, 2, 3, 8, 16, 50, 64}) {
        Mesh mesh = make_grid(quads, quads);
        CameraSettings camera = from_above();
        camera.fov_deg *= 0.9999999;
        expect_once(mesh, camera, {64, 64});
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);  // from behind
        expect_once(mesh, camera, {64, 64});
    }
    // Irregular sheets, larger than the picture. A shift of 0.2 of a quad cannot fold a triangle
    // (h^2 - 4 j h - 4 j^2 > 0), but makes slivers.
    std::mt19937 random(11);
    for (int round = 0; round < 20; ++round) {
        Mesh mesh = make_grid(60, 60, {1.8, 1.8});
        for (glm::dvec3& p : mesh.positions) {
            p -= glm::dvec3(0.4, 0.4, 0.0);
            p.x += 0.006 * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
            p.y += 0.006 * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
        }
        expect_once(mesh, from_above(), {97, 61});
    }
}

TEST(FillRule, TopAndLeftEdgesAreInBottomAndRightOnesOut) {
    // A square from the centre of pixel (0, 0) to that of (2, 2), as two triangles each way round.
    const SnappedVertex a{128, 128}, b{640, 128}, c{640, 640}, d{128, 640};
    int seen[4][4] = {};
    auto visit = [&](int x, int y, const Weights& w) {
        ++seen[y][x];
        EXPECT_NEAR(w.a + w.b + w.c, 1.0, 1e-12);
    };
    rasterise(a, b, c, {0, 0, 4, 4}, visit);
    rasterise(d, c, a, {0, 0, 4, 4}, visit);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(seen[y][x], x < 2 && y < 2 ? 1 : 0);
    }
}

TEST(FillRule, TheTestCanFail) {
    Mesh mesh = make_grid(8, 8);
    mesh.triangles.pop_back();
    CameraSettings camera = from_above();
    camera.fov_deg *= 0.9999999;
    const auto counts =
        coverage(mesh.positions, mesh.triangles, view_projection(camera, {64, 64}), 64, 64);
    EXPECT_GT(std::count(counts.begin(), counts.end(), 0u), 10);
}

TEST(Clipping, AnEndlessPlaneThroughTheEyePlaneHasNoHoles) {
    // The plane passes below the eye and behind it; all pixels below the horizon see it once.
    Mesh mesh = make_grid(30, 30, {4000.0, 4000.0});
    for (glm::dvec3& p : mesh.positions) p -= glm::dvec3(2000.0, 2000.0, 0.0);
    CameraSettings camera;
    camera.eye = {1.0, -3.0, 2.0};
    camera.target = {2.0, 30.0, 2.0};
    camera.far = 1e6;
    camera.near = 0.1;
    const auto counts =
        coverage(mesh.positions, mesh.triangles, view_projection(camera, {120, 90}), 120, 90);
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 120; ++x) {
            const std::uint32_t count = counts[static_cast<std::size_t>(y * 120 + x)];
            const bool horizon = y >= 44 && y <= 46;
            ASSERT_TRUE(horizon || count == (y < 44 ? 0u : 1u)) << x << " " << y << ": " << count;
        }
    }
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
