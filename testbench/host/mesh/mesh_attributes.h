#pragma once

#include "datapath/error.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"

namespace repousse::host {

/// Area-weighted vertex normals over welded positions: all copies of a position get the same
/// bits. Positions without area get (0, 0, 1).
std::vector<glm::dvec3> area_weighted_normals(
    const std::vector<glm::dvec3>& positions,
    const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Replaces the UV of a mesh by a projection: planar (x, y of the bounding box), cylindrical
/// (azimuth about z, z) or spherical (azimuth, elevation from the bounding box's centre). The two
/// round projections duplicate seam vertices as `make_icosphere` documents; the map must wrap.
void project_uv(Mesh& mesh, UvProjection projection);

/// Fills tangents and handedness from UV, per vertex. Copies of a position whose UV differ by whole
/// maps and whose handedness agrees share one tangent, so a wrapped seam stays closed; a mirrored
/// or chart seam keeps one frame per side.
void compute_tangents(Mesh& mesh);

/// Area-weighted mean world length of a unit of u and of v; (0, 0) when no triangle has UV area.
glm::dvec2 measure_world_per_uv(const Mesh& mesh);

/// Makes every attribute present: UV from the projection if one is asked for, normals if missing,
/// then tangents and world_per_uv. Error: no UV and no projection.
Status complete_mesh(Mesh& mesh, UvProjection projection, const std::string& name);

}  // namespace repousse::host
