#pragma once

#include <glm/vec3.hpp>

#include "testbench/host/map/height_map.h"
#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// Where a cylindrical scanner stands: its axis, in the units of the mesh, and what lies at u = 0.
struct RangeAxis {
    glm::dvec3 low{0.0, 0.0, 0.0};    ///< v = 0
    glm::dvec3 high{0.0, 0.0, 1.0};   ///< v = 1
    glm::dvec3 front{1.0, 0.0, 0.0};  ///< u = 0; only its part across the axis counts, not zero
};

/// Scans a mesh: each sample is the distance from the axis to the outermost surface, along the ray
/// through the centre of texel (x, y): azimuth 2 pi (x + .5) / width, counter-clockwise as seen
/// from `high`, and height (y + .5) / height of the axis. The map is periodic in u.
///
/// A ray that hits nothing takes the sample of the nearest row that hit something in its column; a
/// column without any is 0. low and high are set to the smallest and largest sample.
ElevationGrid range_map(const Mesh& mesh, const RangeAxis& axis, int width, int height);

}  // namespace repousse::host
