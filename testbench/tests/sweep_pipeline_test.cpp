// Sweep-line remeshing as a whole: from an object to fine triangles.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "datapath/pipelines/sweep.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/whole_triangles.h"

namespace repousse {
namespace {

const Profile& default_profile() {
    static const Profile profile = test::profile_with("default", {});
    return profile;
}

/// An object in front of a camera of 200 x 160 pixels at (0, -3, 1).
struct Object {
    explicit Object(host::Mesh m) : mesh(std::move(m)) {
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

template <class P>
SweepMesh<P> run(SweepPipeline<P>& pipeline) {
    SweepMesh<P> out;
    EXPECT_TRUE(pipeline.run(out));
    return out;
}

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

template <class P>
host::SweepInvariants judge(const Profile& profile, Object& object) {
    const SweepDraw<P> draw = object.draw<P>(profile);
    const auto out = remesh(profile, draw);
    EXPECT_FALSE(out.triangles.empty());
    return host::SweepJudge<P>(profile, draw, object.mesh).judge(out);
}

void expect_whole(const host::SweepInvariants& found) {
    EXPECT_EQ(found.open_edges, 0u);
    EXPECT_EQ(found.cracked, 0u);
    EXPECT_EQ(found.degenerate, 0u);
    EXPECT_EQ(found.uncovered, 0u);
}

host::Mesh tilted_grid(int quads) {
    host::Mesh mesh = host::make_grid(quads, quads, {2.0, 2.0});
    for (glm::dvec3& p : mesh.positions) p -= glm::dvec3(1.0, 1.0, 0.0);
    return mesh;
}

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

// A judge that never says no is none.
TEST(SweepJudge, SeesWhatIsBroken) {
    Object object(host::make_icosphere(1, 1.0));
    const SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    const auto good = remesh(default_profile(), draw);
    host::SweepJudge<Fixed> judge(default_profile(), draw, object.mesh);
    expect_whole(judge.judge(good));

    auto hole = good;
    hole.triangles.erase(hole.triangles.begin() + 700);
    EXPECT_EQ(judge.judge(hole).open_edges, 3u);
    EXPECT_EQ(judge.judge(hole).uncovered, 1u);

    auto twice = good;
    twice.triangles.insert(twice.triangles.begin() + 700, good.triangles[700]);
    EXPECT_GE(judge.judge(twice).open_edges, 3u);
    EXPECT_EQ(judge.judge(twice).uncovered, 1u);

    auto moved = good;
    moved.vertices.push_back(moved.corner(moved.triangles[700], 1));
    ++moved.vertices.back().displaced.y;
    moved.triangles[700].vertices[1] = static_cast<uint32_t>(moved.vertices.size() - 1);
    EXPECT_EQ(judge.judge(moved).cracked, 1u);

    auto turned = good;
    std::swap(turned.triangles[700].vertices[0], turned.triangles[700].vertices[1]);
    EXPECT_EQ(judge.judge(turned).degenerate, 1u);
}

// Bit-accurate arithmetic against doubles in closed form, vertex by vertex.
TEST(SweepPipeline, FixedFollowsReal) {
    const Profile profile = default_profile();
    const Profile real = host::reference_profile(profile);
    Object object(tilted_grid(3));
    const auto fixed_out = test::whole_triangles(remesh(profile, object.draw<Fixed>(profile)));
    const auto real_out = test::whole_triangles(remesh(real, object.draw<Real>(real)));
    ASSERT_EQ(fixed_out.size(), real_out.size());
    ASSERT_GT(fixed_out.size(), 5000u);
    double worst_place = 0, worst_normal = 0;
    for (std::size_t i = 0; i < fixed_out.size(); ++i) {
        ASSERT_EQ(fixed_out[i].base, real_out[i].base);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& f = fixed_out[i].corners[k];
            const auto& r = real_out[i].corners[k];
            ASSERT_TRUE(f.name == r.name);
            const double lsb = std::ldexp(1.0, -profile.position.frac);
            for (const double d :
                 {f.displaced.x * lsb - r.displaced.x, f.displaced.y * lsb - r.displaced.y,
                  f.displaced.z * lsb - r.displaced.z}) {
                worst_place = std::max(worst_place, std::fabs(d));
            }
            const double unit = std::ldexp(1.0, -profile.displaced_normal.frac);
            if (f.uv == r.uv) {  // the same texel of the normal map
                worst_normal = std::max(
                    worst_normal, std::fabs(f.displaced_normal.z * unit - r.displaced_normal.z));
            }
        }
    }
    // A step of 2^-8 texels moves the height by 2^-8 of the steepest slope, 0.02 a texel.
    EXPECT_LT(worst_place, 3e-4);
    EXPECT_LT(worst_normal, 2e-3);
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

TEST(SweepPipeline, CoarserGridsHaveFewerTriangles) {
    Object object(tilted_grid(1));
    std::size_t last = 0;
    for (const double px : {16.0, 8.0, 4.0, 2.0, 1.0}) {
        object.inputs.sweep.coarseness_px = px;
        const auto out = remesh(default_profile(), object.draw<Fixed>(default_profile()));
        if (last != 0) {
            EXPECT_NEAR(double(out.triangles.size()) / double(last), 4.0, 1.0) << px;
        }
        last = out.triangles.size();
    }
}

TEST(SweepPipeline, DirectTrianglesKeepTheirPlace) {
    const Profile profile = default_profile();
    Object object(tilted_grid(4));
    SweepDraw<Fixed> draw = object.draw<Fixed>(profile);
    const auto all = test::whole_triangles(remesh(profile, draw));
    for (std::size_t i = 0; i < draw.triangles.size(); i += 3) draw.triangles[i].direct = true;
    const auto mixed = test::whole_triangles(remesh(profile, draw));
    std::size_t at = 0;
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        const auto& out = mixed[i];
        ASSERT_TRUE(i == 0 || mixed[i - 1].base <= out.base);
        if (draw.triangles[out.base].direct) {
            ASSERT_TRUE(i == 0 || mixed[i - 1].base < out.base);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vertex<Fixed>& vertex = draw.vertices[draw.triangles[out.base].vertices[k]];
                EXPECT_EQ(out.corners[k].displaced, vertex.position);
                EXPECT_EQ(out.corners[k].uv, vertex.uv);
            }
            continue;
        }
        while (all[at].base < out.base) ++at;
        ASSERT_EQ(all[at].base, out.base);
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_EQ(all[at].corners[k].displaced, out.corners[k].displaced);
        }
        ++at;
    }
}

TEST(SweepPipeline, AnObjectOfMethodDirectPassesWhole) {
    const Profile profile = default_profile();
    Object object(tilted_grid(4));
    object.inputs.method = host::Method::Direct;
    const SweepDraw<Fixed> draw = object.draw<Fixed>(profile);
    const auto out = remesh(profile, draw);
    EXPECT_EQ(out.triangles.size(), 32u);
    EXPECT_EQ(out.vertices.size(), 96u);
    expect_whole(host::SweepJudge<Fixed>(profile, draw, object.mesh).judge(out));
}

// Each vertex is brought to the grid once, however many triangles it has.
TEST(SweepPipeline, TransformsEachVertexOnce) {
    Object object(tilted_grid(4));
    const SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    SweepPipeline<Fixed> pipeline(default_profile(), draw);
    run(pipeline);
    EXPECT_EQ(pipeline.counters().vertex_transform.items, 25u);
    EXPECT_EQ(pipeline.counters().grid_transform.items, 25u);
    EXPECT_EQ(pipeline.counters().triangle_setup.items, 32u);
}

TEST(SweepPipeline, AVertexThatIsNotThereEndsTheDraw) {
    Object object(tilted_grid(2));
    SweepDraw<Fixed> draw = object.draw<Fixed>(default_profile());
    draw.triangles[3].vertices[1] = 9;
    SweepPipeline<Fixed> pipeline(default_profile(), draw);
    uint32_t last = 0;
    SweepMesh<Fixed> mesh;
    EXPECT_FALSE(pipeline.run(mesh));
    for (const FineTriangle& triangle : mesh.triangles) last = triangle.base;
    EXPECT_EQ(last, 2u);
}

TEST(SweepDraw, RefusesWhatDoesNotFit) {
    Object object(tilted_grid(2));
    EXPECT_NE(host::make_sweep_draw<Fixed>(test::profile_with("narrow", {}), object.ready())
                  .error()
                  .message()
                  .find("13"),
              std::string::npos);
    object.inputs.bump = false;
    EXPECT_TRUE(
        host::make_sweep_draw<Fixed>(test::profile_with("narrow", {}), object.ready()).ok());
    object.mesh.positions[0].x = 1e5;
    EXPECT_NE(host::make_sweep_draw<Fixed>(default_profile(), object.ready())
                  .error()
                  .message()
                  .find("does not fit"),
              std::string::npos);
}

// c fills its format up to 1 at the nearest vertex, and depths lie on both sides of 0.
TEST(SweepDraw, FitsTheGridToTheObject) {
    Object object(tilted_grid(2));
    const SweepDraw<Real> draw = object.draw<Real>(host::reference_profile(default_profile()));
    SweepPipeline<Real> pipeline(default_profile(), draw);
    SweepMesh<Real> mesh;
    EXPECT_TRUE(pipeline.run(mesh));
    EXPECT_EQ(pipeline.counters().grid_transform.c_saturated, 0u);
    const double offset = draw.registers.setup.z_offset;
    const auto depth = [&](double w) {
        return draw.registers.grid.steps_per_octave *
               (std::log2(w) - draw.registers.grid.log2_near);
    };
    double least = 1e9, greatest = 0;
    for (const glm::dvec3& p : object.mesh.positions) {
        const double w = glm::dot(p - object.inputs.view.eye, object.inputs.view.forward);
        least = std::min(least, w);
        greatest = std::max(greatest, w);
    }
    EXPECT_DOUBLE_EQ(draw.registers.grid.w_scale, least);
    EXPECT_NEAR(depth(least) - offset, -(depth(greatest) - offset), 1.01);
}

}  // namespace
}  // namespace repousse
