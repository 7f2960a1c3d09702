// The reference tessellator against the datapath at level ref, leaf for leaf; and the reference
// tessellator with each known mistake put in, which the crack check must notice.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include <glm/geometric.hpp>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/adaptive_run.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/reference_input.h"

namespace repousse {
namespace {

using reference::Mistake;

constexpr uint64_t kSeed = 20260;

Profile uv_profile(int frac) {
    return test::profile_with("default", {{"uv", "s14." + std::to_string(frac)}});
}

// Leaves with positions in an order of their own, so that two runs compare as sets.
std::vector<std::array<double, 15>> sorted_rows(
    const std::vector<reference::LeafTriangle>& leaves) {
    std::vector<std::array<double, 15>> rows;
    for (const auto& leaf : leaves) {
        std::size_t first = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (leaf.corners[k].uv < leaf.corners[first].uv) first = k;
        }
        std::array<double, 15> row;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& c = leaf.corners[(first + k) % 3];
            row[5 * k] = double(c.uv[0]), row[5 * k + 1] = double(c.uv[1]);
            for (std::size_t i = 0; i < 3; ++i) row[5 * k + 2 + i] = c.position[i];
        }
        rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

template <class T>
T pick(std::mt19937_64& random, std::initializer_list<T> values) {
    return *(values.begin() + random() % values.size());
}

double fraction(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

// A small mesh of either kind on a small map whose sides are no powers of two, with jittered
// vertices and any combination of settings.
test::Object random_object(std::mt19937_64& random) {
    test::Object object;
    const auto side = [&] { return 5 + int(random() % 36); };
    host::FbmSettings fbm;
    fbm.seed = random();
    fbm.octaves = 1 + int(random() % 6);
    fbm.wrap = random() % 2 == 0;
    object.map = host::make_fbm_map(side(), side(), fbm);
    if (random() % 3 == 0) {
        for (uint16_t& h : object.map.texels) h = uint16_t(random());
    }
    object.map.range_low = -0.2 * fraction(random);
    object.map.range_high = 0.3 * fraction(random);
    if (fbm.wrap && random() % 2 == 0) {
        object.mesh = host::make_cylinder(3 + int(random() % 5), 1 + int(random() % 3), 1.0, 1.5);
    } else {
        object.mesh = host::make_grid(1 + int(random() % 4), 1 + int(random() % 4));
        for (std::size_t i = 0; i < object.mesh.uv.size(); ++i) {
            object.mesh.uv[i] += glm::dvec2(fraction(random), fraction(random)) * 0.1 - 0.05;
            object.mesh.positions[i].z = 0.1 * fraction(random);
            // Tilted frames, so that no component of N' stands for one of the map's.
            const glm::dvec3 lean(fraction(random) - 0.5, fraction(random) - 0.5, 1.0);
            object.mesh.normals[i] = glm::normalize(lean);
            object.mesh.tangents[i] = glm::normalize(glm::cross(glm::dvec3(0, 1, 0.3), lean));
        }
        if (random() % 4 == 0) {
            for (double& hand : object.mesh.handedness) hand = -1.0;
        }
    }
    object.filter = pick(random, {host::HeightFilter::Nearest, host::HeightFilter::Bilinear});
    object.uv = pick(random, {host::UvSpan::Edges, host::UvSpan::Centres});
    host::AdaptiveSettings& s = object.settings;
    const auto tests = random() % 8;
    if (tests & 1) s.normal_threshold = fraction(random);
    if (tests & 2) {
        s.height_mode = pick(random, {host::HeightMode::Average, host::HeightMode::Sum});
        s.height_threshold = std::exp2(16 * fraction(random));
    }
    if (tests & 4) s.view_threshold_px = std::exp2(6 * fraction(random));
    s.box = pick(random, {host::BoxKind::Square, host::BoxKind::Literal});
    s.normal_space = pick(random, {host::NormalSpace::World, host::NormalSpace::Map});
    s.order = pick(random, {host::StackOrder::Lifo, host::StackOrder::Fifo});
    s.eager = random() % 2 == 0;
    return object;
}

// No random mesh or map is outside of the height test's domain often enough to thin the test out.
TEST(ReferenceTessellator, AgreesWithLevelRefOnRandomScenes) {
    constexpr int kScenes = 400;
    std::size_t triangles = 0;
    int refused = 0;
    for (int n = 0; n < kScenes; ++n) {
        std::mt19937_64 random(kSeed + uint64_t(n));
        const test::Object object = random_object(random);
        host::DrawInputs in = object.inputs();
        host::CameraSettings camera;
        camera.eye = {0.3, -1.2, 0.9};
        in.view = host::view_frame(camera, {512, 512});
        const int frac = 4 + int(random() % 13);
        const Profile profile = host::reference_profile(uv_profile(frac));
        in.settings.generation_cap =
            std::min(8, host::natural_cap(in, frac) + int(random() % 3) - 1);
        if (*in.settings.generation_cap < 0) in.settings.generation_cap = 0;
        const auto draw = host::make_draw<Real>(profile, in);
        refused += !draw;
        if (!draw) continue;
        const test::AdaptiveRun run = test::run_adaptive(profile, *draw, 1 + n % 64);
        const auto expected = reference::tessellate(test::reference_input(in, frac));
        ASSERT_TRUE(run.fits && expected.finished);
        SCOPED_TRACE("seed " + std::to_string(kSeed + uint64_t(n)));
        ASSERT_EQ(run.counters.split.items, expected.visits);
        ASSERT_EQ(run.counters.split.edges_split, expected.by_split_edges);
        ASSERT_EQ(reference::hash_leaves(run.leaves), reference::hash_leaves(expected.leaves));
        ASSERT_EQ(sorted_rows(run.leaves), sorted_rows(expected.leaves));
        triangles += run.leaves.size();
    }
    std::printf("seeds %llu to %llu: %d scenes, %zu triangles equal, %d scenes refused\n",
                (unsigned long long)kSeed, (unsigned long long)kSeed + kScenes - 1,
                kScenes - refused, triangles, refused);
    EXPECT_LT(refused, kScenes / 10);
    EXPECT_GT(triangles, 100'000u);
}

// A real relief (or the noise that stands in for it) on 18 triangles.
test::Object terrain() {
    test::Object object;
    object.mesh = host::make_grid(3, 3);
    object.map = test::jacksboro_relief(70, 44, 256, 256).map;
    object.map.range_high = 0.1;
    object.settings.normal_threshold = 0.4;
    object.settings.height_threshold = 2048;
    return object;
}

// A column wrapped in a periodic map, or in one whose left and right border differ.
test::Object column(bool periodic_map) {
    test::Object object;
    object.mesh = host::make_cylinder(12, 16, 1.0, 16.0);
    host::FbmSettings fbm;
    fbm.seed = 11;
    fbm.cells_y = 16;
    fbm.wrap = periodic_map;
    object.map = host::make_fbm_map(128, 512, fbm);
    object.map.wrap = true;
    object.map.range_high = 0.3;
    object.settings.normal_threshold = 0.4;
    object.settings.height_threshold = 1024;
    return object;
}

// T-vertices, by places on the base surface: a seam that gapes is not counted for that alone.
struct Broken {
    std::size_t triangles = 0, open_edges = 0;
};

Broken broken(const test::Object& object, int frac, Mistake mistake, bool cap_depth = false) {
    const host::DrawInputs in = object.inputs();
    reference::TessellatorInput input = test::reference_input(in, frac);
    input.mistake = mistake;
    input.cap_depth = cap_depth;
    const auto run = reference::tessellate(input);
    input.cap = 0;
    const auto base = reference::tessellate(input);
    EXPECT_TRUE(run.finished);
    return {run.flat.size(), reference::check_leaves(run.flat, base.flat).open_edges};
}

TEST(ReferenceTessellator, HasNoOpenEdgeWithoutMistake) {
    for (const int frac : {0, 2, 4, 8, 16}) {
        test::Object object = terrain();
        EXPECT_EQ(broken(object, frac, Mistake::None).open_edges, 0u) << frac;
        object.settings.box = host::BoxKind::Literal;
        EXPECT_EQ(broken(object, frac, Mistake::None).open_edges, 0u) << frac;
        EXPECT_EQ(broken(column(true), frac, Mistake::None).open_edges, 0u) << frac;
    }
}

TEST(ReferenceTessellator, TruncatingMidpointBreaksEdges) {
    for (const int frac : {0, 4, 8}) {
        test::Object object = terrain();
        const Broken found = broken(object, frac, Mistake::TruncatingMidpoint);
        std::printf("truncating midpoint, %d fraction bits: %zu open edges of %zu triangles\n",
                    frac, found.open_edges, found.triangles);
        EXPECT_GT(found.open_edges, 1000u);
    }
}

TEST(ReferenceTessellator, SignedShiftBreaksEdgesWithLiteralBoxesOnly) {
    for (const int frac : {0, 4, 8}) {
        test::Object object = terrain();
        EXPECT_EQ(broken(object, frac, Mistake::SignedShiftBoxes).open_edges, 0u);
        object.settings.box = host::BoxKind::Literal;
        const Broken found = broken(object, frac, Mistake::SignedShiftBoxes);
        std::printf("signed shift, literal boxes, %d fraction bits: %zu open edges of %zu\n", frac,
                    found.open_edges, found.triangles);
        EXPECT_GT(found.open_edges, 300u);
    }
}

TEST(ReferenceTessellator, ClampedSeamBreaksEdges) {
    for (const bool periodic_map : {false, true}) {
        const Broken found = broken(column(periodic_map), 8, Mistake::ClampedSeam);
        std::printf("clamped seam, %s map: %zu open edges of %zu triangles\n",
                    periodic_map ? "periodic" : "other", found.open_edges, found.triangles);
        EXPECT_GT(found.open_edges, 100u);
    }
}

// A cap on a triangle's depth is crack-free as well: an edge is split as soon as it exists or
// never, so both triangles that can still split it are equally deep.
TEST(ReferenceTessellator, TriangleDepthCapKeepsEdgesClosed) {
    for (int cap = 1; cap <= 9; ++cap) {
        test::Object object = terrain();
        object.settings.generation_cap = cap;
        const Broken found = broken(object, 8, Mistake::None, true);
        EXPECT_EQ(found.open_edges, 0u) << cap;
        EXPECT_LE(found.triangles, broken(object, 8, Mistake::None).triangles) << cap;
    }
}

// The recursion as printed, on the paper's own scene: chains of ever thinner triangles.
TEST(ReferenceTessellator, WithoutCapTheRecursionDoesNotEnd) {
    test::Object object;
    object.mesh = host::make_grid(3, 3);
    object.map = host::make_donut_map(256, 256);
    object.settings.normal_threshold = 0.2;
    reference::TessellatorInput input = test::reference_input(object.inputs(), 16);
    const auto capped = reference::tessellate(input);
    EXPECT_TRUE(capped.finished);
    input.cap.reset();
    input.visit_limit = 200 * capped.visits;
    const auto endless = reference::tessellate(input);
    std::printf("with cap %llu visits; without, still running after %llu\n",
                (unsigned long long)capped.visits, (unsigned long long)endless.visits);
    EXPECT_FALSE(endless.finished);
}

}  // namespace
}  // namespace repousse
