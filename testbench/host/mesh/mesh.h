#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace repousse::host {

/// A triangle mesh as the device wants it: one vertex is a position with its UV, normal and
/// tangent frame. A vertex on a UV seam is stored once per side; both copies hold bit-identical
/// positions, which is how they are recognised again (see `weld`).
///
/// The attribute arrays are either empty or as long as `positions`. Readers leave empty what a
/// file does not hold; `complete_mesh` fills it in.
struct Mesh {
    std::vector<glm::dvec3> positions;  ///< world units
    std::vector<glm::dvec3> normals;    ///< unit length
    std::vector<glm::dvec3> tangents;   ///< unit length, along dP/du, orthogonal to the normal
    std::vector<double> handedness;     ///< +1 or -1: bitangent = handedness * cross(N, T)
    std::vector<glm::dvec2> uv;         ///< in units of the map: texel = uv * size
    std::vector<glm::dvec3> colours;    ///< linear light, 0..1: what the device shaded
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise from outside

    /// World length of one unit of u and of v (area-weighted mean over the mesh): divided by the
    /// map's size it is the texel size that finite-difference normals need. (0, 0) = not known.
    glm::dvec2 world_per_uv{0.0, 0.0};
};

}  // namespace repousse::host
