#include "testbench/app/job.h"

#include <fmt/format.h>

#include "testbench/host/image/image_map.h"
#include "testbench/host/scene/assets.h"
#include "tlm/config/profile_reader.h"

namespace repousse::app {
namespace {

// The part of a device that one object calls for.
DeviceConfig device_for(const Profile& profile, const host::Object& object) {
    const host::AdaptiveSettings& s = object.adaptive;
    DeviceConfig device;
    device.profile = profile;
    device.view_test = s.view_threshold_px.has_value();
    device.normal_test = s.normal_threshold.has_value();
    device.height_test = s.height_threshold.has_value();
    device.bump = object.bump || device.normal_test;
    device.contexts = s.contexts;
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
    const host::Object& object = *loaded.object;
    host::DrawInputs inputs;
    inputs.mesh = &loaded.mesh;
    inputs.map = &loaded.map;
    inputs.settings = object.adaptive;
    inputs.filter = object.map.filter;
    inputs.uv = object.map.uv;
    inputs.bump = object.bump;
    inputs.texel_size = host::texel_size(loaded.mesh, loaded.map, object.map.uv);
    inputs.view = host::view_frame(scene.camera, scene.viewport);
    return inputs;
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

std::vector<UnitReason> explain_units(const Job& job) {
    const DeviceConfig& need = job.needed;
    const DeviceConfig& built = job.device;
    const auto reason = [](std::string_view unit, bool is_built, bool is_needed,
                           std::string_view yes, std::string_view no) {
        std::string why(is_needed ? yes : no);
        if (is_built && !is_needed) why += "; built on request";
        return UnitReason{unit, is_built, why};
    };
    const auto always = [](std::string_view unit, std::string_view why) {
        return UnitReason{unit, true, std::string(why)};
    };
    return {
        always("triangle_stack", "every adaptive object is tessellated recursively"),
        always("edge_iter", "tests are made edge by edge"),
        always("mid_vertex", "new vertices are midpoints of edges"),
        always("texcoord_test", "refinement ends at the map's resolution"),
        reason("view_test", built.view_test, need.view_test, "an object has view_threshold_px",
               "no object has view_threshold_px"),
        reason("bump", built.bump, need.bump,
               need.normal_test ? "the normal test compares displaced normals"
                                : "an object asks for displaced normals with [object.bump]",
               "no object has normal_threshold or [object.bump]: no normal map is made"),
        reason("normal_test", built.normal_test, need.normal_test, "an object has normal_threshold",
               "no object has normal_threshold"),
        reason("height_test", built.height_test, need.height_test,
               "an object has a height threshold",
               "no object has a height threshold: no summed-area table is made"),
        always("split", "edges are decided and triangles cut"),
        always("displace", "vertices are displaced"),
        reason("vertex_transform", built.view_test, need.view_test,
               "the view test measures on the screen",
               "without a view test no screen position is needed"),
    };
}

}  // namespace repousse::app
