#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "datapath/pipelines/contexts.h"
#include "datapath/profile.h"
#include "testbench/reference/leaf_mesh.h"

namespace repousse::host {

/// The device's finished triangles as the invariants want them: displaced positions as doubles,
/// exact for both policies.
template <class P>
std::vector<reference::LeafTriangle> leaves_of(Span<const OutputTriangle<P>> triangles,
                                               const Profile& profile) {
    const int frac = std::is_same_v<P, Real> ? 0 : profile.position.frac;
    std::vector<reference::LeafTriangle> leaves(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        leaves[i].base = triangles[i].path.base;
        for (std::size_t k = 0; k < 3; ++k) {
            const OutputVertex<P>& v = triangles[i].corners[k];
            leaves[i].corners[k] = {
                {v.uv.x, v.uv.y},
                {std::ldexp(double(v.displaced.x), -frac), std::ldexp(double(v.displaced.y), -frac),
                 std::ldexp(double(v.displaced.z), -frac)}};
        }
    }
    return leaves;
}

}  // namespace repousse::host
