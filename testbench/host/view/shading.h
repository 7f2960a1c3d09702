#pragma once

#include <optional>
#include <vector>

#include "testbench/host/scene/scene.h"
#include "testbench/host/view/shadow_map.h"

namespace repousse::host {

/// A scene's colour in linear light: sRGB up to 1, linear already above, as bright lights are.
glm::dvec3 to_linear(const glm::dvec3& srgb);

/// The colour ramp of Tint::Relief at a height of 0..1, in linear light: meadow, sage, straw,
/// ochre, rock, snow.
glm::dvec3 relief_colour(double height);

/// Blinn and Phong's lighting with a sky that is brighter above than below.
class Shader {
public:
    /// The first light casts shadows when the view asks for them; `shadows` may be null.
    Shader(const ViewSettings& view, const std::vector<Light>& lights, const glm::dvec3& eye,
           const ShadowMap* shadows);

    const glm::dvec3& eye() const { return eye_; }

    /// Light from a surface point towards the eye, linear. `albedo` is linear; `normal` is unit
    /// length and belongs to the side that is seen.
    glm::dvec3 shade(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& albedo,
                     bool glossy) const;

    /// Colour of a block's side at a height: pale rock in faint layers, linear.
    glm::dvec3 stratum(double z) const;

    /// Surface colour in linear light; `height` only matters with Tint::Relief.
    glm::dvec3 albedo(std::optional<double> height) const;

    /// How much of the background remains on the floor at a point.
    double floor_light(const glm::dvec3& position) const;

private:
    struct LinearLight {
        glm::dvec3 direction;
        glm::dvec3 colour;
    };

    std::vector<LinearLight> lights_;
    glm::dvec3 eye_;
    glm::dvec3 plain_;
    glm::dvec3 sky_;
    bool relief_ = false;
    const ShadowMap* shadows_ = nullptr;
};

}  // namespace repousse::host
