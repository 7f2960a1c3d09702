// Sweep-line remeshing of whole objects leaves no hole: meshes of every kind, seams, the eye
// inside, clipped parts, large triangles, filter levels; and a judge that sees what is broken.
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "testbench/tests/support/sweep_object.h"

namespace repousse {
namespace {

using test::default_profile;
using test::expect_whole;
using test::judge;
using test::remesh;
using test::run;
using test::tilted_grid;
using Object = test::SweepObject;

TEST(SweepPipeline, IsWholeOnEveryMesh) {
    const Profile profile = default_profile();
    const Profile real = host::reference_profile(profile);
    for (const host::Mesh& mesh :
         {tilted_grid(1), tilted_grid(5), host::make_cylinder(8, 2, 0.5, 1.5),
          host::make_cylinder(40, 20, 0.5, 1.5), host::make_icosphere(0, 1.0)}) {
        Object object(mesh);
        expect_whole(judge<Fixed>(profile, object));
        expect_whole(judge<Real>(real, object));
    }
}

// The cylinder's map turns once: both sides of the seam read the same texels.
TEST(SweepPipeline, ASeamOfAPeriodicMapIsClosed) {
    Object object(host::make_cylinder(8, 2, 0.5, 1.5));
    EXPECT_EQ(judge<Fixed>(default_profile(), object).seam_cracked, 0u);
    object.map.wrap = false;
    EXPECT_GT(judge<Fixed>(default_profile(), object).seam_cracked, 0u);
}

TEST(SweepPipeline, IsWholeWithTheEyeInside) {
    Object object(host::make_icosphere(1, 1.0));
    object.inputs.camera.eye = {0.2, -0.1, 0.1};
    object.inputs.camera.target = {1.0, 0.2, 0.0};
    object.inputs.sweep.guard_grid = 80;
    object.inputs.sweep.clip = false;
    expect_whole(judge<Fixed>(default_profile(), object));
}

// What is clipped away has no neighbours to open.
TEST(SweepPipeline, IsWholeWherePartIsClipped) {
    Object object(tilted_grid(16));
    object.inputs.camera.fov_deg = 12.0;
    expect_whole(judge<Fixed>(default_profile(), object));
    const SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    SweepPipeline<Fixed> pipeline(default_profile(), draw);
    run(pipeline);
    EXPECT_GT(pipeline.counters().view_clip->rejected, 100u);
    EXPECT_EQ(pipeline.counters().view_clip->items, 512u);
    EXPECT_EQ(pipeline.counters().triangle_buffer.empty, pipeline.counters().view_clip->rejected);
}

// A triangle with many times the vertices that are kept at once, and columns above the FIFO.
TEST(SweepPipeline, IsWholeOnALargeTriangle) {
    Object object(tilted_grid(1));
    object.inputs.viewport = {640, 480};
    const SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    const auto out = remesh(default_profile(), draw);
    EXPECT_GT(out.triangles.size(), 50000u);
    expect_whole(host::SweepJudge<Fixed>(default_profile(), draw, object.mesh).judge(out));
}

// Kinds of adder differ in data alone: plain ones crack, and the judge sees it.
TEST(SweepPipeline, PlainAddersCrack) {
    Object object(host::make_icosphere(2, 1.0));
    for (const int kind : {0, 1, 2}) {
        Profile profile = default_profile();
        profile.adder_kind = kind;
        const host::SweepInvariants found = judge<Fixed>(profile, object);
        EXPECT_EQ(found.open_edges, 0u) << kind;
        EXPECT_EQ(found.uncovered, 0u) << kind;
        if (kind == 0) {
            EXPECT_GT(found.cracked, 100u);
        } else {
            EXPECT_EQ(found.cracked, 0u) << kind;
        }
    }
}

// Filter levels: whole at both levels of detail, which choose the same level but for rounding at
// its border.
TEST(SweepPipeline, IsWholeWithFilterLevels) {
    const Profile profile = default_profile();
    const Profile real = host::reference_profile(profile);
    for (const host::LevelFilter levels :
         {host::LevelFilter::BoxMaximum, host::LevelFilter::Average}) {
        Object object(tilted_grid(5));
        object.inputs.bump = false;
        object.inputs.levels = levels;
        object.inputs.filter = HeightFilter::Maximum;
        object.inputs.sweep.coarseness_px = 3;
        expect_whole(judge<Fixed>(profile, object));
        expect_whole(judge<Real>(real, object));
        const auto fixed_draw = object.draw<Fixed>(profile);
        const auto real_draw = object.draw<Real>(real);
        SweepPipeline<Fixed> fixed_pipeline(profile, fixed_draw);
        SweepPipeline<Real> real_pipeline(real, real_draw);
        const auto fixed_mesh = run(fixed_pipeline);
        const auto real_mesh = run(real_pipeline);
        ASSERT_EQ(fixed_mesh.vertices.size(), real_mesh.vertices.size());
        const FootprintCounters f = *fixed_pipeline.counters().footprint;
        const FootprintCounters r = *real_pipeline.counters().footprint;
        EXPECT_EQ(f.items, r.items);
        EXPECT_EQ(f.cut, 0u);
        uint64_t moved = 0;
        std::size_t used = 0;
        for (std::size_t l = 0; l < f.levels.size(); ++l) {
            moved += std::max(f.levels[l], r.levels[l]) - std::min(f.levels[l], r.levels[l]);
            used += f.levels[l] > f.items / 100;
        }
        EXPECT_GE(used, 3u);
        EXPECT_LT(moved, f.items / 100);
    }
}

/// A mesh taken apart, so that something in it can be broken.
struct Parts {
    explicit Parts(const SweepMesh<Fixed>& mesh) {
        for (const auto& vertex : mesh.vertices) vertices.push_back(vertex);
        for (const FineTriangle& triangle : mesh.triangles) triangles.push_back(triangle);
    }
    SweepMesh<Fixed> mesh() const {
        SweepMesh<Fixed> mesh;
        mesh.append(Span<const SweepOutputVertex<Fixed>>(vertices));
        mesh.append(Span<const FineTriangle>(triangles));
        return mesh;
    }

    std::vector<SweepOutputVertex<Fixed>> vertices;
    std::vector<FineTriangle> triangles;
};

// A judge that never says no is none.
TEST(SweepJudge, SeesWhatIsBroken) {
    Object object(host::make_icosphere(1, 1.0));
    const SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    const Parts good(remesh(default_profile(), draw));
    host::SweepJudge<Fixed> judge(default_profile(), draw, object.mesh);
    expect_whole(judge.judge(good.mesh()));

    Parts hole = good;
    hole.triangles.erase(hole.triangles.begin() + 700);
    EXPECT_EQ(judge.judge(hole.mesh()).open_edges, 3u);
    EXPECT_EQ(judge.judge(hole.mesh()).uncovered, 1u);

    Parts twice = good;
    twice.triangles.insert(twice.triangles.begin() + 700, good.triangles[700]);
    EXPECT_GE(judge.judge(twice.mesh()).open_edges, 3u);
    EXPECT_EQ(judge.judge(twice.mesh()).uncovered, 1u);

    Parts moved = good;
    moved.vertices.push_back(moved.vertices[moved.triangles[700].vertices[1]]);
    ++moved.vertices.back().displaced.y;
    moved.triangles[700].vertices[1] = static_cast<uint32_t>(moved.vertices.size() - 1);
    EXPECT_EQ(judge.judge(moved.mesh()).cracked, 1u);

    Parts turned = good;
    std::swap(turned.triangles[700].vertices[0], turned.triangles[700].vertices[1]);
    EXPECT_EQ(judge.judge(turned.mesh()).degenerate, 1u);
}

}  // namespace
}  // namespace repousse
