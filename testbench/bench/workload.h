#pragma once

#include <malloc.h>

#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "testbench/host/draw.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/sweep_draw.h"
#include "tlm/config/profile_reader.h"
#include "tlm/platform/platform.h"

namespace repousse::bench {

/// Memory that a round frees stays with the process, so that what is measured is the simulation and
/// not the operating system giving out pages.
inline void keep_freed_memory() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

/// A scene's objects of one method, loaded once for all rows.
struct Workload {
    Profile profile;
    Profile reference;
    std::vector<shell::Draw> fixed;
    std::vector<std::variant<AdaptiveDraw<Real>, SweepDraw<Real>>> real;
};

template <class P, class Draws>
Status add_draw(const Profile& profile, const host::DrawInputs& inputs, Draws& draws) {
    if (inputs.method == host::Method::Adaptive) {
        auto draw = host::make_draw<P>(profile, inputs);
        if (!draw) return draw.error();
        draws.push_back(std::move(*draw));
        return done();
    }
    auto draw = host::make_sweep_draw<P>(profile, inputs);
    if (!draw) return draw.error();
    draws.push_back(std::move(*draw));
    return done();
}

/// The objects of `method`. Errors: the scene, or a file that it names and that has no fallback.
inline Result<Workload> load_workload(const std::string& scene_file, host::Method method) {
    const auto scene = host::read_scene(scene_file);
    if (!scene) return scene.error();
    const auto profile = shipped_profile(scene->profile);
    if (!profile) return profile.error();
    Workload work{*profile, host::reference_profile(*profile), {}, {}};
    for (const host::Object& object : scene->objects) {
        if (object.method != method) continue;
        const auto mesh = host::load_mesh(object);
        if (!mesh) return mesh.error();
        const auto map = host::load_map(object, {});
        if (!map) return map.error();
        const host::DrawInputs inputs = host::draw_inputs(*scene, object, *mesh, *map);
        if (const Status fixed = add_draw<Fixed>(work.profile, inputs, work.fixed); !fixed) {
            return fixed.error();
        }
        if (const Status real = add_draw<Real>(work.reference, inputs, work.real); !real) {
            return real.error();
        }
    }
    return work;
}

}  // namespace repousse::bench
