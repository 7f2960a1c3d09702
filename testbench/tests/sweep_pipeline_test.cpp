// Sweep-line remeshing as a pipeline: its arithmetic, what becomes of each base triangle, and the
// draw that the host makes of an object. That nothing is left open is in sweep_whole_test.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/tests/support/sweep_object.h"
#include "testbench/tests/support/whole_triangles.h"

namespace repousse {
namespace {

using test::default_profile;
using test::expect_whole;
using test::remesh;
using test::run;
using test::tilted_grid;
using Object = test::SweepObject;

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
