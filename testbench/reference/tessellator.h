#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "testbench/reference/leaf_mesh.h"
#include "testbench/reference/map_reader.h"

namespace repousse::reference {

/// Known mistakes of tessellation hardware. Each makes the two triangles at an edge disagree, so
/// each must show in `check_leaves`.
enum class Mistake {
    None,
    TruncatingMidpoint,  ///< U12 = U1 + (U2 - U1) / 2, rounded towards zero as C and Verilog do
    SignedShiftBoxes,    ///< half-extents from the signed difference; square boxes are immune
    ClampedSeam,         ///< a periodic map read as if it ended at its border
};

/// A vertex of the base mesh; uv in texels with `uv_frac` fraction bits.
struct TessellatorVertex {
    Uv uv{};
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
    glm::dvec3 tangent{1.0, 0.0, 0.0};
    double handedness = 1.0;
};

/// The view test: screen = centre + focal * (right . e, up . e) / (forward . e), e = P' - eye.
struct TessellatorView {
    glm::dvec3 eye{0.0}, right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};
    double near = 1e-6;
    glm::dvec2 focal{1.0}, centre{0.0};
    double threshold_px = 0.0;
};

/// Everything that decides a tessellation. Without a normal and a height threshold every edge
/// counts as detailed.
struct TessellatorInput {
    std::vector<TessellatorVertex> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    DisplacementMap map;
    int uv_frac = 8;
    std::optional<int> cap;  ///< highest generation; absent: as printed, unbounded
    bool cap_depth = false;  ///< cap a triangle's splits, not the generation
    std::optional<double> normal_threshold;
    bool map_space = false;                   ///< compare N_D and N apart instead of N'
    std::optional<int64_t> height_threshold;  ///< height LSB, or height LSB x texel^2
    bool sum = false;                         ///< SUM as printed instead of AVG
    bool literal = false;                     ///< boxes |du| by |dv| instead of square ones
    std::optional<TessellatorView> view;
    Mistake mistake = Mistake::None;
    uint64_t visit_limit = 10'000'000;  ///< give up after so many triangles
};

struct Tessellation {
    std::vector<LeafTriangle> leaves;  ///< in no particular order
    std::vector<LeafTriangle> flat;    ///< the same, named by their places on the base surface:
                                       ///< T-vertices show even where a seam gapes
    uint64_t visits = 0;               ///< triangles looked at
    std::array<uint64_t, 4> by_split_edges{};
    std::size_t deepest = 0;  ///< most splits between a base triangle and a leaf
    bool finished = false;    ///< false: the visit limit stopped it
};

/// The recursion of Doggett and Hirche (2000), section 2, with the corrections of its formulae,
/// done in the most obvious way: doubles for attributes, exact integers for texture coordinates,
/// and box sums by visiting every texel.
Tessellation tessellate(const TessellatorInput& input);

}  // namespace repousse::reference
