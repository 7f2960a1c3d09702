// What simulating costs: the platform at level lt beside the bare loop over the same datapath, on
// the default scene. Each row works on the whole scene and keeps every finished triangle; the
// table is in nanoseconds a triangle.

#include <cstdio>
#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "testbench/bench/best_rounds.h"
#include "testbench/host/draw.h"
#include "testbench/host/scene/assets.h"
#include "tlm/config/profile_reader.h"
#include "tlm/platform/platform.h"

namespace {

using namespace repousse;

constexpr const char* kScene = "scenes/jacksboro.toml";

/// The scene's first object, loaded once for all rows.
struct Workload {
    Profile profile;
    Profile reference;
    std::vector<AdaptiveDraw<Fixed>> fixed;
    std::vector<AdaptiveDraw<Real>> real;
};

Result<Workload> load() {
    const auto scene = host::read_scene(kScene);
    if (!scene) return scene.error();
    const auto profile = shipped_profile(scene->profile);
    if (!profile) return profile.error();
    const host::Object& object = scene->objects.front();
    const auto mesh = host::load_mesh(object);
    if (!mesh) return mesh.error();
    const auto map = host::load_map(object, {});
    if (!map) return map.error();
    host::DrawInputs inputs;
    inputs.mesh = &*mesh;
    inputs.map = &*map;
    inputs.settings = object.adaptive;
    inputs.filter = object.map.filter;
    inputs.uv = object.map.uv;
    inputs.bump = object.bump;
    inputs.texel_size = host::texel_size(*mesh, *map, object.map.uv);
    inputs.view = host::view_frame(scene->camera, scene->viewport);
    Workload work{*profile, host::reference_profile(*profile), {}, {}};
    auto fixed = host::make_draw<Fixed>(work.profile, inputs);
    auto real = host::make_draw<Real>(work.reference, inputs);
    if (!fixed) return fixed.error();
    if (!real) return real.error();
    work.fixed.push_back(std::move(*fixed));
    work.real.push_back(std::move(*real));
    return work;
}

template <class P>
std::vector<OutputTriangle<P>> bare_loop(const Profile& profile, const AdaptiveDraw<P>& draw,
                                         int contexts) {
    std::vector<OutputTriangle<P>> triangles;
    AdaptivePipeline<P> pipeline(profile, draw);
    pipeline.run(
        [&](Span<const OutputTriangle<P>> some) {
            triangles.insert(triangles.end(), some.begin(), some.end());
        },
        contexts);
    return triangles;
}

}  // namespace

int main(int argc, char** argv) {
    const Result<Workload> work = load();
    if (!work) {
        std::fprintf(stderr, "adaptive_bench: %s\n", work.error().message().c_str());
        return 2;
    }
    DeviceConfig config;
    config.profile = work->profile;
    config.include_everything();
    Result<shell::Platform> platform = shell::Platform::create(config, work->fixed);
    if (!platform) return 3;

    constexpr int kBatch = int(kBatchTriangles);
    const auto& draw = work->fixed.front();
    const auto row = [](const char* name, auto function) {
        return bench::Row{name, [function] { benchmark::DoNotOptimize(function()); }};
    };
    const std::vector<bench::Row> rows = {
        row("bare loop, in batches", [&] { return bare_loop(work->profile, draw, kBatch); }),
        row("bare loop, triangle by triangle", [&] { return bare_loop(work->profile, draw, 1); }),
        row("level lt", [&] { return platform->run(work->fixed)->triangles; }),
        row("level ref", [&] { return bare_loop(work->reference, work->real.front(), kBatch); }),
    };
    const double triangles = double(bare_loop(work->profile, draw, kBatch).size());
    std::printf("%s: %.0f triangles\n", kScene, triangles);
    return bench::run_groups(argc, argv, {rows}, "a finished triangle", triangles, 7, 0.2);
}

// SystemC's library asks for it; the platform is elaborated above.
int sc_main(int, char**) { return 0; }
