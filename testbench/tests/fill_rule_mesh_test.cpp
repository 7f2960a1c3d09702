// The view's fill rule on meshes: every sample's centre under a watertight mesh is covered once,
// and none twice, without a depth test; the meshes are sheets and what both methods make of scenes.
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/view/visibility_buffer.h"
#include "testbench/study/scene_run.h"
#include "testbench/tests/support/from_above.h"
#include "testbench/tests/support/winding.h"

namespace repousse::host {
namespace {

using test::from_above;
using test::HalfEdge;
using test::winding;

/// Samples by what is wrong with them, and by how they are covered.
struct Found {
    std::size_t wrong = 0;       ///< front - back is not the rim's winding number
    std::size_t covered = 0;     ///< by anything
    std::size_t front_once = 0;  ///< by one front face and nothing else
    std::size_t both_once = 0;   ///< by one front and one back face
};

/// Half-edges of a mesh that have no partner, by vertices; vertices in one place are one.
std::vector<std::array<std::uint32_t, 2>> rim_of(const RenderMesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    std::map<std::array<std::uint32_t, 2>, int> uses;
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = welded[t[k]], b = welded[t[(k + 1) % 3]];
            if (a == b) continue;
            ++uses[{a, b}];
            --uses[{b, a}];
        }
    }
    std::vector<std::array<std::uint32_t, 2>> rim;
    for (const auto& [edge, count] : uses) {
        for (int i = 0; i < count; ++i) rim.push_back(edge);
    }
    return rim;
}

/// Judges a mesh that is all in front of the near plane.
Found judge(const RenderMesh& mesh, const CameraSettings& camera, const Viewport& viewport,
            int samples) {
    const ViewProjection view = view_projection(camera, viewport);
    std::vector<Piece> pieces;
    add_pieces(pieces, mesh, 0, view, samples);
    EXPECT_EQ(pieces.size(), mesh.triangles.size()) << "the mesh was clipped";
    std::vector<HalfEdge> rim;
    for (const auto& [a, b] : rim_of(mesh)) {
        const auto at = [&](std::uint32_t v) {
            return snap(view, clip_vertex(view, mesh.positions[v]), samples);
        };
        rim.push_back({at(a), at(b)});
    }
    const int width = viewport.width_px * samples, height = viewport.height_px * samples;
    const auto counts = count_fills(pieces, width, height);
    Found found;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const FillCount& c = counts[static_cast<std::size_t>(y * width + x)];
            const int expected = winding(rim, x, y);
            found.wrong += static_cast<int>(c.front) - static_cast<int>(c.back) != expected;
            found.covered += c.front + c.back > 0;
            found.front_once += c.front == 1 && c.back == 0;
            found.both_once += c.front == 1 && c.back == 1;
        }
    }
    return found;
}

RenderMesh surface(const Mesh& mesh) {
    RenderMesh view;
    view.positions = mesh.positions;
    view.triangles = mesh.triangles;
    return view;
}

TEST(FillRule, SheetsCoverEachCentreOnceFromEitherSide) {
    // Vertices on pixel centres and corners: every centre is on some edge.
    for (const int quads : {1, 2, 3, 8, 16, 50, 64}) {
        Mesh mesh = make_grid(quads, quads);
        CameraSettings camera = from_above();
        camera.fov_deg *= 0.9999999;
        const Viewport viewport{64, 64};
        EXPECT_EQ(judge(surface(mesh), camera, viewport, 1).front_once, 4096u) << quads;
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);  // from behind
        const Found behind = judge(surface(mesh), camera, viewport, 1);
        EXPECT_EQ(behind.wrong, 0u) << quads;
        EXPECT_EQ(behind.covered, 4096u) << quads;
        EXPECT_EQ(behind.front_once, 0u) << quads;
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
        const int samples = 1 + round % 4;
        const Found found = judge(surface(mesh), from_above(), {97, 61}, samples);
        EXPECT_EQ(found.front_once, static_cast<std::size_t>(97 * 61 * samples * samples));
        EXPECT_EQ(found.wrong, 0u);
    }
}

TEST(FillRule, AMissingTriangleIsFound) {
    Mesh mesh = make_grid(8, 8);
    const Found whole = judge(surface(mesh), from_above(), {64, 64}, 1);
    mesh.triangles.pop_back();
    const Found torn = judge(surface(mesh), from_above(), {64, 64}, 1);
    EXPECT_GT(whole.covered, torn.covered + 10);
    EXPECT_EQ(torn.wrong, 0u) << "the hole's rim is a rim";
    mesh.triangles.push_back(mesh.triangles.front());  // one lies twice
    EXPECT_LT(judge(surface(mesh), from_above(), {64, 64}, 1).front_once, torn.front_once);
}

TEST(FillRule, AnEndlessPlaneThroughTheEyePlaneHasNoHoles) {
    // The plane passes below the eye and behind it; all pixels below the horizon see it once.
    Mesh mesh = make_grid(30, 30, {4000.0, 4000.0});
    for (glm::dvec3& p : mesh.positions) p -= glm::dvec3(2000.0, 2000.0, 0.0);
    CameraSettings camera;
    camera.eye = {1.0, -3.0, 2.0};
    camera.target = {2.0, 30.0, 2.0};
    camera.far = 1e6;
    camera.near = 0.1;
    std::vector<Piece> pieces;
    add_pieces(pieces, surface(mesh), 0, view_projection(camera, {120, 90}), 1);
    const auto counts = count_fills(pieces, 120, 90);
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 120; ++x) {
            const FillCount& c = counts[static_cast<std::size_t>(y * 120 + x)];
            const bool horizon = y >= 44 && y <= 46;
            ASSERT_EQ(c.back, 0u);
            ASSERT_TRUE(horizon || c.front == (y < 44 ? 0u : 1u)) << x << " " << y;
        }
    }
}

study::SceneRun load(const std::string& text) {
    auto scene = parse_scene(text, "test", "scenes");
    if (!scene) ADD_FAILURE() << scene.error().message();
    auto run = study::SceneRun::load(*scene);
    if (!run) ADD_FAILURE() << run.error().message();
    return std::move(*run);
}

RenderMesh run_of(const study::SceneRun& run) {
    auto surface = run.run(0);
    if (!surface) ADD_FAILURE() << surface.error().message();
    EXPECT_EQ(surface->rejected, 0u);
    return std::move(surface->view);
}

void print(const char* name, std::size_t triangles, const Found& found) {
    std::printf(
        "%s: %zu triangles, %zu samples covered, %zu by one front, %zu by one front and one back; "
        "%zu wrong\n",
        name, triangles, found.covered, found.front_once, found.both_once, found.wrong);
}

TEST(FillRuleOfRuns, DonutFromItsCamerasAndFromStraightAbove) {
    auto run = study::SceneRun::open("scenes/donut_small.toml");
    ASSERT_TRUE(run) << run.error().message();
    const RenderMesh mesh = run_of(*run);
    for (int samples = 1; samples <= 4; ++samples) {
        const Found found = judge(mesh, run->scene.camera, run->scene.viewport, samples);
        EXPECT_EQ(found.wrong, 0u) << samples;
        EXPECT_GT(found.covered, 1000u);
        print("donut", mesh.triangles.size(), found);
    }
    // 48 pixels a unit, half a pixel aside: the plain around the ring has its vertices on centres,
    // at 16, 8, 4, 2 and 1 pixels. From so high that the ring hides nothing of the plain.
    CameraSettings camera;
    camera.eye = {0.5 + 0.5 / 48, 0.5 + 0.5 / 48, 50.0};
    camera.target = {camera.eye.x, camera.eye.y, 0.0};
    camera.up = {0.0, 1.0, 0.0};
    camera.fov_deg = 2.0 * std::atan(0.5 * 64 / 48 / 50.0) * 180.0 / 3.14159265358979323846;
    const Found found = judge(mesh, camera, {64, 64}, 1);
    print("donut from above", mesh.triangles.size(), found);
    EXPECT_EQ(found.wrong, 0u);
    EXPECT_EQ(found.front_once, 48u * 48u);
    EXPECT_EQ(found.covered, 48u * 48u);
}

TEST(FillRuleOfRuns, TiltIsCoveredOnceAtAllSampleRates) {
    auto run = study::SceneRun::open("scenes/tilt_small.toml");
    ASSERT_TRUE(run) << run.error().message();
    run->scene.objects[0].sweep.clip = false;
    const RenderMesh mesh = run_of(*run);
    for (int samples = 1; samples <= 4; ++samples) {
        const Found found = judge(mesh, run->scene.camera, run->scene.viewport, samples);
        print("tilt", mesh.triangles.size(), found);
        EXPECT_EQ(found.wrong, 0u) << samples;
        EXPECT_EQ(found.front_once, found.covered) << "a tilted plane hides nothing of itself";
        EXPECT_GT(found.covered, 1000u);
    }
}

/// A ball as the sweep leaves it: closed, so front and back faces are as many everywhere.
study::SceneRun ball(const std::string& map) {
    return load(
        "[viewport]\nwidth_px = 90\nheight_px = 80\n[camera]\neye = [0.4, -3.1, 1.3]\n"
        "target = [0, 0, 0]\nfov_deg = 45\n[[object]]\nmethod = \"sweep\"\n"
        "[object.mesh]\nkind = \"icosphere\"\nsubdivisions = 2\n[object.map]\n" +
        map + "wrap = true\n[object.sweep]\ncoarseness_px = 2\n");
}

TEST(FillRuleOfRuns, AClosedBallShowsOneFrontAndOneBack) {
    const study::SceneRun run = ball("kind = \"constant\"\nsize_texels = [8, 8]\nrange = 0.1\n");
    const RenderMesh mesh = run_of(run);
    EXPECT_TRUE(rim_of(mesh).empty());
    for (int samples = 1; samples <= 4; ++samples) {
        const Found found = judge(mesh, run.scene.camera, run.scene.viewport, samples);
        print("ball", mesh.triangles.size(), found);
        EXPECT_EQ(found.wrong, 0u) << samples;
        EXPECT_GT(found.covered, 2500u);
        EXPECT_EQ(found.both_once, found.covered) << samples;
    }
}

TEST(FillRuleOfRuns, ADisplacedBallIsClosed) {
    const study::SceneRun run =
        ball("kind = \"donut\"\nsize_texels = [64, 64]\nrange = 0.3\nfilter = \"bilinear\"\n");
    const RenderMesh mesh = run_of(run);
    EXPECT_TRUE(rim_of(mesh).empty());
    for (int samples = 1; samples <= 4; ++samples) {
        const Found found = judge(mesh, run.scene.camera, run.scene.viewport, samples);
        print("displaced ball", mesh.triangles.size(), found);
        EXPECT_EQ(found.wrong, 0u) << samples;
        EXPECT_GT(found.both_once, 2500u);
    }
}

TEST(FillRuleOfRuns, AnAdaptiveCylinderIsOpenAtItsEndsOnly) {
    auto run = study::SceneRun::open("scenes/cylinder.toml");
    ASSERT_TRUE(run) << run.error().message();
    run->scene.viewport = {160, 90};
    const RenderMesh mesh = run_of(*run);
    for (const auto& edge : rim_of(mesh)) {
        for (const std::uint32_t v : edge) {
            const double z = mesh.positions[v].z;
            ASSERT_TRUE(std::fabs(z) < 1e-3 || std::fabs(z - 2.0) < 1e-3) << z;
        }
    }
    for (int samples = 1; samples <= 4; ++samples) {
        const Found found = judge(mesh, run->scene.camera, run->scene.viewport, samples);
        print("cylinder", mesh.triangles.size(), found);
        EXPECT_EQ(found.wrong, 0u) << samples;
        EXPECT_GT(found.both_once, 2000u);
    }
}

}  // namespace
}  // namespace repousse::host
