// The hard cases of adaptive tessellation by name, at level lt unless they say otherwise.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "testbench/tests/support/soundness.h"

namespace repousse {
namespace {

using test::Object;
using test::Outcome;

const Profile kDefault = test::profile_with("default", {});

Object plane(host::HeightMap map, int quads = 3) {
    Object object;
    object.mesh = host::make_grid(quads, quads);
    object.map = std::move(map);
    return object;
}

TEST(HardCase, ConstantMapWithAverageStaysTheBaseMesh) {
    for (const int value : {0, 1, 30000, 65535}) {
        for (const double threshold : {0.0, 1.0, 4096.0, 65535.0}) {
            for (const char* shipped : {"default", "narrow"}) {
                Object object = plane(host::make_constant_map(256, 256, uint16_t(value)));
                object.settings.height_threshold = threshold;
                object.settings.normal_threshold = 0.0;
                const Profile profile = test::profile_with(shipped, {});
                const Outcome outcome = test::tessellate<Fixed>(profile, object);
                EXPECT_EQ(outcome.report.triangles, 18u) << value << ", " << threshold;
                object.map.wrap = true;
                EXPECT_EQ(test::tessellate<Fixed>(profile, object).report.triangles, 18u);
            }
        }
    }
}

// SUM as printed compares sums over boxes whose integer areas are not 4:1, so a constant map does
// split: that is why AVG is the default.
TEST(HardCase, ConstantMapWithSumSplits) {
    Object object = plane(host::make_constant_map(256, 256, 30000));
    object.settings.height_mode = host::HeightMode::Sum;
    const Profile profile = host::reference_profile(test::profile_with_uv("default", 16));
    const std::pair<double, std::size_t> measured[] = {{1e3, 69238}, {1e5, 1442}, {1e6, 140}};
    for (const auto& [threshold, triangles] : measured) {
        object.settings.height_threshold = threshold;
        const Outcome outcome = test::tessellate<Real>(profile, object);
        EXPECT_EQ(outcome.report.triangles, triangles) << threshold;
        EXPECT_EQ(outcome.report.open_edges, 0u);
    }
}

TEST(HardCase, RampNeedsAThresholdAboveItsSlope) {
    Object object = plane(host::make_ramp_map(256, 256, 0, 100, 100));
    object.map.range_high = 0.1;
    const Profile profile = host::reference_profile(test::profile_with_uv("default", 16));
    const std::pair<double, std::size_t> measured[] = {{1, 40660}, {100, 866}, {1000, 118}};
    for (const auto& [threshold, triangles] : measured) {
        object.settings.height_threshold = threshold;
        EXPECT_EQ(test::tessellate<Real>(profile, object).report.triangles, triangles);
        test::expect_sound(test::tessellate<Fixed>(kDefault, object), std::to_string(threshold));
    }
}

// Most edges of a grid run along an axis, where the printed rectangle has no area: the literal
// boxes see less than the square ones.
TEST(HardCase, AxisAlignedEdgesNeedSquareBoxes) {
    Object object = test::donut();
    object.settings.normal_threshold.reset();
    object.settings.height_mode = host::HeightMode::Sum;
    object.settings.height_threshold = 1e5;
    const Profile profile = host::reference_profile(test::profile_with_uv("default", 16));
    EXPECT_EQ(test::tessellate<Real>(profile, object).report.triangles, 2694u);
    object.settings.box = host::BoxKind::Literal;
    EXPECT_EQ(test::tessellate<Real>(profile, object).report.triangles, 1132u);
}

// Uncapped, this recursion never ends (reference_tessellator_test shows it). The cap of 15 is the
// largest there is, eight generations beyond the natural one.
TEST(HardCase, TheRecursionThatNeverEndsEnds) {
    const Profile profile = test::profile_with_uv("default", 16);
    for (const bool both : {false, true}) {
        Object object = test::donut();
        if (!both) object.settings.height_threshold.reset();
        object.settings.generation_cap = 15;
        const auto start = std::chrono::steady_clock::now();
        const Outcome outcome = test::tessellate<Fixed>(profile, object, 1);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        std::printf("cap 15: %zu triangles, %llu visits, stack peak %llu of %d, %.2f s\n",
                    outcome.report.triangles, (unsigned long long)outcome.run.counters.split.items,
                    (unsigned long long)outcome.run.counters.stack_peak, 9 * 15 + 1,
                    seconds.count());
        EXPECT_EQ(outcome.report.open_edges, 0u);
        EXPECT_LT(outcome.run.counters.split.items, 100'000u);
        EXPECT_LE(outcome.run.counters.stack_peak, 9u * 15 + 1);
        EXPECT_LT(seconds.count(), 10.0);  // of a run that takes some tens of milliseconds
    }
}

// Two quads side by side, the right one with its texture mirrored, turned by `turn` about z. The
// frames of both halves stand on the seam's two copies.
Object mirrored(double turn, host::NormalSpace space) {
    Object object;
    object.mesh = host::make_grid(1, 1);
    host::Mesh& mesh = object.mesh;
    const auto left = mesh;
    for (std::size_t i = 0; i < 4; ++i) {
        mesh.positions.push_back({2.0 - left.positions[i].x, left.positions[i].y, 0.0});
        mesh.normals.push_back(left.normals[i]);
        mesh.tangents.push_back({-1.0, 0.0, 0.0});
        mesh.handedness.push_back(-1.0);
        mesh.uv.push_back(left.uv[i]);
    }
    for (const auto& t : left.triangles) mesh.triangles.push_back({t[0] + 4, t[2] + 4, t[1] + 4});
    const auto rotate = [turn](glm::dvec3& v) {
        v = {std::cos(turn) * v.x - std::sin(turn) * v.y,
             std::sin(turn) * v.x + std::cos(turn) * v.y, v.z};
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        rotate(mesh.positions[i]);
        rotate(mesh.tangents[i]);
    }
    // Both copies of a seam vertex must be one place to the bit.
    mesh.positions[5] = mesh.positions[1];
    mesh.positions[7] = mesh.positions[3];
    host::FbmSettings fbm;
    fbm.seed = 5;
    fbm.octaves = 6;
    object.map = host::make_fbm_map(128, 128, fbm);
    object.map.range_high = 0.2;
    object.settings.normal_threshold = 0.3;
    object.settings.normal_space = space;
    return object;
}

// The test as printed compares components in world space, which a mirrored frame does not keep:
// both sides of the seam then see different differences. Map space compares what the map says.
TEST(HardCase, MirroredSeamIsClosedInMapSpaceOnly) {
    std::size_t open_world = 0;
    for (const double turn : {0.3, 0.5236, 0.9, 1.2}) {
        const Outcome map =
            test::tessellate<Fixed>(kDefault, mirrored(turn, host::NormalSpace::Map));
        test::expect_sound(map, "map space, turned " + std::to_string(turn));
        EXPECT_GT(map.report.triangles, 1000u);
        const Outcome world =
            test::tessellate<Fixed>(kDefault, mirrored(turn, host::NormalSpace::World));
        open_world += world.report.open_edges;
    }
    std::printf("mirrored seam, world space: %zu open edges at four angles\n", open_world);
    EXPECT_GT(open_world, 0u);
}

TEST(HardCase, DegenerateTextureNeverSplits) {
    Object object = test::donut();
    for (glm::dvec2& uv : object.mesh.uv) uv = {0.37, 0.61};
    const Outcome outcome = test::tessellate<Fixed>(kDefault, object);
    EXPECT_EQ(outcome.report.triangles, 18u);
    EXPECT_EQ(outcome.report.open_edges, 0u);
    EXPECT_EQ(outcome.run.counters.texcoord_test.positives, 0u);
    // One direction only: edges along it are ordinary, the others are points in the texture.
    object = test::donut();
    for (glm::dvec2& uv : object.mesh.uv) uv.y = 0.5;
    const Outcome line = test::tessellate<Fixed>(kDefault, object);
    EXPECT_EQ(line.report.open_edges, 0u);
    EXPECT_GT(line.report.triangles, 18u);
}

TEST(HardCase, ACameraInsideTheMeshSplitsWhatIsBehindIt) {
    host::CameraSettings camera;
    camera.eye = {0.5, 0.5, 0.02};
    camera.target = {0.9, 0.5, 0.02};
    Object object = test::donut();
    object.settings.view_threshold_px = 200.0;
    const host::ViewFrame view = host::view_frame(camera, {512, 512});
    const Outcome outcome = test::tessellate<Fixed>(kDefault, object, 64, view);
    test::expect_sound(outcome, "camera inside");
    EXPECT_GT(outcome.run.counters.vertex_transform->behind, 100u);
    // Behind the camera no screen length stops the recursion: as fine as without a view test.
    std::size_t behind = 0, behind_without_view = 0;
    const auto count = [](const Outcome& o) {
        std::size_t n = 0;
        for (const auto& leaf : o.run.leaves) {
            const auto& c = leaf.corners;
            n += c[0].position[0] < 0.4 && c[1].position[0] < 0.4 && c[2].position[0] < 0.4;
        }
        return n;
    };
    behind = count(outcome);
    object.settings.view_threshold_px.reset();
    behind_without_view = count(test::tessellate<Fixed>(kDefault, object));
    EXPECT_EQ(behind, behind_without_view);
    EXPECT_GT(behind, 100u);
}

TEST(HardCase, ThresholdsOfZeroAndOfTheMaximum) {
    Object object = test::donut(128);
    object.settings.normal_threshold = 2.0;  // components differ by 2 at most: never more
    object.settings.height_threshold = 65535;
    EXPECT_EQ(test::tessellate<Fixed>(kDefault, object).report.triangles, 18u);
    object.settings.height_mode = host::HeightMode::Sum;
    object.settings.height_threshold = std::exp2(38) - 1;
    EXPECT_EQ(test::tessellate<Fixed>(kDefault, object).report.triangles, 18u);
    object.settings.normal_threshold = 0.0;
    object.settings.height_threshold = 0.0;
    for (const auto mode : {host::HeightMode::Average, host::HeightMode::Sum}) {
        object.settings.height_mode = mode;
        const Outcome outcome = test::tessellate<Fixed>(kDefault, object);
        test::expect_sound(outcome, "thresholds 0");
        EXPECT_GT(outcome.report.triangles, 1000u);
    }
}

TEST(HardCase, NegativeOddTextureCoordinatesMeetTheirNeighbours) {
    for (int frac = 4; frac <= 8; ++frac) {
        Object object = test::donut(128);
        // A third of a texel off in the negative: odd sums of both signs.
        for (glm::dvec2& uv : object.mesh.uv) uv -= glm::dvec2(0.503, 0.251);
        const Outcome outcome =
            test::tessellate<Fixed>(test::profile_with_uv("default", frac), object);
        test::expect_sound(outcome, "F = " + std::to_string(frac));
        EXPECT_GT(outcome.report.triangles, 500u);
    }
}

// The jacksboro scene as it is shipped, the whole map with bilinear reads.
TEST(HardCase, TheWholeRealMap) {
    Object object;
    object.mesh = host::make_grid(26, 22, {1.0, 0.8536});
    object.map = test::jacksboro_relief(0, 0, 403, 344).map;
    object.map.range_high = 0.09;
    object.filter = host::HeightFilter::Bilinear;
    object.uv = host::UvSpan::Centres;
    object.settings.height_threshold = 300;
    object.settings.normal_threshold = 0.25;
    for (const char* shipped : {"default", "narrow"}) {
        const Outcome outcome = test::tessellate<Fixed>(test::profile_with(shipped, {}), object);
        test::expect_sound(outcome, shipped);
        std::printf("whole map, %s: %zu triangles\n", shipped, outcome.report.triangles);
        EXPECT_GT(outcome.report.triangles, 10'000u);
    }
}

}  // namespace
}  // namespace repousse
