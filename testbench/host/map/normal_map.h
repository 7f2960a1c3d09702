#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// Unit normals in the map's own frame, one per texel, row-major: normalise(-dh/dx, -dh/dy, 1)
/// of the quantised heights in world units. Central differences over two texels; at a border
/// one-sided over one texel, or across the seam when the map wraps. A side of one texel has
/// slope 0. `texel_width`, `texel_height`: world size of a texel (1/256 in the reference rows).
std::vector<glm::dvec3> normal_map(const HeightMap& map, double texel_width, double texel_height);

/// The two rotations that take (0, 0, 1) to a unit normal n, in half turns (Kugler): x about the
/// second axis towards the first, then y about the first towards the second, so that n = (sin a,
/// cos a sin b, cos a cos b). Of a normal above the horizon both lie within +-1/2.
glm::dvec2 turns_of(const glm::dvec3& n);

}  // namespace repousse::host
