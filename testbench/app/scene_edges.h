#pragma once

#include <functional>
#include <string>

#include "datapath/error.h"
#include "datapath/pipelines/draw.h"
#include "datapath/profile.h"
#include "testbench/app/job.h"

namespace repousse::app {

/// The draws of a scene's adaptive objects: as the scene describes them, eager, with other
/// thresholds, and from other distances. `take` gets them one after the other. Errors: what a scene
/// or the profile may have wrong, and a scene without an adaptive object.
Status for_each_setting(const std::string& scene_file, const std::string& profile,
                        const std::function<void(const AdaptiveDraw<Fixed>&)>& take);

}  // namespace repousse::app
