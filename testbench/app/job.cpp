#include "testbench/app/job.h"

#include <fmt/format.h>

#include "testbench/host/image/image_map.h"
#include "testbench/host/scene/assets.h"
#include "tlm/config/profile_reader.h"

namespace repousse::app {
namespace {

// The part of a device that one object calls for.
DeviceConfig device_for(const Profile& profile, const host::Object& object) {
    DeviceConfig device;
    device.profile = profile;
    device.bump = object.bump;
    device.shade = object.shade.has_value();
    if (object.method == host::Method::Adaptive) {
        const host::AdaptiveSettings& s = object.adaptive;
        device.adaptive = true;
        device.view_test = s.view_threshold_px.has_value();
        device.normal_test = s.normal_threshold.has_value();
        device.height_test = s.height_threshold.has_value();
        device.contexts = s.contexts;
    } else {
        device.direct = object.method == host::Method::Direct;
        device.sweep = object.method == host::Method::Sweep;
        device.view_clip = device.sweep && object.sweep.clip;
        device.levels = device.sweep && object.map.levels.has_value();
    }
    return device;
}

void note_mesh(Job& job, const LoadedObject& loaded) {
    const host::MeshDiagnosis& d = loaded.diagnosis;
    const auto note = [&](std::size_t count, const char* what) {
        if (count != 0) {
            job.notes.push_back(fmt::format("{}: {} {}", loaded.object->name, count, what));
        }
    };
    note(d.non_manifold_edges, "non-manifold edges in the base mesh; invariants are waived there");
    note(d.inconsistent_edges, "edges whose triangles run along them the same way");
    note(d.degenerate_triangles, "base triangles without area");
}

void note_cap(Job& job, std::size_t i) {
    if (job.objects[i].object->method != host::Method::Adaptive) return;
    const host::DrawInputs inputs = job.inputs(i);
    const int natural = host::natural_cap(inputs, job.profile.uv.frac);
    const auto& cap = inputs.settings.generation_cap;
    if (cap && *cap > natural && job.profile.uv.frac < 6) {
        job.notes.push_back(fmt::format(
            "{}: generation cap {} is above the natural {} with {} fraction bits of UV: triangles "
            "may flip; use at least 6 bits",
            job.objects[i].object->name, *cap, natural, job.profile.uv.frac));
    }
}

}  // namespace

host::DrawInputs Job::inputs(std::size_t i) const {
    const LoadedObject& loaded = objects[i];
    return host::draw_inputs(scene, *loaded.object, loaded.mesh, loaded.map);
}

Result<Job> load_job(const std::string& scene_file, const std::string& profile,
                     const Progress& progress) {
    progress("reading " + scene_file);
    Result<host::Scene> scene = host::read_scene(scene_file);
    if (!scene) return scene.error();
    Job job;
    job.scene = std::move(*scene);
    job.profile_name = profile.empty() ? job.scene.profile : profile;
    const Result<Profile> found = find_profile(job.profile_name);
    if (!found) return found.error();
    job.profile = *found;
    job.needed.profile = job.profile;
    job.notes = job.scene.notes;
    // Objects keep pointers into the scene's list, which moves as a whole.
    for (const host::Object& object : job.scene.objects) {
        progress("loading " + object.name);
        LoadedObject loaded;
        loaded.object = &object;
        Result<host::Mesh> mesh = host::load_mesh(object);
        if (!mesh) return mesh.error();
        Result<host::HeightMap> map = host::load_map(object, host::read_image_grid);
        if (!map) return map.error();
        loaded.mesh = std::move(*mesh);
        loaded.map = std::move(*map);
        loaded.diagnosis = host::mesh_check(loaded.mesh);
        job.needed.include(device_for(job.profile, object));
        job.objects.push_back(std::move(loaded));
        note_mesh(job, job.objects.back());
        note_cap(job, job.objects.size() - 1);
    }
    job.device = job.needed;
    return job;
}

}  // namespace repousse::app
