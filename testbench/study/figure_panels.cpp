#include "testbench/study/figure_panels.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "testbench/host/view/render.h"

namespace repousse::study {
namespace {

constexpr int kGapPx = 6;

float rounded(float linear, int shades) {
    const double steps = shades - 1;
    const double code = host::linear_to_srgb(std::clamp(static_cast<double>(linear), 0.0, 1.0));
    return static_cast<float>(host::srgb_to_linear(std::floor(code * steps + 0.5) / steps));
}

}  // namespace

host::Picture panels(const std::vector<std::vector<host::Picture>>& rows, int shades) {
    host::Picture sheet;
    for (const auto& row : rows) {
        int width = -kGapPx;
        for (const host::Picture& panel : row) width += panel.width + kGapPx;
        sheet.width = std::max(sheet.width, width);
        sheet.height += row.front().height + (sheet.height > 0 ? kGapPx : 0);
    }
    sheet.rgb.assign(
        3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), 1.0f);
    int top = 0;
    for (const auto& row : rows) {
        int left = 0;
        for (const host::Picture& panel : row) {
            for (int y = 0; y < panel.height; ++y) {
                std::copy_n(panel.pixel(0, y), 3 * panel.width, sheet.pixel(left, top + y));
            }
            left += panel.width + kGapPx;
        }
        top += row.front().height + kGapPx;
    }
    for (float& channel : sheet.rgb) channel = rounded(channel, shades);
    return sheet;
}

host::Picture reduced(const host::Picture& picture, int factor) {
    host::Picture result;
    result.width = picture.width / factor;
    result.height = picture.height / factor;
    result.rgb.assign(
        3 * static_cast<std::size_t>(result.width) * static_cast<std::size_t>(result.height), 0.0f);
    for (int y = 0; y < result.height * factor; ++y) {
        for (int x = 0; x < result.width * factor; ++x) {
            for (int k = 0; k < 3; ++k) {
                result.pixel(x / factor, y / factor)[k] +=
                    picture.pixel(x, y)[k] / static_cast<float>(factor * factor);
            }
        }
    }
    return result;
}

host::Picture shaded(const host::Scene& scene, const std::vector<host::RenderMesh>& surfaces,
                     const host::CameraSettings& camera, const host::Viewport& viewport) {
    host::ViewSettings view = scene.view;
    view.wireframe = false;
    return host::render(surfaces, camera, viewport, view, scene.lights);
}

host::Picture wireframe(const std::vector<host::RenderMesh>& surfaces,
                        const host::CameraSettings& camera, const host::Viewport& viewport) {
    host::ViewSettings view;
    view.wireframe = true;
    view.shading = host::Shading::Flat;
    view.colour = {0.95, 0.95, 0.95};
    view.background = view.horizon = {1.0, 1.0, 1.0};
    view.samples = 4;
    // From over the left shoulder, so that folds show and nothing is in the dark.
    const glm::dvec3 back = glm::normalize(camera.eye - camera.target);
    const glm::dvec3 right = glm::normalize(glm::cross(camera.up, back));
    const glm::dvec3 over = glm::normalize(back - 0.45 * right + 0.35 * camera.up);
    return host::render(surfaces, camera, viewport, view, {{over, {1.3, 1.3, 1.3}}});
}

host::CameraSettings farther(host::CameraSettings camera, double times) {
    camera.eye = camera.target + (camera.eye - camera.target) * times;
    return camera;
}

std::string grouped(std::size_t number) {
    std::string text = std::to_string(number);
    for (std::size_t at = text.size(); at > 3;) {
        at -= 3;
        text.insert(at, ",");
    }
    return text;
}

}  // namespace repousse::study
