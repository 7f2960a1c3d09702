#include "testbench/app/run_levels.h"

#include <chrono>

#include "testbench/app/object_draw.h"
#include "tlm/platform/platform.h"

namespace repousse::app {
namespace {

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class P>
void finish(const Job& job, const Profile& profile, const std::vector<ObjectDraw<P>>& draws,
            const std::vector<ObjectOutput<P>>& outputs, bool check, const Progress& progress,
            SimResult& result) {
    for (std::size_t i = 0; i < draws.size(); ++i) {
        if (check) progress("checking " + job.objects[i].object->name);
        result.table_bytes += table_bytes(draws[i]);
        result.objects.push_back(object_result(job, i, profile, draws[i], outputs[i], check));
    }
}

Result<SimResult> run_ref(const Job& job, bool check, const Progress& progress) {
    const Profile profile = host::reference_profile(job.profile);
    const auto draws = make_draws<Real>(job, profile);
    if (!draws) return draws.error();
    SimResult result;
    std::vector<ObjectOutput<Real>> outputs;
    const Stopwatch watch;
    for (const ObjectDraw<Real>& draw : *draws) {
        outputs.push_back(run_bare(profile, draw, result.counters));
    }
    result.tessellation_s = watch.seconds();
    finish(job, profile, *draws, outputs, check, progress, result);
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
    result.counters = run->counters;
    result.cycles = run->cycles;
    result.busy = run->busy;
    result.simulated_ns = run->simulated_ns;
    finish(job, job.profile, *draws, run->outputs, check, progress, result);
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
