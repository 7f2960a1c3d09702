#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "datapath/pipelines/sweep.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/tests/support/profiles.h"

namespace repousse::test {

inline const Profile& default_profile() {
    static const Profile profile = profile_with("default", {});
    return profile;
}

/// An object to be swept in front of a camera of 200 x 160 pixels at (0, -3, 1).
struct SweepObject {
    explicit SweepObject(host::Mesh m) : mesh(std::move(m)) {
        host::FbmSettings fbm;
        fbm.wrap = true;
        map = host::make_fbm_map(64, 64, fbm);
        map.wrap = true;
        map.range_low = -0.05;
        map.range_high = 0.15;
        inputs.method = host::Method::Sweep;
        inputs.filter = HeightFilter::Bilinear;
        inputs.viewport = {200, 160};
        inputs.camera.eye = {0.0, -3.0, 1.0};
        inputs.camera.near = 0.05;
        inputs.bump = true;
    }

    const host::DrawInputs& ready() {
        inputs.mesh = &mesh;
        inputs.map = &map;
        inputs.uv = host::UvSpan::Edges;
        inputs.texel_size = host::texel_size(mesh, map, inputs.uv);
        inputs.view = host::view_frame(inputs.camera, inputs.viewport);
        return inputs;
    }

    template <class P>
    SweepDraw<P> draw(const Profile& profile) {
        auto made = host::make_sweep_draw<P>(profile, ready());
        EXPECT_TRUE(made.ok()) << made.error().message();
        return std::move(*made);
    }

    host::Mesh mesh;
    host::HeightMap map;
    host::DrawInputs inputs;
};

/// Runs a pipeline to its end.
template <class P>
SweepMesh<P> run(SweepPipeline<P>& pipeline) {
    SweepMesh<P> out;
    EXPECT_TRUE(pipeline.run(out));
    return out;
}

/// A draw remeshed, of which everything arrived.
template <class P>
SweepMesh<P> remesh(const Profile& profile, const SweepDraw<P>& draw) {
    SweepPipeline<P> pipeline(profile, draw);
    auto out = run(pipeline);
    const SweepCounters counters = pipeline.counters();
    EXPECT_EQ(counters.triangle_buffer.triangles, out.triangles.size());
    EXPECT_EQ(counters.strip.bad_refs, 0u);
    EXPECT_EQ(counters.sweep_line.displaced, counters.displace.items);
    return out;
}

/// What the judge finds in an object remeshed.
template <class P>
host::SweepInvariants judge(const Profile& profile, SweepObject& object) {
    const SweepDraw<P> draw = object.draw<P>(profile);
    const auto out = remesh(profile, draw);
    EXPECT_FALSE(out.triangles.empty());
    return host::SweepJudge<P>(profile, draw, object.mesh).judge(out);
}

inline void expect_whole(const host::SweepInvariants& found) {
    EXPECT_EQ(found.open_edges, 0u);
    EXPECT_EQ(found.cracked, 0u);
    EXPECT_EQ(found.degenerate, 0u);
    EXPECT_EQ(found.uncovered, 0u);
}

/// A square of 2 x 2 around the origin, facing up.
inline host::Mesh tilted_grid(int quads) {
    host::Mesh mesh = host::make_grid(quads, quads, {2.0, 2.0});
    for (glm::dvec3& p : mesh.positions) p -= glm::dvec3(1.0, 1.0, 0.0);
    return mesh;
}

}  // namespace repousse::test
