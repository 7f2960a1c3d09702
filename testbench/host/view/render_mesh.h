#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace repousse::host {

/// A surface to be drawn. `normals`, `heights` and `colours` are as long as `positions` or empty.
struct RenderMesh {
    /// How light treats it.
    enum class Kind {
        Surface,  ///< the displaced object
        Side,     ///< the wall of a block model: never tinted, no wireframe
        Floor,    ///< shows the background, darkened where a shadow falls
    };

    Kind kind = Kind::Surface;
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  ///< unit; empty = one normal a face
    std::vector<double> heights;      ///< 0..1, for Tint::Relief; empty = plain
    std::vector<glm::dvec3> colours;  ///< linear light towards the eye; empty = lit by the view
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The wall from the border of an open surface down to z = base_z. Empty for a closed surface.
RenderMesh make_skirt(const RenderMesh& surface, double base_z);

/// A large floor at z = base_z below a surface, to catch its shadow.
RenderMesh make_floor(const RenderMesh& surface, double base_z);

/// Lowest z of a surface less 4 % of its larger horizontal extent: where its block stands.
double block_base(const RenderMesh& surface);

}  // namespace repousse::host
