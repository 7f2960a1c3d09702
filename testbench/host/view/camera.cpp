#include "testbench/host/view/camera.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace repousse::host {
namespace {

std::array<double, 4> row(const glm::dvec3& axis, const glm::dvec3& eye) {
    return {axis.x, axis.y, axis.z, -glm::dot(axis, eye)};
}

double apply(const std::array<double, 4>& row, const glm::dvec3& p) {
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

}  // namespace

ViewProjection view_projection(const CameraSettings& camera, const Viewport& viewport) {
    constexpr double kRadians = 3.14159265358979323846 / 180.0;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double slope = std::tan(0.5 * camera.fov_deg * kRadians);
    const double aspect = static_cast<double>(viewport.width_px) / viewport.height_px;
    ViewProjection view;
    view.x_row = row(right / (slope * aspect), camera.eye);
    view.y_row = row(up / slope, camera.eye);
    view.w_row = row(forward, camera.eye);
    view.scale_x = 0.5 * viewport.width_px;
    view.scale_y = -0.5 * viewport.height_px;
    view.centre_x = 0.5 * viewport.width_px;
    view.centre_y = 0.5 * viewport.height_px;
    view.near = camera.near;
    view.far = camera.far;
    return view;
}

ScreenPoint ViewProjection::project(const glm::dvec3& p) const {
    const double w = apply(w_row, p);
    return {centre_x + scale_x * apply(x_row, p) / w, centre_y + scale_y * apply(y_row, p) / w, w};
}

}  // namespace repousse::host
