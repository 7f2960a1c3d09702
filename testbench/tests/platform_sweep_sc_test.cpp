// Sweep-line remeshing at level lt gives what the bare loop gives, byte for byte, also mixed with
// adaptive tessellation. Each case elaborates in a child process.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <functional>

#include "testbench/tests/support/platform_draws.h"
#include "testbench/tests/support/platform_run.h"
#include "testbench/tests/support/profiles.h"
#include "tlm/records.h"

namespace repousse {
namespace {

using test::adaptive_draw;
using test::sweep_draw;
using test::with_direct_ones;
using Draws = std::vector<shell::Draw>;
using Overrides = std::vector<std::pair<std::string, std::string>>;

void expect_equal(const Profile& profile, const Draws& draws,
                  const shell::PlatformOptions& options = {}) {
    const DeviceConfig config = test::config_for(profile, draws);
    EXPECT_EXIT(std::exit(test::compare(config, draws, options)), testing::ExitedWithCode(0), "");
}

TEST(SweepPlatform, GivesTheBareLoopsBytes) {
    const Profile profile = test::profile_with("default", {});
    expect_equal(profile, {sweep_draw(profile)});
}

TEST(SweepPlatform, EveryProfileAndDepthTable) {
    expect_equal(test::profile_with("narrow", {}), {sweep_draw(test::profile_with("narrow", {}))});
    const Overrides choices[] = {{{"z_table_kind", "0"}, {"z_table_index_bits", "8"}},
                                 {{"z_table_kind", "2"}, {"z_table_index_bits", "3"}},
                                 {{"adder_kind", "0"}, {"guard_bits", "4"}},
                                 {{"column_depth", "0"}},
                                 {{"column_depth", "3"}},
                                 {{"dividers", "1"}}};
    for (const Overrides& overrides : choices) {
        const Profile profile = test::profile_with("default", overrides);
        expect_equal(profile, {sweep_draw(profile, false, 2)});
    }
}

TEST(SweepPlatform, WithNormals) {
    const Profile profile = test::profile_with("default", {});
    expect_equal(profile, {sweep_draw(profile, true)});
}

TEST(SweepPlatform, WithFilterLevels) {
    using host::LevelFilter;
    const Profile profile = test::profile_with("default", {});
    expect_equal(
        profile,
        {test::level_draw(profile, LevelFilter::BoxMaximum),
         test::level_draw(profile, LevelFilter::Average, HeightFilter::Average),
         sweep_draw(profile, false, 4), test::level_draw(profile, LevelFilter::Variational),
         test::level_draw(profile, LevelFilter::Variational, HeightFilter::Maximum, kMostFiner)});
    const Profile narrow = test::profile_with("narrow", {});
    expect_equal(narrow, {test::level_draw(narrow, LevelFilter::BoxMaximum)});
}

TEST(SweepPlatform, DirectTrianglesKeepTheirPlace) {
    const Profile profile = test::profile_with("default", {});
    for (const unsigned percent : {10U, 50U, 100U}) {
        expect_equal(profile, {with_direct_ones(sweep_draw(profile, true, 4), percent)});
    }
}

// A device without the displacement unit proper refuses a triangle that needs it.
TEST(SweepPlatform, DirectTrianglesAloneNeedTwoUnits) {
    const Profile profile = test::profile_with("default", {});
    const Draws direct = {with_direct_ones(sweep_draw(profile, true), 100)};
    const DeviceConfig config = test::config_for(profile, direct);
    EXPECT_EQ(elaborated_units(config),
              (std::vector<std::string_view>{"controller", "triangle_buffer"}));
    const Draws mixed = {with_direct_ones(sweep_draw(profile), 80)};
    EXPECT_EXIT(std::exit(test::compare(config, mixed)), testing::ExitedWithCode(2),
                "needs a unit that was not built");
}

// Most of the mesh behind the camera or beside it; direct triangles between clipped ones.
TEST(SweepPlatform, ClippedTrianglesLeaveNoGap) {
    const Profile profile = test::profile_with("default", {});
    host::DrawInputs inputs = test::inputs_for(test::grid(), false);
    inputs.method = host::Method::Sweep;
    inputs.camera.target = {.5, -2, .5};
    inputs.view = host::view_frame(inputs.camera, inputs.viewport);
    const auto draw = host::make_sweep_draw<Fixed>(profile, inputs);
    ASSERT_TRUE(draw.ok());
    shell::PlatformOptions options;
    options.output_capacity = 1;
    expect_equal(profile, {*draw});
    expect_equal(profile, {with_direct_ones(*draw, 30)}, options);
}

TEST(SweepPlatform, OutputBufferOfSevenTrianglesIsDrained) {
    const Profile profile = test::profile_with("default", {});
    shell::PlatformOptions options;
    options.output_capacity = 7;
    expect_equal(profile, {with_direct_ones(sweep_draw(profile, false, 2), 20)}, options);
}

TEST(SweepPlatform, WithoutDmiAndWithAnyQuantum) {
    const Profile profile = test::profile_with("default", {});
    shell::PlatformOptions options;
    options.allow_dmi = false;
    expect_equal(profile, {sweep_draw(profile, true, 2)}, options);
    options.quantum_ns = 0;
    expect_equal(profile, {sweep_draw(profile, true, 2)}, options);
}

TEST(SweepPlatform, FramesOfBothKindsInAnyOrder) {
    const Profile profile = test::profile_with("default", {});
    const shell::Draw sweep = with_direct_ones(sweep_draw(profile, true, 2), 20);
    const shell::Draw coarse = sweep_draw(profile, false, 4);
    const shell::Draw adaptive = adaptive_draw(profile);
    expect_equal(profile, {adaptive, sweep});
    expect_equal(profile, {sweep, adaptive, coarse, adaptive, sweep});
}

TEST(SweepPlatform, UnusedUnitsChangeNothing) {
    const Profile profile = test::profile_with("default", {});
    const Draws draws = {sweep_draw(profile, false, 2)};
    DeviceConfig everything = test::config_for(profile, draws);
    everything.include_everything();
    EXPECT_EXIT(std::exit(test::compare(everything, draws)), testing::ExitedWithCode(0), "");
}

TEST(SweepPlatform, MissingUnitsAreReported) {
    const Profile profile = test::profile_with("default", {});
    const Draws draws = {sweep_draw(profile, true, 4),
                         test::level_draw(profile, host::LevelFilter::Average)};
    for (bool DeviceConfig::*unit : {&DeviceConfig::sweep, &DeviceConfig::bump,
                                     &DeviceConfig::view_clip, &DeviceConfig::levels}) {
        DeviceConfig config = test::config_for(profile, draws);
        config.*unit = false;
        EXPECT_EXIT(std::exit(test::compare(config, draws)), testing::ExitedWithCode(2),
                    "needs a unit that was not built");
    }
}

// What a driver can get wrong, one thing at a time; afterwards the device works as ever.
int bad_frames(const Profile& profile) {
    const SweepDraw<Fixed> good = with_direct_ones(sweep_draw(profile, false, 4), 20);
    using Change = std::function<void(SweepDraw<Fixed>&)>;
    const std::pair<Change, const char*> changes[] = {
        {[](auto& d) { d.registers.setup.guard = 0; }, "a register is out of its range"},
        {[](auto& d) { d.registers.setup.guard = 4097; }, "a register is out of its range"},
        {[](auto& d) { d.registers.setup.z_offset = 8192; }, "a register is out of its range"},
        {[](auto& d) { d.registers.setup.z_offset = -8193; }, "a register is out of its range"},
        {[](auto& d) { d.registers.grid.w_min = 0; }, "a register is out of its range"},
        {[](auto& d) { d.registers.grid.w_min = -1; }, "a register is out of its range"},
        {[](auto& d) { d.registers.grid.w_scale = d.registers.grid.w_min - 1; },
         "a register is out of its range"},
        {[](auto& d) { d.map.width = 0; }, "a register is out of its range"},
        {[](auto& d) { d.map.last_level = 1; }, "a register is out of its range"},
        {[](auto& d) { d.map.finer = 1; }, "a register is out of its range"},
        {[](auto& d) { d.map.filter = HeightFilter::Maximum; }, "needs a unit that was not built"},
        {[](auto& d) { d.triangles[7].vertices[2] = 36; }, "an index names no vertex"},
        {[](auto& d) { d.triangles.back().vertices[0] = 0xffffffff; }, "an index names no vertex"},
        {[](auto& d) { d.triangles[7].max_displacement = -1; },
         "displacement or flags are out of range"},
    };
    const Draws draws = {good};
    auto platform = shell::Platform::create(test::config_for(profile, draws), draws);
    for (const auto& [change, reason] : changes) {
        SweepDraw<Fixed> bad = good;
        change(bad);
        const auto result = platform->run({bad});
        if (result.ok() || result.error().message().find(reason) == std::string::npos) {
            std::fprintf(stderr, "%s: %s\n", reason,
                         result.ok() ? "accepted" : result.error().message().c_str());
            return 1;
        }
    }
    const auto result = platform->run(draws);
    const test::Expected expected = test::bare_loops(profile, draws);
    return result.ok() && test::same(result->outputs[0], expected.outputs[0]) &&
                   test::same_counters(result->counters, expected.counters)
               ? 0
               : 2;
}

TEST(SweepPlatform, BadFramesAreRefusedWithTheirReason) {
    const Profile profile = test::profile_with("default", {});
    EXPECT_EXIT(std::exit(bad_frames(profile)), testing::ExitedWithCode(0), "");
}

// Setup works beside the sweep line, and the pipeline fills once.
TEST(SweepPlatform, TimeOfAFrame) {
    const UnitDesc setup = {"setup", "", {}, {}, 10, 5, 1, 0};
    const UnitDesc sweep = {"sweep", "", {}, {}, 3, 1, 1, 0};
    const auto batch = [](const UnitDesc& unit, uint64_t items) {
        shell::BatchTime time;
        time.stage(unit, items);
        return time;
    };
    shell::StreamTime time;
    EXPECT_EQ(time.inner(batch(sweep, 64)), 64U + 3);
    EXPECT_EQ(time.inner(batch(sweep, 36)), 36U);
    EXPECT_EQ(time.outer(batch(setup, 32)), 60U + 10);  // 160 cycles, of which 100 have passed
    EXPECT_EQ(time.inner(batch(sweep, 200)), 200U);
    EXPECT_EQ(time.outer(batch(setup, 32)), 0U);
    EXPECT_EQ(time.outer(batch(setup, 2)), 10U);  // nothing to sweep: all clipped
    EXPECT_EQ(time.outer(batch(setup, 0)), 0U);
}

}  // namespace
}  // namespace repousse
