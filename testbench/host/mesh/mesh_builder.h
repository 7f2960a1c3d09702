#pragma once

#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// Appends a polygon as a fan of triangles around its first corner.
inline void add_fan(Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    for (std::size_t k = 2; k < corners.size(); ++k) {
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
}

/// Last step of every reader: normals to unit length (dropped altogether when one of them has no
/// length, so that they are computed instead), and a mesh without triangles refused.
Result<Mesh> finish_mesh(Mesh mesh, const std::string& name);

}  // namespace repousse::host
