#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// Reads a mesh by its extension: .obj, .off, .ply. Polygons become triangle fans around their
/// first vertex; UV and normals are kept where the file has them, otherwise their arrays are empty.
///
/// Errors (kind Input): `file:line:column: ...` for text, `file: offset N: ...` for binary: a
/// vertex that is NaN or infinite, an index out of range, a count that claims more than the file
/// can hold (checked before anything is allocated), an unknown element or property type, a
/// truncated file, a mesh without triangles.
Result<Mesh> read_mesh(const std::string& path);

/// The readers behind it; `bytes` is the file's whole content, `name` stands in messages.
/// OBJ: v, vt, vn and f with 1-based or negative indices; one vertex is made per distinct
/// (v, vt, vn) triple, in order of first use. Groups, materials and smoothing are skipped.
Result<Mesh> read_obj(const std::string& bytes, const std::string& name);

/// OFF with optional ST, C and N prefixes (texture coordinates, colours, normals), # comments and
/// trailing face colours; 4-D and binary OFF are refused.
Result<Mesh> read_off(const std::string& bytes, const std::string& name);

/// PLY 1.0: ascii, binary_little_endian, binary_big_endian; x y z, optional nx ny nz, optional
/// u v / s t / texture_u texture_v; faces as vertex_indices or vertex_index. Other elements and
/// properties of known types are skipped.
Result<Mesh> read_ply(const std::string& bytes, const std::string& name);

}  // namespace repousse::host
