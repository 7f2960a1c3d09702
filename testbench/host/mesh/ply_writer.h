#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// The mesh as binary little-endian PLY: double x y z, double nx ny nz when the mesh has normals,
/// double u v when it has UV, uchar red green blue (sRGB, as viewers show it) when it has colours,
/// faces as uchar + uint32 lists. The same mesh gives the same bytes.
std::string to_ply(const Mesh& mesh);

/// Writes `to_ply` to a file, beside and renamed. Errors: kind Environment.
Status write_ply(const std::string& path, const Mesh& mesh);

}  // namespace repousse::host
