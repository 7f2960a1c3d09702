#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace repousse::reference {

/// A corner of a finished triangle: integer texture coordinates and the displaced position, whose
/// bits are its name (two corners are the same vertex if all three doubles are equal).
struct LeafCorner {
    std::array<int64_t, 2> uv{};
    std::array<double, 3> position{};
};

/// A finished triangle and the base triangle it came from.
struct LeafTriangle {
    std::array<LeafCorner, 3> corners{};
    uint32_t base = 0;
};

/// What a crack-free tessellation must have none of.
struct LeafReport {
    std::size_t triangles = 0;
    std::size_t vertices = 0;    ///< distinct (uv, position) pairs
    std::size_t open_edges = 0;  ///< half-edges without a partner, the base mesh's rim excepted:
                                 ///< T-vertices and cracks both show as these
    std::size_t flipped = 0;     ///< sign of the texture area differs from the base triangle's
    std::size_t zero_area = 0;   ///< texture area zero though the base triangle's is not
};

/// Judges leaves by names alone, without tolerance. `base` holds the displaced base triangles (a
/// run with generation cap 0), indexed by LeafTriangle::base; its unmatched edges are the rim.
LeafReport check_leaves(const std::vector<LeafTriangle>& leaves,
                        const std::vector<LeafTriangle>& base);

/// FNV-1a over the leaf set, independent of order: each triangle rotated to its smallest (u, v),
/// rows of six little-endian int64 sorted.
uint64_t hash_leaves(const std::vector<LeafTriangle>& leaves);

/// A lattice of sample points in the x, y plane: x = x0 + i dx, y = y0 + j dy.
struct SampleLattice {
    int columns = 0;
    int rows = 0;
    double x0 = 0, dx = 1, y0 = 0, dy = 1;
};

/// Vertical error of a height field against the surface it approximates.
struct HeightError {
    double rms = 0;
    double max = 0;
    std::size_t samples = 0;  ///< lattice points that some triangle covers
};

/// Samples the piecewise-linear z of the leaves, which must be a height field over x and y, at
/// the lattice and compares it with `expected(column, row)`.
HeightError height_error(const std::vector<LeafTriangle>& leaves, const SampleLattice& lattice,
                         const std::function<double(int, int)>& expected);

}  // namespace repousse::reference
