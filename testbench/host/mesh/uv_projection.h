#pragma once

#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// A projection from around the z axis: u = azimuth / 2 pi; v runs from 0 to 1 with the elevation
/// angle (spherical) or with z between `low_z` and `high_z` (cylindrical).
struct RoundProjection {
    glm::dvec3 centre{0.0};
    bool spherical = true;
    double low_z = 0.0;
    double high_z = 1.0;
};

/// Replaces the UV of a mesh. Triangles across the meridian u = 0 get copies of their low-u
/// vertices with u + 1; each triangle with a vertex on the axis gets its own copy of it, at the
/// mean u of the other two. Copies repeat position and normal bit for bit. u and v are multiples
/// of 2^-30, so that u + 1 is exact in double and on any fixed-point texel grid.
void project_round(Mesh& mesh, const RoundProjection& projection);

/// uv = position within the bounding box in x and y.
void project_planar(Mesh& mesh);

}  // namespace repousse::host
