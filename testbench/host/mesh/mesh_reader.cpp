#include "testbench/host/mesh/mesh_reader.h"

#include <glm/geometric.hpp>

#include "testbench/host/files.h"
#include "testbench/host/mesh/mesh_builder.h"

namespace repousse::host {

Result<Mesh> finish_mesh(Mesh mesh, const std::string& name) {
    if (mesh.triangles.empty()) {
        return Error{ErrorKind::Input, name, "the mesh has no triangles", "at least one face", ""};
    }
    for (glm::dvec3& normal : mesh.normals) {
        const double length = glm::length(normal);
        if (!(length > 0.0)) {
            mesh.normals.clear();
            break;
        }
        normal /= length;
    }
    return mesh;
}

Result<Mesh> read_mesh(const std::string& path) {
    const std::string extension = extension_of(path);
    const bool known = extension == ".obj" || extension == ".off" || extension == ".ply";
    if (!known) {
        return Error{ErrorKind::Input, path, "the mesh file is of an unknown type",
                     "a name that ends in .obj, .off or .ply", ""};
    }
    Result<std::string> bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    if (extension == ".obj") return read_obj(*bytes, path);
    if (extension == ".off") return read_off(*bytes, path);
    return read_ply(*bytes, path);
}

}  // namespace repousse::host
