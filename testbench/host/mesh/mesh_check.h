#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// For each vertex the smallest index of a vertex with the same position: equal bits, except that
/// -0 and +0 are one position. Seam copies meet here.
std::vector<std::uint32_t> weld(const std::vector<glm::dvec3>& positions);

/// What a mesh is made of, judged by welded positions.
struct MeshDiagnosis {
    std::size_t vertices = 0;         ///< as stored
    std::size_t welded_vertices = 0;  ///< distinct positions in use
    std::size_t triangles = 0;
    std::size_t edges = 0;                 ///< distinct edges of non-degenerate triangles
    std::size_t boundary_edges = 0;        ///< in one triangle
    std::size_t non_manifold_edges = 0;    ///< in three triangles or more
    std::size_t inconsistent_edges = 0;    ///< in two triangles that run along it the same way
    std::size_t degenerate_triangles = 0;  ///< two equal corners, or no area
    std::size_t unused_vertices = 0;
    std::size_t components = 0;  ///< connected by shared welded vertices
    std::int64_t euler = 0;      ///< vertices - edges + triangles
    glm::dvec3 low{0.0};         ///< bounding box of the used vertices
    glm::dvec3 high{0.0};

    bool closed() const { return boundary_edges == 0; }
    bool manifold() const { return non_manifold_edges == 0; }
    bool oriented() const { return inconsistent_edges == 0; }
};

/// Diagnoses a mesh; nothing is repaired.
MeshDiagnosis mesh_check(const Mesh& mesh);

/// One line for people: "closed 2-manifold, 1 component, 288 edges" and what is wrong, if anything.
std::string describe(const MeshDiagnosis& diagnosis);

}  // namespace repousse::host
