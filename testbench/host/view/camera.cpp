#include "testbench/host/view/camera.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace repousse::host {
namespace {

std::array<double, 4> row(const glm::dvec3& axis, const glm::dvec3& eye) {
    return {axis.x, axis.y, axis.z, -glm::dot(axis, eye)};
}

double apply(const std::array<double, 4>& row, const glm::dvec3& p) {
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

}  // namespace

ViewFrame view_frame(const CameraSettings& camera, const Viewport& viewport) {
    ViewFrame frame;
    frame.eye = camera.eye;
    frame.forward = glm::normalize(camera.target - camera.eye);
    frame.right = glm::normalize(glm::cross(frame.forward, camera.up));
    frame.up = glm::cross(frame.right, frame.forward);
    frame.near = camera.near;
    const double focal = 0.5 * viewport.height_px / std::tan(0.5 * glm::radians(camera.fov_deg));
    frame.focal = {focal, -focal};
    frame.centre = {0.5 * viewport.width_px, 0.5 * viewport.height_px};
    return frame;
}

ViewProjection view_projection(const CameraSettings& camera, const Viewport& viewport) {
    const ViewFrame frame = view_frame(camera, viewport);
    ViewProjection view;
    view.scale_x = 0.5 * viewport.width_px;
    view.scale_y = -0.5 * viewport.height_px;
    view.x_row = row(frame.right * (frame.focal.x / view.scale_x), frame.eye);
    view.y_row = row(frame.up * (frame.focal.y / view.scale_y), frame.eye);
    view.w_row = row(frame.forward, frame.eye);
    view.centre_x = frame.centre.x;
    view.centre_y = frame.centre.y;
    view.near = camera.near;
    view.far = camera.far;
    return view;
}

ScreenPoint ViewProjection::project(const glm::dvec3& p) const {
    const double w = apply(w_row, p);
    return {centre_x + scale_x * apply(x_row, p) / w, centre_y + scale_y * apply(y_row, p) / w, w};
}

}  // namespace repousse::host
