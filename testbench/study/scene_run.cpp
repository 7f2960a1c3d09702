#include "testbench/study/scene_run.h"

#include <filesystem>

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "testbench/host/draw.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/surface.h"
#include "testbench/host/sweep_draw.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

/// `triangles` are those of `output`; `base(triangle)` is the number of the base triangle that one
/// came from, and equal numbers stand together.
template <class Output, class Triangles, class Base>
RunSurface finish(const Output& output, const Triangles& triangles, const Profile& profile,
                  const host::DrawInputs& inputs, const DisplaceCounters& displace, Base base) {
    RunSurface surface;
    surface.view = host::surface_view(host::surface_mesh<Fixed>(output, profile, inputs), inputs);
    surface.base_triangles = inputs.mesh->triangles.size();
    surface.rejected = surface.base_triangles;
    surface.displaced = displace.items;
    surface.texel_reads = displace.reads;
    for (std::size_t i = 0; i < triangles.size();) {
        std::size_t end = i;
        while (end < triangles.size() && base(triangles[end]) == base(triangles[i])) ++end;
        surface.whole += end - i == 1;
        --surface.rejected;
        i = end;
    }
    return surface;
}

Error lost(const std::string& object) {
    return {ErrorKind::Mismatch, object, "the units lost a triangle", {}, {}};
}

}  // namespace

Result<SceneRun> SceneRun::open(const std::string& scene_file) {
    auto scene = host::read_scene(scene_file);
    if (!scene) return scene.error();
    return load(std::move(*scene));
}

Result<SceneRun> SceneRun::load(host::Scene scene) {
    SceneRun run;
    run.scene = std::move(scene);
    const auto profile = find_profile(run.scene.profile);
    if (!profile) return profile.error();
    run.profile_ = *profile;
    for (const host::Object& object : run.scene.objects) {
        auto mesh = host::load_mesh(object);
        if (!mesh) return mesh.error();
        auto map = host::load_map(object, {});
        if (!map) return map.error();
        run.meshes_.push_back(std::move(*mesh));
        run.maps_.push_back(std::move(*map));
    }
    return run;
}

std::string SceneRun::source(std::size_t object) const {
    const host::MapSource& map = scene.objects[object].map;
    if (map.used_fallback) {
        return "a procedural map in the place of `" +
               std::filesystem::path(map.missing_file).filename().string() + "`";
    }
    if (map.recipe.file.empty()) return "a procedural map";
    return "`" + std::filesystem::path(map.recipe.file).filename().string() + "`";
}

Result<RunSurface> SceneRun::run(std::size_t object) const {
    const host::Object& what = scene.objects[object];
    const host::DrawInputs inputs = host::draw_inputs(scene, what, meshes_[object], maps_[object]);
    if (what.method == host::Method::Adaptive) {
        const auto draw = host::make_draw<Fixed>(profile_, inputs);
        if (!draw) return draw.error();
        AdaptivePipeline<Fixed> pipeline(profile_, *draw);
        std::vector<OutputTriangle<Fixed>> triangles;
        const bool fits = pipeline.run([&](Span<const OutputTriangle<Fixed>> some) {
            triangles.insert(triangles.end(), some.begin(), some.end());
        });
        if (!fits) return lost(what.name);
        return finish(triangles, triangles, profile_, inputs, pipeline.counters().displace,
                      [](const auto& t) { return t.path.base; });
    }
    const auto draw = host::make_sweep_draw<Fixed>(profile_, inputs);
    if (!draw) return draw.error();
    SweepPipeline<Fixed> pipeline(profile_, *draw);
    SweepMesh<Fixed> fine;
    if (!pipeline.run(fine)) return lost(what.name);
    return finish(fine, fine.triangles, profile_, inputs, pipeline.counters().displace,
                  [](const auto& t) { return t.base; });
}

}  // namespace repousse::study
