// Clipping on whole objects: what the sweep makes with clipping is what it makes without, less base
// triangles of which no fine triangle can be seen.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "datapath/pipelines/sweep.h"
#include "testbench/cosim/random.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/tests/support/whole_triangles.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using cosim::Random;
using glm::dvec3;
using Triangle = test::WholeTriangle<Fixed>;
using Triangles = std::vector<Triangle>;

double uniform(Random& random, double low, double high) {
    return low + std::ldexp(static_cast<double>(random.next() >> 11), -53) * (high - low);
}

dvec3 direction(Random& random) {
    const double z = uniform(random, -1, 1), turn = uniform(random, 0, 6.283185307);
    return {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
}

Triangles remesh(const Profile& profile, const host::DrawInputs& inputs, SweepCounters& counters) {
    const auto draw = host::make_sweep_draw<Fixed>(profile, inputs);
    EXPECT_TRUE(draw.ok()) << draw.error().message();
    SweepPipeline<Fixed> pipeline(profile, *draw);
    SweepMesh<Fixed> mesh;
    EXPECT_TRUE(pipeline.run(mesh));
    counters = pipeline.counters();
    return test::whole_triangles(mesh);
}

/// Whether a corner, the middle of an edge, or the middle of a triangle is well on the picture:
/// vertices were rounded, so its outermost thousandth does not count.
bool seen(const host::ViewProjection& view, const Format& format, const Triangle& t) {
    std::array<dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3<int32_t>& raw = t.corners[k].displaced;
        p[k] = std::ldexp(1.0, -format.frac) * dvec3(raw.x, raw.y, raw.z);
    }
    const auto inside = [&view](const dvec3& q) {
        const auto apply = [&q](const std::array<double, 4>& row) {
            return row[0] * q.x + row[1] * q.y + row[2] * q.z + row[3];
        };
        const double w = apply(view.w_row);
        return w >= 1.001 * view.near && w <= 0.999 * view.far &&
               std::abs(apply(view.x_row)) <= 0.999 * w && std::abs(apply(view.y_row)) <= 0.999 * w;
    };
    for (std::size_t k = 0; k < 3; ++k) {
        if (inside(p[k]) || inside(0.5 * (p[k] + p[(k + 1) % 3]))) return true;
    }
    return inside((p[0] + p[1] + p[2]) / 3.0);
}

bool same(const Triangle& a, const Triangle& b) {
    bool equal = a.base == b.base;
    for (std::size_t k = 0; k < 3; ++k) {
        equal = equal && a.corners[k].name == b.corners[k].name &&
                a.corners[k].uv == b.corners[k].uv &&
                a.corners[k].displaced == b.corners[k].displaced;
    }
    return equal;
}

class ViewClipMesh : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Profiles, ViewClipMesh, testing::Values("default", "narrow"),
                         [](const auto& profile) { return std::string(profile.param); });

TEST_P(ViewClipMesh, RejectsOnlyWhatCannotBeSeen) {
    const Profile profile = *shipped_profile(GetParam());
    uint64_t triangles = 0, invisible = 0, rejected = 0;
    const std::vector<host::Mesh> meshes = {host::make_icosphere(2, 1.0),
                                            host::make_cylinder(12, 4, 0.5, 1.5)};
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        const host::Mesh& mesh = meshes[m];
        for (uint64_t camera = 0; camera < 30; ++camera) {
            Random random(camera, m);
            host::FbmSettings fbm;
            fbm.wrap = true;
            host::HeightMap map = host::make_fbm_map(32, 32, fbm);
            map.wrap = true;
            // From none to four times the near distance, inwards and outwards.
            map.range_low = -uniform(random, 0, 0.3);
            map.range_high = random.percent(20) ? map.range_low : uniform(random, 0, 0.4);
            host::DrawInputs inputs;
            inputs.mesh = &mesh;
            inputs.map = &map;
            inputs.method = host::Method::Sweep;
            inputs.filter = random.percent(50) ? HeightFilter::Bilinear : HeightFilter::Nearest;
            inputs.viewport = {64, 48};
            inputs.sweep.coarseness_px = 4;
            inputs.sweep.guard_grid = 64;
            inputs.camera.eye =
                uniform(random, 0, random.percent(30) ? 0.5 : 2.5) * direction(random);
            inputs.camera.target = inputs.camera.eye + direction(random);
            inputs.camera.up = direction(random);
            inputs.camera.fov_deg = uniform(random, 20, 120);
            inputs.camera.near = 0.1;
            inputs.camera.far = uniform(random, 1, 10);
            inputs.texel_size = host::texel_size(mesh, map, inputs.uv);
            inputs.view = host::view_frame(inputs.camera, inputs.viewport);

            SweepCounters with, without;
            const Triangles clipped = remesh(profile, inputs, with);
            inputs.sweep.clip = false;
            const Triangles all = remesh(profile, inputs, without);

            const auto view = host::view_projection(inputs.camera, inputs.viewport);
            std::vector<bool> kept(mesh.triangles.size()), visible(mesh.triangles.size());
            for (const auto& t : clipped) kept[t.base] = true;
            for (const auto& t : all) {
                if (!visible[t.base]) visible[t.base] = seen(view, profile.position, t);
            }
            uint64_t missing = 0;
            for (std::size_t base = 0; base < kept.size(); ++base) {
                EXPECT_TRUE(kept[base] || !visible[base]) << "triangle " << base;
                missing += !kept[base];
                invisible += !visible[base];
            }
            triangles += kept.size();
            rejected += missing;
            ASSERT_TRUE(with.view_clip.has_value());
            EXPECT_EQ(with.view_clip->rejected, missing);
            EXPECT_EQ(with.view_clip->items, kept.size());
            // And the rest has not changed.
            std::size_t next = 0;
            for (const auto& t : all) {
                if (!kept[t.base]) continue;
                ASSERT_LT(next, clipped.size());
                ASSERT_TRUE(same(t, clipped[next++]));
            }
            EXPECT_EQ(next, clipped.size());
        }
    }
    EXPECT_GT(double(rejected), 0.6 * double(invisible));
    RecordProperty("triangles", std::to_string(triangles));
    RecordProperty("invisible", std::to_string(invisible));
    RecordProperty("rejected", std::to_string(rejected));
}

}  // namespace
}  // namespace repousse
