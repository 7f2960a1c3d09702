#include "testbench/app/scene_edges.h"

#include "testbench/host/draw.h"
#include "testbench/host/view/camera.h"

namespace repousse::app {
namespace {

/// How a draw departs from what the scene describes: thresholds and the eye's distance by a factor.
struct Setting {
    bool eager;
    double thresholds, distance;
};
constexpr Setting kSettings[] = {
    {false, 1.0, 1.0}, {true, 1.0, 1.0},  {false, 0.5, 1.0},
    {false, 2.0, 1.0}, {false, 1.0, 0.5}, {false, 1.0, 2.0},
};

host::DrawInputs changed(host::DrawInputs inputs, const Setting& setting) {
    host::AdaptiveSettings& s = inputs.settings;
    s.eager |= setting.eager;
    if (s.view_threshold_px) *s.view_threshold_px *= setting.thresholds;
    if (s.normal_threshold) *s.normal_threshold *= setting.thresholds;
    if (s.height_threshold) *s.height_threshold *= setting.thresholds;
    host::CameraSettings& camera = inputs.camera;
    camera.eye = camera.target + setting.distance * (camera.eye - camera.target);
    inputs.view = host::view_frame(camera, inputs.viewport);
    return inputs;
}

}  // namespace

Status for_each_setting(const std::string& scene_file, const std::string& profile,
                        const std::function<void(const AdaptiveDraw<Fixed>&)>& take) {
    const Result<Job> job = load_job(scene_file, profile, [](const std::string&) {});
    if (!job) return job.error();
    bool any = false;
    for (std::size_t i = 0; i < job->objects.size(); ++i) {
        const host::DrawInputs inputs = job->inputs(i);
        if (inputs.method != host::Method::Adaptive) continue;
        any = true;
        for (const Setting& setting : kSettings) {
            const auto draw = host::make_draw<Fixed>(job->profile, changed(inputs, setting));
            if (!draw) return draw.error();
            take(*draw);
        }
    }
    if (any) return done();
    return Error{ErrorKind::Input,
                 scene_file,
                 "no object is tessellated adaptively",
                 "a scene with an object of method \"adaptive\"",
                 {}};
}

}  // namespace repousse::app
