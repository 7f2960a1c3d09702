#include "testbench/app/run_levels.h"

#include <chrono>

#include "datapath/pipelines/adaptive.h"
#include "testbench/host/leaves.h"
#include "testbench/host/surface.h"
#include "tlm/platform/platform.h"

namespace repousse::app {
namespace {

template <class P>
using Triangles = std::vector<OutputTriangle<P>>;

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class P>
Triangles<P> tessellate(AdaptivePipeline<P>& pipeline) {
    Triangles<P> triangles;
    pipeline.run([&](Span<const OutputTriangle<P>> some) {
        triangles.insert(triangles.end(), some.begin(), some.end());
    });
    return triangles;
}

// The displaced base mesh is what a generation cap of 0 leaves.
template <class P>
reference::LeafReport judge(const Profile& profile, AdaptiveDraw<P> draw,
                            const Triangles<P>& triangles) {
    draw.registers.cap = 0;
    AdaptivePipeline<P> base(profile, draw);
    return reference::check_leaves(host::leaves_of<P>(triangles, profile),
                                   host::leaves_of<P>(tessellate(base), profile));
}

template <class P>
uint64_t bytes_of(const MapTables<P>& tables) {
    return tables.heights.size() * sizeof(uint16_t) +
           tables.normals.size() * sizeof(Vec3<typename P::Texel>) +
           tables.sums.size() * sizeof(uint64_t);
}

template <class P>
Result<std::vector<AdaptiveDraw<P>>> make_draws(const Job& job, const Profile& profile) {
    std::vector<AdaptiveDraw<P>> draws;
    for (std::size_t i = 0; i < job.objects.size(); ++i) {
        auto draw = host::make_draw<P>(profile, job.inputs(i));
        if (!draw) {
            Error error = draw.error();
            error.where = job.objects[i].object->mark.text();
            error.what = "object \"" + job.objects[i].object->name + "\": " + error.what;
            return error;
        }
        draws.push_back(std::move(*draw));
    }
    return draws;
}

template <class P>
void finish(const Job& job, const Profile& profile, const std::vector<AdaptiveDraw<P>>& draws,
            const std::vector<Triangles<P>>& triangles, bool check, const Progress& progress,
            SimResult& result) {
    for (std::size_t i = 0; i < draws.size(); ++i) {
        ObjectResult object;
        object.base_triangles = draws[i].triangles.size();
        object.cap = draws[i].registers.cap;
        object.surface = host::surface_mesh(triangles[i], profile, job.inputs(i));
        result.table_bytes += bytes_of(draws[i].tables);
        if (check) {
            progress("checking " + job.objects[i].object->name);
            object.invariants = judge(profile, draws[i], triangles[i]);
        }
        result.objects.push_back(std::move(object));
    }
}

Result<SimResult> run_ref(const Job& job, bool check, const Progress& progress) {
    const Profile profile = host::reference_profile(job.profile);
    const auto draws = make_draws<Real>(job, profile);
    if (!draws) return draws.error();
    SimResult result;
    std::vector<Triangles<Real>> triangles;
    const Stopwatch watch;
    for (const AdaptiveDraw<Real>& draw : *draws) {
        AdaptivePipeline<Real> pipeline(profile, draw);
        triangles.push_back(tessellate(pipeline));
        merge_rows(result.counters, pipeline.counters().rows());
    }
    result.tessellation_s = watch.seconds();
    finish(job, profile, *draws, triangles, check, progress, result);
    return result;
}

Result<SimResult> run_lt(const Job& job, bool check, const Progress& progress) {
    const auto draws = make_draws<Fixed>(job, job.profile);
    if (!draws) return draws.error();
    Result<shell::Platform> platform = shell::Platform::create(job.device, *draws);
    if (!platform) return platform.error();
    const Stopwatch watch;
    const auto run = platform->run(*draws);
    if (!run) return run.error();
    SimResult result;
    result.tessellation_s = watch.seconds();
    result.counters = run->counters.rows();
    result.cycles = run->cycles;
    result.busy = run->busy;
    result.simulated_ns = run->simulated_ns;
    finish(job, job.profile, *draws, run->triangles, check, progress, result);
    return result;
}

}  // namespace

const char* level_name(Level level) { return level == Level::Ref ? "ref" : "lt"; }

Result<Level> parse_level(const std::string& text) {
    if (text == "ref") return Level::Ref;
    if (text == "lt") return Level::Lt;
    const std::string level = text.substr(0, text.find(','));
    const bool known =
        level == "at" || level == "rtl" || level == "shadow" || level == "device-rtl";
    const bool has_override = level.size() != text.size();
    return Error{ErrorKind::Input,
                 "--level",
                 "\"" + text + "\" is " + (known || has_override ? "not built yet" : "not a level"),
                 "ref or lt",
                 {}};
}

Result<SimResult> run_level(const Job& job, Level level, bool check, const Progress& progress) {
    progress(std::string("tessellating at level ") + level_name(level));
    return level == Level::Ref ? run_ref(job, check, progress) : run_lt(job, check, progress);
}

}  // namespace repousse::app
