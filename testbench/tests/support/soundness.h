#pragma once

#include <gtest/gtest.h>

#include <string>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/adaptive_run.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/reference_input.h"

namespace repousse::test {

/// A run and what `check_leaves` says of it.
struct Outcome {
    AdaptiveRun run;
    reference::LeafReport report;
};

/// Tessellates an object at the level that the policy stands for. `view` replaces the camera.
template <class P>
Outcome tessellate(const Profile& profile, const Object& object, int contexts = 64,
                   const host::ViewFrame& view = {}) {
    host::DrawInputs in = object.inputs();
    in.view = view;
    const auto draw = host::make_draw<P>(profile, in);
    Outcome outcome;
    if (!draw) {
        ADD_FAILURE() << draw.error().message();
        return outcome;
    }
    outcome.run = run_adaptive(profile, *draw, contexts);
    outcome.report = reference::check_leaves(outcome.run.leaves, outcome.run.base);
    const int cap = draw->registers.cap;
    EXPECT_TRUE(outcome.run.fits);
    if (object.settings.order == host::StackOrder::Lifo) {
        EXPECT_LE(outcome.run.counters.stack_peak, 9u * unsigned(cap) + 1);
    }
    return outcome;
}

/// What must hold of every tessellation up to the natural generation cap.
inline void expect_sound(const Outcome& outcome, const std::string& what) {
    EXPECT_EQ(outcome.report.open_edges, 0u) << what;
    EXPECT_EQ(outcome.report.flipped, 0u) << what;
    EXPECT_EQ(outcome.report.zero_area, 0u) << what;
    EXPECT_GE(outcome.report.triangles, outcome.run.base.size()) << what;
    EXPECT_EQ(outcome.run.counters.displace.overflows, 0u) << what;
    EXPECT_EQ(outcome.run.counters.mid_vertex.overflows, 0u) << what;
    EXPECT_EQ(outcome.run.counters.mid_vertex.degenerate, 0u) << what;
}

/// A shipped profile with another number of UV fraction bits.
inline Profile profile_with_uv(const std::string& shipped, int frac) {
    const std::string integers = shipped == "narrow" ? "s11." : "s14.";
    return profile_with(shipped, {{"uv", integers + std::to_string(frac)}});
}

/// The paper's figure 10: a half donut on 18 triangles.
inline Object donut(int texels = 256) {
    Object object;
    object.mesh = host::make_grid(3, 3);
    object.map = host::make_donut_map(texels, texels);
    object.settings.normal_threshold = 0.2;
    object.settings.height_threshold = 4096;
    return object;
}

/// A column of 12 x 4 quads wrapped in a periodic map whose sides are no powers of two.
inline Object column() {
    Object object;
    object.mesh = host::make_cylinder(12, 4, 1.0, 2.0);
    host::FbmSettings fbm;
    fbm.seed = 11;
    fbm.wrap = true;
    object.map = host::make_fbm_map(200, 90, fbm);
    object.map.range_low = -0.1;
    object.map.range_high = 0.2;
    object.settings.normal_threshold = 0.3;
    object.settings.height_threshold = 1500;
    return object;
}

/// A square part of the Jacksboro elevation file on 4 x 4 quads, or the relief that stands in.
inline Object jacksboro(int texels = 128) {
    Object object;
    object.mesh = host::make_grid(4, 4);
    object.map = jacksboro_relief(70, 44, texels, texels).map;
    object.map.range_high = 0.1;
    object.settings.normal_threshold = 0.4;
    object.settings.height_threshold = 2048;
    return object;
}

}  // namespace repousse::test
