// The platform at level lt gives what the bare loop gives, byte for byte: triangles, their order
// and every counter. The SystemC kernel elaborates once a process, so each case runs in a child.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "testbench/host/draw.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/platform_run.h"
#include "testbench/tests/support/profiles.h"

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
    return test::config_for(profile, {draw});
}

void expect_equal(const DeviceConfig& config, const AdaptiveDraw<Fixed>& draw,
                  const shell::PlatformOptions& options = {}) {
    EXPECT_EXIT(std::exit(test::compare(config, {draw}, options)), testing::ExitedWithCode(0), "");
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
    EXPECT_EXIT(std::exit(test::compare(config, {draw})), testing::ExitedWithCode(2),
                "needs a unit that was not built");
}

}  // namespace
}  // namespace repousse
