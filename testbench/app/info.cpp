// repousse info: what a scene needs and why; nothing is simulated.

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "datapath/map_view.h"
#include "datapath/units/bump_desc.h"
#include "testbench/app/commands.h"
#include "testbench/app/job.h"

namespace repousse::app {
namespace {

struct InfoOptions {
    std::string scene;
    std::string profile;
};

void print_object(const Job& job, std::size_t i) {
    const LoadedObject& loaded = job.objects[i];
    const host::DrawInputs inputs = job.inputs(i);
    const host::HeightMap& map = loaded.map;
    fmt::print("object \"{}\" ({})\n", loaded.object->name,
               host::method_name(loaded.object->method));
    fmt::print("  mesh  {} triangles; {}\n", loaded.mesh.triangles.size(),
               host::describe(loaded.diagnosis));
    if (inputs.method == host::Method::Direct) return;
    fmt::print("  map   {} x {} texels, displacement {} to {}{}\n", map.width, map.height,
               map.range_low, map.range_high, map.wrap ? ", periodic" : "");
    if (inputs.method == host::Method::Adaptive) {
        const int natural = host::natural_cap(inputs, job.profile.uv.frac);
        const int cap = inputs.settings.generation_cap.value_or(natural);
        fmt::print("  cap   {} generations (natural: {}), stack {} triangles\n", cap, natural,
                   9 * cap + 1);
    } else {
        fmt::print("  grid  {} px a unit, corners within {} units of the middle{}\n",
                   inputs.sweep.coarseness_px, inputs.sweep.guard_grid,
                   inputs.sweep.clip ? ", clipped to the view" : "");
    }
}

// Bytes of the tables that the units read, built or not.
void print_tables(const Job& job) {
    uint64_t heights = 0, of_bump = 0, sums = 0;
    const auto kind = static_cast<BumpKind>(job.device.profile.bump_kind);
    const uint64_t bump_bytes = kind == BumpKind::Normals ? sizeof(Vec3<int16_t>)
                                : kind == BumpKind::Turns ? sizeof(Turn<int16_t>)
                                                          : 0;
    for (const LoadedObject& loaded : job.objects) {
        const uint64_t w = static_cast<uint64_t>(loaded.map.width);
        const uint64_t h = static_cast<uint64_t>(loaded.map.height);
        heights += w * h * sizeof(uint16_t);
        of_bump += w * h * bump_bytes;
        sums += (w + 1) * (h + 1) * sizeof(uint64_t);
    }
    const auto line = [](const char* name, uint64_t bytes, bool made) {
        fmt::print("  {:<20} {:>10} bytes  {}\n", name, bytes, made ? "made" : "not made");
    };
    fmt::print("tables\n");
    line("heights", heights, true);
    line(kind == BumpKind::Turns ? "angle map" : "normal map", of_bump,
         job.device.has_bump() && bump_bytes != 0);
    line("summed-area table", sums, job.device.adaptive && job.device.height_test);
}

Status inform(const InfoOptions& options) {
    const Result<Job> job = load_job(options.scene, options.profile, [](const std::string&) {});
    if (!job) return job.error();
    fmt::print("{}: {}\n", job->scene.file, job->scene.title);
    for (std::size_t i = 0; i < job->objects.size(); ++i) print_object(*job, i);
    fmt::print("units\n");
    for (const UnitReason& reason : explain_units(*job)) {
        fmt::print("  {:<18} {:<9} {}\n", reason.unit, reason.built ? "built" : "not built",
                   reason.why);
    }
    print_tables(*job);
    fmt::print("profile \"{}\"\n", job->profile_name);
    for (const ProfileEntry& entry : profile_entries()) {
        fmt::print("  {:<26} {:<24} {}\n", entry.key, entry_text(job->profile, entry), entry.doc);
    }
    for (const std::string& note : job->notes) fmt::print("note: {}\n", note);
    return done();
}

}  // namespace

void add_info(CLI::App& root, Run& run) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* info =
        root.add_subcommand("info", "what a scene needs and why; nothing is simulated");
    info->add_option("scene", options->scene, "scene file (docs/scene.md)")->required();
    info->add_option("--profile", options->profile,
                     "a shipped profile or a file; the scene's choice otherwise");
    info->callback([options, &run] { run = [options] { return inform(*options); }; });
}

}  // namespace repousse::app
