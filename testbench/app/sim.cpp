// repousse sim: a scene through the hardware, to a picture, a mesh and a report.

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "testbench/app/commands.h"
#include "testbench/app/job.h"
#include "testbench/app/report.h"
#include "testbench/app/run_levels.h"
#include "testbench/host/files.h"
#include "testbench/host/image/picture_file.h"
#include "testbench/host/mesh/ply_writer.h"
#include "testbench/host/surface.h"
#include "testbench/host/view/render.h"

namespace repousse::app {
namespace {

struct SimOptions {
    std::string scene;
    std::string folder = "out";
    std::string level = "lt";
    std::string profile;
    bool everything = false;
    bool no_check = false;
    bool exr = false;
    bool quiet = false;
};

// Tells a person what goes on, and keeps the wall time of each phase.
class Phases {
public:
    explicit Phases(bool quiet) : live_(!quiet && isatty(STDERR_FILENO) != 0) {}
    ~Phases() { clear(); }

    void start(const std::string& name) {
        stop();
        name_ = name;
        start_ = std::chrono::steady_clock::now();
        if (live_) std::fprintf(stderr, "\r\033[K%s ...", name.c_str());
    }

    void stop() {
        if (name_.empty()) return;
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        phases_.push_back({name_, spent.count()});
        name_.clear();
    }

    void clear() const {
        if (live_) std::fputs("\r\033[K", stderr);
    }

    const std::vector<Phase>& all() const { return phases_; }

private:
    bool live_;
    std::string name_;
    std::chrono::steady_clock::time_point start_;
    std::vector<Phase> phases_;
};

// All objects in one file, each with its vertices after those of the last. Normals and colours are
// there if every object has them.
host::Mesh joined(const SimResult& result) {
    host::Mesh all;
    bool with_normals = true, with_colours = true;
    for (const ObjectResult& object : result.objects) {
        with_normals &= !object.surface.normals.empty();
        with_colours &= !object.surface.colours.empty();
    }
    for (const ObjectResult& object : result.objects) {
        const host::Mesh& mesh = object.surface;
        const auto first = static_cast<uint32_t>(all.positions.size());
        all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
        all.uv.insert(all.uv.end(), mesh.uv.begin(), mesh.uv.end());
        if (with_normals) {
            all.normals.insert(all.normals.end(), mesh.normals.begin(), mesh.normals.end());
        }
        if (with_colours) {
            all.colours.insert(all.colours.end(), mesh.colours.begin(), mesh.colours.end());
        }
        for (const auto& t : mesh.triangles) {
            all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
    }
    return all;
}

Status make_folder(const std::string& folder) {
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (!code) return done();
    return Error{ErrorKind::Environment, folder, "cannot be created: " + code.message(), {}, {}};
}

Status write_outputs(const SimOptions& options, const Job& job, Level level,
                     const SimResult& result, Phases& phases) {
    phases.start("drawing");
    std::vector<host::RenderMesh> views;
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        views.push_back(host::surface_view(result.objects[i].surface, job.inputs(i)));
    }
    const host::Picture picture = host::render_scene(job.scene, views);
    phases.start("writing");
    const std::string base = options.folder + "/";
    if (const Status s = make_folder(options.folder); !s) return s;
    if (const Status s = host::write_png(base + "frame.png", picture); !s) return s;
    if (options.exr) {
        if (const Status s = host::write_exr(base + "frame.exr", picture); !s) return s;
    }
    if (const Status s = host::write_ply(base + "mesh.ply", joined(result)); !s) return s;
    if (const Status s = host::write_file(base + "report.json", report_json(job, level, result));
        !s) {
        return s;
    }
    phases.stop();
    return host::write_file(base + "timing.json", timing_json(phases.all(), result));
}

Status simulate(const SimOptions& options) {
    const Result<Level> level = parse_level(options.level);
    if (!level) return level.error();
    Phases phases(options.quiet);
    const Progress progress = [&phases](const std::string& text) { phases.start(text); };
    Result<Job> job = load_job(options.scene, options.profile, progress);
    if (!job) return job.error();
    // Level ref builds no device, so there is nothing to add to.
    if (options.everything && *level == Level::Lt) job->device.include_everything();
    const Result<SimResult> result = run_level(*job, *level, !options.no_check, progress);
    if (!result) return result.error();
    if (const Status written = write_outputs(options, *job, *level, *result, phases); !written) {
        return written;
    }
    phases.clear();
    if (!options.quiet) {
        std::fputs(summary(*job, *level, *result).c_str(), stdout);
        std::printf("  wrote %s/frame.png, mesh.ply, report.json, timing.json\n",
                    options.folder.c_str());
    }
    return verdict(*job, *result);
}

}  // namespace

void add_sim(CLI::App& root, Run& run) {
    auto options = std::make_shared<SimOptions>();
    CLI::App* sim = root.add_subcommand("sim", "run a scene through the hardware");
    sim->add_option("scene", options->scene, "scene file (docs/scene.md)")->required();
    sim->add_option("-o,--output", options->folder, "folder for the results")
        ->capture_default_str();
    sim->add_option("--level", options->level,
                    "ref: double arithmetic, no time; lt: bit-accurate, loosely timed")
        ->capture_default_str();
    sim->add_option("--profile", options->profile,
                    "a shipped profile or a file; the scene's choice otherwise");
    sim->add_flag("--everything", options->everything,
                  "build every unit, also those that the scene does not call for");
    sim->add_flag("--no-check", options->no_check, "do not judge the result by the invariants");
    sim->add_flag("--exr", options->exr, "write frame.exr as well");
    sim->add_flag("-q,--quiet", options->quiet, "no progress, no summary");
    sim->callback([options, &run] { run = [options] { return simulate(*options); }; });
}

}  // namespace repousse::app
