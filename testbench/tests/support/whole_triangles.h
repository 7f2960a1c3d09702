#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/pipelines/sweep_draw.h"

namespace repousse::test {

/// A fine triangle with its vertices, for comparisons between meshes that number them differently.
template <class P>
struct WholeTriangle {
    uint32_t base = 0;
    std::array<SweepOutputVertex<P>, 3> corners;
};

template <class P>
std::vector<WholeTriangle<P>> whole_triangles(const SweepMesh<P>& mesh) {
    std::vector<WholeTriangle<P>> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const FineTriangle& t : mesh.triangles) {
        triangles.push_back({t.base, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}});
    }
    return triangles;
}

}  // namespace repousse::test
