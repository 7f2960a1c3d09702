// What simulating sweep-line remeshing costs: the platform at level lt beside the bare loop over
// the same datapath, on scenes with bump mapping, with illumination too, and with neither. Each row
// works on the whole scene and keeps every vertex and triangle; the table is in nanoseconds a fine
// vertex: one that the sweep line makes, and that is displaced.

#include <cstdio>

#include "datapath/pipelines/sweep.h"
#include "testbench/bench/best_rounds.h"
#include "testbench/bench/workload.h"

namespace {

using namespace repousse;

struct Swept {
    std::size_t triangles = 0;
    std::size_t vertices = 0;
};

template <class P, class Draws>
Swept bare_loop(const Profile& profile, const Draws& draws) {
    Swept swept;
    for (const auto& draw : draws) {
        SweepMesh<P> mesh;
        SweepPipeline<P> pipeline(profile, std::get<SweepDraw<P>>(draw));
        pipeline.run(mesh);
        benchmark::DoNotOptimize(&mesh.triangles.back());
        swept.triangles += mesh.triangles.size();
        swept.vertices += pipeline.counters().perspective.items;
    }
    return swept;
}

/// A scene, with the names of its rows.
struct Case {
    const char* scene;
    const char* bare;
    const char* lt;
    const char* ref;
};

constexpr Case kCases[] = {
    {"scenes/head_sweep.toml", "head_sweep, bump/bare loop", "head_sweep, bump/level lt",
     "head_sweep, bump/level ref"},
    {"scenes/head_lit.toml", "head_lit, bump and shade/bare loop",
     "head_lit, bump and shade/level lt", "head_lit, bump and shade/level ref"},
    {"scenes/terrain_sweep.toml", "terrain_sweep/bare loop", "terrain_sweep/level lt",
     "terrain_sweep/level ref"},
};

std::vector<bench::Row> rows_of(const Case& names, const bench::Workload& work,
                                shell::Platform& platform) {
    const Swept swept = bare_loop<Fixed>(work.profile, work.fixed);
    std::printf("%s: %zu fine triangles, %zu fine vertices\n", names.scene, swept.triangles,
                swept.vertices);
    const auto row = [&](const char* name, auto function) {
        return bench::Row{name, [function] { benchmark::DoNotOptimize(function()); },
                          double(swept.vertices)};
    };
    return {
        row(names.bare, [&work] { return bare_loop<Fixed>(work.profile, work.fixed); }),
        row(names.lt, [&work, &platform] { return std::move(platform.run(work.fixed)->outputs); }),
        row(names.ref, [&work] { return bare_loop<Real>(work.reference, work.real); }),
    };
}

}  // namespace

int main(int argc, char** argv) {
    bench::keep_freed_memory();
    std::vector<bench::Workload> works;
    std::vector<shell::Draw> draws;
    for (const Case& names : kCases) {
        Result<bench::Workload> work = bench::load_workload(names.scene, host::Method::Sweep);
        if (!work) {
            std::fprintf(stderr, "sweep_bench: %s\n", work.error().message().c_str());
            return 2;
        }
        draws.insert(draws.end(), work->fixed.begin(), work->fixed.end());
        works.push_back(std::move(*work));
    }
    DeviceConfig config;
    config.profile = works.front().profile;  // all scenes' own
    config.include_everything();
    Result<shell::Platform> platform = shell::Platform::create(config, draws);
    if (!platform) {
        std::fprintf(stderr, "sweep_bench: %s\n", platform.error().message().c_str());
        return 3;
    }
    std::vector<std::vector<bench::Row>> groups;
    for (std::size_t i = 0; i < works.size(); ++i) {
        groups.push_back(rows_of(kCases[i], works[i], *platform));
    }
    return bench::run_groups(argc, argv, groups, "a fine vertex", 1.0, 7, 0.2);
}

// SystemC's library asks for it; the platform is elaborated above.
int sc_main(int, char**) { return 0; }
