#pragma once

#include <random>

#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"

namespace repousse::study {

/// The mesh with one vertex for each position, so that a texture seam is no seam of the surface;
/// each keeps the attributes of its first copy. Tangents are dropped.
host::Mesh welded(const host::Mesh& mesh);

/// A cylinder with both ends closed by fans: a closed mesh with long thin triangles and two
/// vertices of many edges. Welded. Ranges as host::make_cylinder.
host::Mesh make_capped_cylinder(int segments, int rings, double radius, double height);

/// A camera that looks at, or from within, the ball around the origin. `inside`: the eye is in the
/// inner half of the ball; otherwise between 1.02 and 4 radii from its centre.
host::CameraSettings random_camera(std::mt19937_64& random, double radius, bool inside);

}  // namespace repousse::study
