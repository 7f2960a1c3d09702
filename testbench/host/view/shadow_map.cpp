#include "testbench/host/view/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "testbench/host/view/rasteriser.h"

namespace repousse::host {

ShadowMap::ShadowMap(const std::vector<RenderMesh>& meshes, const glm::dvec3& direction, int side,
                     double softness)
    : side_(side) {
    z_axis_ = direction;
    const glm::dvec3 helper =
        std::fabs(z_axis_.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
    x_axis_ = glm::normalize(glm::cross(helper, z_axis_));
    y_axis_ = glm::cross(z_axis_, x_axis_);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kInfinity);
    glm::dvec3 high(-kInfinity);
    for (const RenderMesh& mesh : meshes) {
        if (mesh.kind == RenderMesh::Kind::Floor) continue;
        for (const glm::dvec3& p : mesh.positions) {
            const glm::dvec3 q(glm::dot(p, x_axis_), glm::dot(p, y_axis_), glm::dot(p, z_axis_));
            low = glm::min(low, q);
            high = glm::max(high, q);
        }
    }
    low_ = low;
    const double extent = std::max(high.x - low.x, high.y - low.y);
    cells_per_unit_ = extent > 0.0 && extent < kInfinity ? (side - 2) / extent : 0.0;
    softness_ = softness * cells_per_unit_;
    depth_.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                  -std::numeric_limits<float>::infinity());
    for (const RenderMesh& mesh : meshes) {
        if (mesh.kind == RenderMesh::Kind::Floor) continue;
        for (const auto& t : mesh.triangles) {
            SnappedVertex at[3];
            double z[3] = {0.0, 0.0, 0.0};
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 q = to_light(mesh.positions[t[k]]);
                at[k] = {static_cast<std::int64_t>(q.x * static_cast<double>(kSubpixels)),
                         static_cast<std::int64_t>(q.y * static_cast<double>(kSubpixels))};
                z[k] = q.z;
            }
            rasterise(at[0], at[1], at[2], {0, 0, side, side}, [&](int x, int y, const Weights& w) {
                float& cell = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
                                     static_cast<std::size_t>(x)];
                cell = std::max(cell, static_cast<float>(w.a * z[0] + w.b * z[1] + w.c * z[2]));
            });
        }
    }
}

/// Cells across and up (one cell of margin), depth in cells.
glm::dvec3 ShadowMap::to_light(const glm::dvec3& p) const {
    const glm::dvec3 q(glm::dot(p, x_axis_), glm::dot(p, y_axis_), glm::dot(p, z_axis_));
    return (q - low_) * cells_per_unit_ + glm::dvec3(1.0, 1.0, 0.0);
}

double ShadowMap::visibility(const glm::dvec3& position, const glm::dvec3& normal) const {
    if (cells_per_unit_ == 0.0) return 1.0;
    // One and a half cells off the surface: the depth changes by at most that between two taps.
    const glm::dvec3 at = to_light(position + normal * (1.5 * (1.0 + softness_) / cells_per_unit_));
    const double step = 0.5 * std::max(1.0, softness_);
    double lit = 0.0;
    double total = 0.0;
    for (int j = -2; j <= 2; ++j) {
        for (int i = -2; i <= 2; ++i) {
            const double weight = (3 - std::abs(i)) * (3 - std::abs(j));
            total += weight;
            const double fx = std::floor(at.x + i * step);
            const double fy = std::floor(at.y + j * step);
            const bool outside = !(fx >= 0.0 && fy >= 0.0 && fx < side_ && fy < side_);
            const std::size_t cell =
                outside ? 0
                        : static_cast<std::size_t>(fy) * static_cast<std::size_t>(side_) +
                              static_cast<std::size_t>(fx);
            if (outside || static_cast<double>(depth_[cell]) <= at.z) lit += weight;
        }
    }
    return lit / total;
}

}  // namespace repousse::host
