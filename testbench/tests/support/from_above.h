#pragma once

#include <cmath>

#include "testbench/host/scene/scene.h"

namespace repousse::test {

/// Looks straight down at (0.5, 0.5, 0) from one unit above; the picture is one unit high there.
inline host::CameraSettings from_above() {
    host::CameraSettings camera;
    camera.eye = {0.5, 0.5, 1.0};
    camera.target = {0.5, 0.5, 0.0};
    camera.up = {0.0, 1.0, 0.0};
    camera.fov_deg = 2.0 * std::atan(0.5) * 180.0 / 3.14159265358979323846;
    return camera;
}

}  // namespace repousse::test
