#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "testbench/host/scene/scene.h"

namespace repousse::host {

/// The camera as the device's registers want it, in doubles. Screen positions are
/// centre + focal * (right . e / forward . e), e = P' - eye; y likewise with up.
struct ViewFrame {
    glm::dvec3 eye{0.0};
    glm::dvec3 right{1.0, 0.0, 0.0};
    glm::dvec3 up{0.0, 1.0, 0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0};
    double near = 1e-6;
    glm::dvec2 focal{1.0};
    glm::dvec2 centre{0.0};
};

/// The frame of a scene's camera; rows of pixels run downwards.
ViewFrame view_frame(const CameraSettings& camera, const Viewport& viewport);

/// A point on the screen: pixels (x to the right, y down, pixel centres at .5) and depth.
struct ScreenPoint {
    double x = 0.0;
    double y = 0.0;
    double w = 0.0;  ///< distance along the viewing direction; <= near means not projectable
};

/// The frame as rows for homogeneous points, for clipping. A world point p becomes
///   clip x = x_row . (p, 1), clip y = y_row . (p, 1), w = w_row . (p, 1)
/// with x, y in [-w, w] inside the picture, and the screen position
///   (centre_x + scale_x * x / w, centre_y + scale_y * y / w) in pixels.
/// w is the distance along the viewing direction (positive in front of the eye).
struct ViewProjection {
    std::array<double, 4> x_row{};  ///< right / (tan(fov / 2) * aspect), and its offset
    std::array<double, 4> y_row{};  ///< up / tan(fov / 2), and its offset
    std::array<double, 4> w_row{};  ///< forward, and its offset
    double scale_x = 0.0;           ///< width_px / 2
    double scale_y = 0.0;           ///< -height_px / 2: y runs down the screen
    double centre_x = 0.0;
    double centre_y = 0.0;
    double near = 0.0;
    double far = 0.0;

    ScreenPoint project(const glm::dvec3& p) const;
};

/// The view of a camera that `read_scene` has validated (eye != target, up not along the view).
ViewProjection view_projection(const CameraSettings& camera, const Viewport& viewport);

}  // namespace repousse::host
