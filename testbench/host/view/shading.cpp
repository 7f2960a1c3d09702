#include "testbench/host/view/shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "testbench/host/view/picture.h"

namespace repousse::host {
namespace {

struct RampStop {
    double height;
    glm::dvec3 srgb;
};

const std::array<RampStop, 7> kRamp{{{0.00, {0.36, 0.47, 0.34}},
                                     {0.18, {0.50, 0.58, 0.40}},
                                     {0.36, {0.71, 0.71, 0.50}},
                                     {0.54, {0.80, 0.70, 0.50}},
                                     {0.70, {0.69, 0.53, 0.38}},
                                     {0.86, {0.66, 0.60, 0.55}},
                                     {1.00, {0.96, 0.95, 0.93}}}};

}  // namespace

glm::dvec3 to_linear(const glm::dvec3& srgb) {
    glm::dvec3 linear;
    for (int k = 0; k < 3; ++k) {
        linear[k] = srgb[k] <= 1.0 ? srgb_to_linear(srgb[k]) : srgb[k];
    }
    return linear;
}

glm::dvec3 relief_colour(double height) {
    const double h = std::clamp(height, 0.0, 1.0);
    std::size_t i = 1;
    while (i + 1 < kRamp.size() && h > kRamp[i].height) ++i;
    const RampStop& low = kRamp[i - 1];
    const RampStop& high = kRamp[i];
    const double t = (h - low.height) / (high.height - low.height);
    return to_linear(glm::mix(low.srgb, high.srgb, t));
}

Shader::Shader(const ViewSettings& view, const std::vector<Light>& lights, const glm::dvec3& eye,
               const ShadowMap* shadows)
    : eye_(eye),
      plain_(to_linear(view.colour)),
      sky_(to_linear(view.background)),
      relief_(view.tint == Tint::Relief),
      shadows_(shadows) {
    for (const Light& light : lights) {
        lights_.push_back({light.direction, to_linear(light.colour)});
    }
}

glm::dvec3 Shader::albedo(std::optional<double> height) const {
    return relief_ && height ? relief_colour(*height) : plain_;
}

glm::dvec3 Shader::stratum(double z) const {
    // Two incommensurable waves: layers of uneven thickness, without a table.
    const double layer = 0.5 + 0.3 * std::sin(z * 420.0) + 0.2 * std::sin(z * 171.0 + 1.0);
    return glm::mix(glm::dvec3(0.30, 0.26, 0.22), glm::dvec3(0.40, 0.35, 0.30), layer);
}

glm::dvec3 Shader::shade(const glm::dvec3& position, const glm::dvec3& normal,
                         const glm::dvec3& albedo, bool glossy) const {
    const glm::dvec3 to_eye = glm::normalize(eye_ - position);
    // The sky from above, a third of it back from the ground.
    const double up = 0.5 + 0.5 * normal.z;
    glm::dvec3 light = albedo * sky_ * (0.08 + 0.16 * up);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const double facing = glm::dot(normal, lights_[i].direction);
        if (facing <= 0.0) continue;
        const bool shadowed = i == 0 && shadows_ != nullptr;
        const double part = shadowed ? shadows_->visibility(position, normal) : 1.0;
        glm::dvec3 reflected = albedo * facing;
        if (glossy) {
            const glm::dvec3 half = glm::normalize(to_eye + lights_[i].direction);
            const double gloss = std::max(0.0, glm::dot(normal, half));
            reflected += glm::dvec3(0.10 * std::pow(gloss, 40.0));
        }
        light += reflected * lights_[i].colour * (part * 0.62);
    }
    return light;
}

double Shader::floor_light(const glm::dvec3& position) const {
    if (shadows_ == nullptr) return 1.0;
    return 0.62 + 0.38 * shadows_->visibility(position, glm::dvec3(0.0, 0.0, 1.0));
}

}  // namespace repousse::host
