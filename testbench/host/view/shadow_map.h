#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "testbench/host/view/render_mesh.h"

namespace repousse::host {

/// Depths of the scene seen from a directional light, on a square grid around its bounding box.
class ShadowMap {
public:
    /// `direction` is unit length, towards the light; `side` is the grid's size in cells. Floors
    /// cast no shadow. `softness` is the filter's radius in world units.
    ShadowMap(const std::vector<RenderMesh>& meshes, const glm::dvec3& direction, int side,
              double softness);

    /// The part of the light, 0..1, that reaches a point with this normal: a 5 x 5 filter of depth
    /// comparisons, the point lifted along its normal against self-shadowing.
    double visibility(const glm::dvec3& position, const glm::dvec3& normal) const;

private:
    glm::dvec3 to_light(const glm::dvec3& p) const;

    glm::dvec3 x_axis_{0.0}, y_axis_{0.0}, z_axis_{0.0};
    glm::dvec3 low_{0.0};
    double cells_per_unit_ = 0.0;
    double softness_ = 0.0;  // in cells
    int side_ = 0;
    std::vector<float> depth_;  // towards the light; the largest wins
};

}  // namespace repousse::host
