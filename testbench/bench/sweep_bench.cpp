// What simulating sweep-line remeshing costs: the platform at level lt beside the bare loop over
// the same datapath. Each row works on the whole scene and keeps every finished triangle; the table
// is in nanoseconds a fine vertex: one that the sweep line makes, and that is displaced.

#include <cstdio>

#include "datapath/pipelines/sweep.h"
#include "testbench/bench/best_rounds.h"
#include "testbench/bench/workload.h"

namespace {

using namespace repousse;

constexpr const char* kScene = "scenes/head_sweep.toml";

struct Swept {
    std::size_t triangles = 0;
    std::size_t vertices = 0;
};

template <class P, class Draws>
Swept bare_loop(const Profile& profile, const Draws& draws) {
    Swept swept;
    for (const auto& draw : draws) {
        std::vector<SweepOutput<P>> triangles;
        SweepPipeline<P> pipeline(profile, std::get<SweepDraw<P>>(draw));
        pipeline.run([&](Span<const SweepOutput<P>> some) {
            triangles.insert(triangles.end(), some.begin(), some.end());
        });
        benchmark::DoNotOptimize(triangles.data());
        swept.triangles += triangles.size();
        swept.vertices += pipeline.counters().perspective.items;
    }
    return swept;
}

}  // namespace

int main(int argc, char** argv) {
    bench::keep_freed_memory();
    const Result<bench::Workload> work = bench::load_workload(kScene);
    if (!work) {
        std::fprintf(stderr, "sweep_bench: %s\n", work.error().message().c_str());
        return 2;
    }
    DeviceConfig config;
    config.profile = work->profile;
    config.include_everything();
    Result<shell::Platform> platform = shell::Platform::create(config, work->fixed);
    if (!platform) {
        std::fprintf(stderr, "sweep_bench: %s\n", platform.error().message().c_str());
        return 3;
    }
    const auto row = [](const char* name, auto function) {
        return bench::Row{name, [function] { benchmark::DoNotOptimize(function()); }};
    };
    const std::vector<bench::Row> rows = {
        row("bare loop", [&] { return bare_loop<Fixed>(work->profile, work->fixed); }),
        row("level lt", [&] { return std::move(platform->run(work->fixed)->outputs); }),
        row("level ref", [&] { return bare_loop<Real>(work->reference, work->real); }),
    };
    const Swept swept = bare_loop<Fixed>(work->profile, work->fixed);
    std::printf("%s: %zu fine triangles, %zu fine vertices\n", kScene, swept.triangles,
                swept.vertices);
    return bench::run_groups(argc, argv, {rows}, "a fine vertex", double(swept.vertices), 7, 0.2);
}

// SystemC's library asks for it; the platform is elaborated above.
int sc_main(int, char**) { return 0; }
