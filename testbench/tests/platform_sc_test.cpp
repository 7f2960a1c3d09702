// The platform at level lt gives what the bare loop gives, byte for byte: triangles, their order
// and every counter. The SystemC kernel elaborates once a process, so each case runs in a child.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/adaptive_run.h"
#include "testbench/tests/support/profiles.h"
#include "tlm/platform/platform.h"

namespace repousse {
namespace {

const host::Mesh& grid() {
    static const host::Mesh mesh = host::make_grid(3, 3);
    return mesh;
}

const host::HeightMap& donut() {
    static const host::HeightMap map = host::make_donut_map(256, 256);
    return map;
}

AdaptiveDraw<Fixed> donut_draw(const Profile& profile, const host::AdaptiveSettings& settings,
                               bool bump = false) {
    host::DrawInputs inputs;
    inputs.mesh = &grid();
    inputs.map = &donut();
    inputs.settings = settings;
    inputs.bump = bump;
    inputs.texel_size = glm::dvec2(1.0 / 256);
    host::CameraSettings camera;
    camera.eye = {.5, -.6, .5};
    camera.target = {.5, .5, 0};
    inputs.view = host::view_frame(camera, {});
    auto draw = host::make_draw<Fixed>(profile, inputs);
    if (!draw) std::fprintf(stderr, "%s\n", draw.error().message().c_str());
    return *draw;
}

host::AdaptiveSettings all_tests() {
    host::AdaptiveSettings settings;
    settings.normal_threshold = .2;
    settings.height_threshold = 4096;
    settings.view_threshold_px = 8;
    return settings;
}

DeviceConfig config_for(const Profile& profile, const AdaptiveDraw<Fixed>& draw) {
    DeviceConfig config;
    config.profile = profile;
    config.view_test = draw.registers.use_view_test;
    config.normal_test = draw.registers.use_normal_test;
    config.height_test = draw.registers.use_height_test;
    config.bump = draw.registers.use_bump;
    return config;
}

auto corner_key(const OutputVertex<Fixed>& v) {
    return std::make_tuple(v.uv.x, v.uv.y, v.displaced.x, v.displaced.y, v.displaced.z,
                           v.displaced_normal.x, v.displaced_normal.y, v.displaced_normal.z,
                           v.generation);
}

bool same(const OutputTriangle<Fixed>& a, const OutputTriangle<Fixed>& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (corner_key(a.corners[k]) != corner_key(b.corners[k])) return false;
    }
    return a.path.base == b.path.base && a.path.depth == b.path.depth &&
           a.path.digits == b.path.digits;
}

// Runs the platform in this process and compares; the status for exit().
int compare(const DeviceConfig& config, const AdaptiveDraw<Fixed>& draw,
            const shell::PlatformOptions& options) {
    std::vector<OutputTriangle<Fixed>> expected;
    AdaptivePipeline<Fixed> pipeline(config.profile, draw);
    pipeline.run([&](Span<const OutputTriangle<Fixed>> triangles) {
        expected.insert(expected.end(), triangles.begin(), triangles.end());
    });
    auto platform = shell::Platform::create(config, {draw}, options);
    // Twice: a run leaves nothing behind that the next one could see.
    const auto first = platform->run({draw});
    const auto result = platform->run({draw});
    if (!first || !result) {
        std::fprintf(stderr, "%s\n", result.error().message().c_str());
        return 2;
    }
    const auto& found = result->triangles.at(0);
    bool equal = found.size() == expected.size() && result->cycles > 0 &&
                 result->cycles == first->cycles && result->simulated_ns == first->simulated_ns;
    for (std::size_t i = 0; equal && i < found.size(); ++i) equal = same(found[i], expected[i]);
    for (const CounterRow& row : pipeline.counters().rows()) {
        for (const CounterRow& other : result->counters.rows()) {
            if (row.unit == other.unit && row.name == other.name) equal &= row.value == other.value;
        }
    }
    return equal ? 0 : 1;
}

void expect_equal(const DeviceConfig& config, const AdaptiveDraw<Fixed>& draw,
                  const shell::PlatformOptions& options = {}) {
    EXPECT_EXIT(std::exit(compare(config, draw, options)), testing::ExitedWithCode(0), "");
}

TEST(Platform, AllTestsGiveTheBareLoopsBytes) {
    const Profile profile = test::profile_with("default", {});
    const auto draw = donut_draw(profile, all_tests());
    expect_equal(config_for(profile, draw), draw);
}

TEST(Platform, OutputBufferOfSevenTrianglesIsDrained) {
    const Profile profile = test::profile_with("default", {});
    const auto draw = donut_draw(profile, all_tests());
    shell::PlatformOptions options;
    options.output_capacity = 7;
    expect_equal(config_for(profile, draw), draw, options);
}

TEST(Platform, WithoutDmi) {
    const Profile profile = test::profile_with("default", {});
    const auto draw = donut_draw(profile, all_tests());
    shell::PlatformOptions options;
    options.allow_dmi = false;
    expect_equal(config_for(profile, draw), draw, options);
}

TEST(Platform, HeightTestAloneWithNormalsWanted) {
    const Profile profile = test::profile_with("narrow", {});
    host::AdaptiveSettings settings;
    settings.height_threshold = 1024;
    settings.eager = true;
    settings.order = host::StackOrder::Fifo;
    const auto draw = donut_draw(profile, settings, true);
    expect_equal(config_for(profile, draw), draw);
}

TEST(Platform, UnusedUnitsChangeNothing) {
    const Profile profile = test::profile_with("default", {});
    host::AdaptiveSettings settings;
    settings.height_threshold = 4096;
    const auto draw = donut_draw(profile, settings);
    DeviceConfig everything = config_for(profile, draw);
    everything.include_everything();
    expect_equal(everything, draw);
}

TEST(Platform, MissingUnitIsReported) {
    const Profile profile = test::profile_with("default", {});
    const auto draw = donut_draw(profile, all_tests());
    DeviceConfig config = config_for(profile, draw);
    config.height_test = false;
    EXPECT_EXIT(std::exit(compare(config, draw, {})), testing::ExitedWithCode(2),
                "needs a unit that was not built");
}

}  // namespace
}  // namespace repousse
