// What simulating costs: the platform at level lt beside the bare loop over the same datapath, on
// the default scene. Each row works on the whole scene and keeps every finished triangle; the
// table is in nanoseconds a triangle.

#include <cstdio>
#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "testbench/bench/best_rounds.h"
#include "testbench/bench/workload.h"

namespace {

using namespace repousse;

constexpr const char* kScene = "scenes/jacksboro.toml";

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
    bench::keep_freed_memory();
    const Result<bench::Workload> work = bench::load_workload(kScene, host::Method::Adaptive);
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
    const auto& draw = std::get<AdaptiveDraw<Fixed>>(work->fixed.front());
    const auto& real = std::get<AdaptiveDraw<Real>>(work->real.front());
    const auto row = [](const char* name, auto function) {
        return bench::Row{name, [function] { benchmark::DoNotOptimize(function()); }};
    };
    const std::vector<bench::Row> rows = {
        row("bare loop, in batches", [&] { return bare_loop(work->profile, draw, kBatch); }),
        row("bare loop, triangle by triangle", [&] { return bare_loop(work->profile, draw, 1); }),
        row("level lt", [&] { return std::move(platform->run(work->fixed)->outputs); }),
        row("level ref", [&] { return bare_loop(work->reference, real, kBatch); }),
    };
    const double triangles = double(bare_loop(work->profile, draw, kBatch).size());
    std::printf("%s: %.0f triangles\n", kScene, triangles);
    return bench::run_groups(argc, argv, {rows}, "a finished triangle", triangles, 7, 0.2);
}

// SystemC's library asks for it; the platform is elaborated above.
int sc_main(int, char**) { return 0; }
