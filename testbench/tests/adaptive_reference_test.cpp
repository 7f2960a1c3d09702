// The reference rows: level ref on the paper's figure 10 scene and on a real elevation map gives
// the published counts of two independent prototypes, exactly.

#include <gtest/gtest.h>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/adaptive_run.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/reference_input.h"

namespace repousse {
namespace {

using host::AdaptiveSettings;

struct Row {
    const char* name;
    double normal;  // threshold; negative: no normal test
    double height;  // threshold; negative: no height test
    host::HeightMode mode;
    std::size_t triangles, vertices;
    double rms, max;
    uint64_t visits, one, two, three;
    std::size_t lifo_peak;
    uint64_t hash;
};

constexpr Row kRows[] = {
    {"R1", .2, -1, host::HeightMode::Average, 4838, 2426, 1.904e-3, .0205, 7360, 600, 1546, 376, 18,
     0x46c7082e5f9f2ce0},
    {"R2", -1, 4096, host::HeightMode::Average, 1372, 693, 4.741e-3, .0464, 2288, 518, 358, 40, 13,
     0x5c6847c66f02a96f},
    {"R3", .2, 4096, host::HeightMode::Average, 5686, 2850, 1.804e-3, .0228, 8630, 730, 1704, 510,
     18, 0x8ccb07fc3b1a6055},
    {"R4", -1, 1e6, host::HeightMode::Sum, 226, 120, 9.738e-3, .0527, 334, 40, 36, 32, 7,
     0x2d32567dad32ac53},
    {"R5", .2, 1e6, host::HeightMode::Sum, 5154, 2584, 1.652e-3, .0205, 7862, 688, 1612, 408, 16,
     0xd255300f3415ec1c},
};

// Triangles, vertices, visits and triangles with one, two and three split edges.
using Counts = std::array<std::size_t, 6>;

Counts counts(const test::AdaptiveRun& run) {
    const auto report = reference::check_leaves(run.leaves, run.base);
    EXPECT_EQ(report.open_edges, 0u);
    EXPECT_EQ(report.flipped, 0u);
    const auto& split = run.counters.split;
    return {report.triangles,     report.vertices,      split.items,
            split.edges_split[1], split.edges_split[2], split.edges_split[3]};
}

// Level lt with the default profile: every count within 3 % of level ref's.
void expect_near(const Counts& found, const Counts& expected) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(double(found[i]), double(expected[i]), 0.03 * double(expected[i]))
            << "count " << i;
    }
}

test::AdaptiveRun run_lt(const host::DrawInputs& in) {
    const Profile profile = test::profile_with("default", {});
    const auto draw = host::make_draw<Fixed>(profile, in);
    EXPECT_TRUE(draw) << draw.error().message();
    return test::run_adaptive(profile, *draw);
}

class ReferenceRow : public testing::TestWithParam<Row> {
protected:
    const host::Mesh mesh_ = host::make_grid(3, 3);
    const host::HeightMap map_ = host::make_donut_map(256, 256);

    host::DrawInputs inputs(const Row& row) const {
        host::DrawInputs in;
        in.mesh = &mesh_;
        in.map = &map_;
        in.texel_size = glm::dvec2(1.0 / 256);
        if (row.normal >= 0) in.settings.normal_threshold = row.normal;
        if (row.height >= 0) in.settings.height_threshold = row.height;
        in.settings.height_mode = row.mode;
        return in;
    }

    reference::HeightError error(const test::AdaptiveRun& run) const {
        const reference::SampleLattice texel_centres{256,      256,      .5 / 256,
                                                     1. / 256, .5 / 256, 1. / 256};
        return reference::height_error(run.leaves, texel_centres, [this](int x, int y) {
            return map_.at(x, y) * (.12 / 65535);
        });
    }
};

TEST_P(ReferenceRow, LevelRefIsExact) {
    const Row& row = GetParam();
    const Profile profile =
        host::reference_profile(test::profile_with("default", {{"uv", "s14.16"}}));
    auto in = inputs(row);
    ASSERT_EQ(host::natural_cap(in, profile.uv.frac), 7);
    const auto draw = host::make_draw<Real>(profile, in);
    ASSERT_TRUE(draw) << draw.error().message();
    const test::AdaptiveRun run = test::run_adaptive(profile, *draw);
    ASSERT_TRUE(run.fits);
    const auto report = reference::check_leaves(run.leaves, run.base);
    EXPECT_EQ(report.triangles, row.triangles);
    EXPECT_EQ(report.vertices, row.vertices);
    EXPECT_EQ(report.open_edges, 0u);
    EXPECT_EQ(report.flipped, 0u);
    EXPECT_EQ(run.counters.split.items, row.visits);
    EXPECT_EQ(run.counters.split.edges_split[1], row.one);
    EXPECT_EQ(run.counters.split.edges_split[2], row.two);
    EXPECT_EQ(run.counters.split.edges_split[3], row.three);
    EXPECT_EQ(run.counters.stack_peak, row.lifo_peak);
    EXPECT_EQ(reference::hash_leaves(run.leaves), row.hash);
    const reference::HeightError e = error(run);
    EXPECT_EQ(e.samples, 256u * 256u);
    EXPECT_NEAR(e.rms, row.rms, 0.5e-6);
    EXPECT_NEAR(e.max, row.max, 0.5e-4);
}

TEST_P(ReferenceRow, LevelLtIsWithinThreePercent) {
    const Row& row = GetParam();
    const test::AdaptiveRun run = run_lt(inputs(row));
    ASSERT_TRUE(run.fits);
    const Counts found = counts(run);
    expect_near(found, {row.triangles, row.vertices, row.visits, row.one, row.two, row.three});
    EXPECT_EQ(run.counters.displace.overflows, 0u);
    EXPECT_EQ(run.counters.mid_vertex.degenerate, 0u);
    std::printf("%s lt: %zu triangles, rms %.4g\n", row.name, found[0], error(run).rms);
}

INSTANTIATE_TEST_SUITE_P(Donut, ReferenceRow, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

const Profile kReference =
    host::reference_profile(test::profile_with("default", {{"uv", "s14.16"}}));

// A real map: the Jacksboro elevations, rescaled over the file's full range, rows 44..299 and
// columns 70..325, row 44 at v = 0, world z range 0.1, on 4 x 4 quads.
TEST(ReferenceRows, R6OnARealMapIsExact) {
    const test::Relief relief = test::jacksboro_relief(70, 44, 256, 256);
    if (!relief.real) GTEST_SKIP() << "the elevation file is absent: scenes/fetch.sh gets it";
    test::Object object;
    object.mesh = host::make_grid(4, 4);
    object.map = relief.map;
    object.map.range_high = 0.1;
    object.settings.normal_threshold = 0.4;
    object.settings.height_threshold = 2048;
    const host::DrawInputs in = object.inputs();
    ASSERT_EQ(host::natural_cap(in, kReference.uv.frac), 6);
    const auto draw = host::make_draw<Real>(kReference, in);
    ASSERT_TRUE(draw) << draw.error().message();
    const test::AdaptiveRun run = test::run_adaptive(kReference, *draw);
    const Counts expected{32045, 16213, 48880, 5217, 8058, 3560};
    EXPECT_EQ(counts(run), expected);
    expect_near(counts(run_lt(in)), expected);
    const reference::SampleLattice texel_centres{256, 256, .5 / 256, 1. / 256, .5 / 256, 1. / 256};
    const auto error = reference::height_error(run.leaves, texel_centres, [&](int x, int y) {
        return object.map.at(x, y) * (.1 / 65535);
    });
    EXPECT_NEAR(error.rms, 2.009e-3, 0.5e-6);
    EXPECT_NEAR(error.max, .0265, 0.5e-4);
}

// R3 under a view test of 8 pixels: eye (.5, -.6, .5) towards (.5, .5, 0), up z, a screen of
// 256 + 384 * (right, up) / depth.
TEST(ReferenceRows, R8UnderTheViewTestIsExact) {
    test::Object object;
    object.mesh = host::make_grid(3, 3);
    object.map = host::make_donut_map(256, 256);
    object.settings.normal_threshold = 0.2;
    object.settings.height_threshold = 4096;
    object.settings.view_threshold_px = 8;
    host::DrawInputs in = object.inputs();
    host::CameraSettings camera;
    camera.eye = {.5, -.6, .5};
    camera.target = {.5, .5, 0};
    in.view = host::view_frame(camera, {512, 512});
    in.view.focal = {384, 384};
    in.view.near = 1e-6;
    const auto draw = host::make_draw<Real>(kReference, in);
    ASSERT_TRUE(draw) << draw.error().message();
    const test::AdaptiveRun run = test::run_adaptive(kReference, *draw);
    const Counts expected{2900, 1457, 4596, 685, 836, 175};
    EXPECT_EQ(counts(run), expected);
    expect_near(counts(run_lt(in)), expected);
    const reference::SampleLattice texel_centres{256, 256, .5 / 256, 1. / 256, .5 / 256, 1. / 256};
    const auto error = reference::height_error(run.leaves, texel_centres, [&](int x, int y) {
        return object.map.at(x, y) * (.12 / 65535);
    });
    EXPECT_NEAR(error.rms, 2.132e-3, 0.5e-6);
    EXPECT_NEAR(error.max, .0335, 0.5e-4);
}

}  // namespace
}  // namespace repousse
