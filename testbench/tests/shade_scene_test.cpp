// The colours of a whole scene: every unit between the base mesh and the colour rounds, and what is
// left of it shows against level `ref`, which is Phong's formula in doubles.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "testbench/host/draw.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/shade_registers.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

/// An object of the scene with its files read.
struct Loaded {
    host::Scene scene;
    host::Mesh mesh;
    host::HeightMap map;
    host::DrawInputs inputs;

    explicit Loaded(std::size_t object) {
        scene = *host::read_scene("scenes/head_lit_small.toml");
        mesh = *host::load_mesh(scene.objects[object]);
        map = *host::load_map(scene.objects[object], {});
        inputs = host::draw_inputs(scene, scene.objects[object], mesh, map);
    }
};

/// A vertex that leaves: its colour and whether a light grazes it, where a highlight ends abruptly
/// (told by N', so of bumped surfaces only).
struct Seen {
    glm::dvec3 colour;
    bool grazed = false;
};

template <class P>
bool grazed(const Vec3<typename P::Value>& normal, const Profile& profile,
            const host::DrawInputs& inputs) {
    if (!inputs.bump) return false;
    const int frac = std::is_same_v<P, Real> ? 0 : profile.displaced_normal.frac;
    const glm::dvec3 n(std::ldexp(double(normal.x), -frac), std::ldexp(double(normal.y), -frac),
                       std::ldexp(double(normal.z), -frac));
    return std::any_of(inputs.lights.begin(), inputs.lights.end(), [&](const host::Light& light) {
        return std::abs(glm::dot(n, light.direction)) < 0.004;
    });
}

// Both levels walk the same midpoints, so vertices are the same where their coordinates are.
using Place = std::tuple<int32_t, int32_t>;

template <class P>
std::map<Place, Seen> adaptive_colours(const Profile& profile, const host::DrawInputs& inputs) {
    const auto draw = host::make_draw<P>(profile, inputs);
    EXPECT_TRUE(draw.ok());
    std::map<Place, Seen> seen;
    std::size_t differing = 0;
    AdaptivePipeline<P> pipeline(profile, *draw);
    pipeline.run([&](Span<const OutputTriangle<P>> triangles) {
        for (const OutputTriangle<P>& triangle : triangles) {
            for (const OutputVertex<P>& v : triangle.corners) {
                const glm::dvec3 colour = host::linear_light<P>(v.colour, profile);
                const bool at_the_edge = grazed<P>(v.displaced_normal, profile, inputs);
                const auto [at, is_new] =
                    seen.emplace(Place{v.uv.x, v.uv.y}, Seen{colour, at_the_edge});
                differing += !is_new && at->second.colour != colour;
            }
        }
    });
    EXPECT_EQ(differing, 0u);  // the same vertex has the same bits, whichever triangle it is in
    const ShadeCounters counted = *pipeline.counters().shade;
    EXPECT_GE(counted.items, seen.size());
    EXPECT_EQ(counted.degenerate, 0u);
    return seen;
}

// Both levels walk the same grid: a vertex is its base triangle and its name.
using Name = std::tuple<uint32_t, int, int, int, int>;

template <class P>
std::map<Name, Seen> swept_colours(const Profile& profile, const host::DrawInputs& inputs) {
    const auto draw = host::make_sweep_draw<P>(profile, inputs);
    EXPECT_TRUE(draw.ok());
    SweepMesh<P> mesh;
    SweepPipeline<P> pipeline(profile, *draw);
    EXPECT_TRUE(pipeline.run(mesh));
    std::map<Name, Seen> seen;
    for (const FineTriangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const SweepOutputVertex<P>& v = mesh.corner(triangle, k);
            const Name name(triangle.base, int(v.name.kind), v.name.part, v.name.a, v.name.b);
            seen[name] = {host::linear_light<P>(v.colour, profile),
                          grazed<P>(v.displaced_normal, profile, inputs)};
        }
    }
    // Of one name, of one place and colour, also across base edges.
    EXPECT_EQ(host::SweepJudge<P>(profile, *draw, *inputs.mesh).judge(mesh).cracked, 0u);
    EXPECT_EQ(pipeline.counters().shade->items, mesh.vertices.size());
    return seen;
}

template <class Key>
void compare(const char* what, const std::map<Key, Seen>& ref, const std::map<Key, Seen>& fixed) {
    std::size_t common = 0, visible = 0;
    double worst = 0, squares = 0;
    for (const auto& [key, exact] : ref) {
        const auto found = fixed.find(key);
        if (found == fixed.end() || exact.grazed || found->second.grazed) continue;
        const glm::dvec3 off = glm::abs(found->second.colour - exact.colour);
        const double most = std::max({off.x, off.y, off.z});
        ++common;
        visible += most > 1.0 / 255;
        worst = std::max(worst, most);
        squares += glm::dot(off, off) / 3;
    }
    const double rms = std::sqrt(squares / double(common));
    std::printf("%s: %zu of %zu vertices compared: rms %.5f, worst %.4f, %zu beyond 1/255\n", what,
                common, ref.size(), rms, worst, visible);
    EXPECT_GT(common, ref.size() / 2);
    EXPECT_LT(rms, 0.001);
}

TEST(ShadedScene, AdaptiveColoursAreThoseOfLevelRef) {
    const Loaded loaded(0);
    const Profile profile = test::profile_with("default", {});
    for (const bool bump : {true, false}) {
        host::DrawInputs inputs = loaded.inputs;
        inputs.bump = bump;
        if (!bump) inputs.settings.normal_threshold.reset();
        compare(bump ? "tessellated, bump" : "tessellated, base normals",
                adaptive_colours<Real>(host::reference_profile(profile), inputs),
                adaptive_colours<Fixed>(profile, inputs));
    }
}

TEST(ShadedScene, SweptColoursAreThoseOfLevelRef) {
    const Loaded loaded(1);
    const Profile profile = test::profile_with("default", {});
    for (const bool bump : {true, false}) {
        host::DrawInputs inputs = loaded.inputs;
        inputs.bump = bump;
        compare(bump ? "swept, bump" : "swept, base normals",
                swept_colours<Real>(host::reference_profile(profile), inputs),
                swept_colours<Fixed>(profile, inputs));
    }
}

}  // namespace
}  // namespace repousse
