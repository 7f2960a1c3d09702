#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace repousse::reference {

/// Texture coordinates in texels, as integers with some number of fraction bits.
using Uv = std::array<int64_t, 2>;

/// The displacement map: D = h * scale + bias in world units.
struct DisplacementMap {
    int width = 1;
    int height = 1;
    bool wrap = false;
    bool bilinear = false;
    std::vector<uint16_t> heights;  ///< row by row
    double scale = 1.0;
    double bias = 0.0;
    glm::dvec2 texel_size{1.0};  ///< world units, for the finite differences of the normals
};

/// The sum and the number of a box's texels.
struct MapBox {
    int64_t sum = 0;
    int64_t area = 0;
};

/// Reads a displacement map in the most obvious way: periodic coordinates by the remainder, box
/// sums by visiting every texel.
class MapReader {
public:
    /// The map must outlive the reader. `wrap` is what the reader does, whatever the map says.
    MapReader(const DisplacementMap& map, int uv_frac, bool wrap)
        : map_(map), one_(int64_t(1) << uv_frac), wrap_(wrap) {}

    /// The texel that uv lies in: its floor, neither clamped nor wrapped.
    Uv texel_of(const Uv& uv) const { return {floor_of(uv[0]), floor_of(uv[1])}; }

    /// Height in LSB at uv: of the texel, or between the four texel centres around it.
    double height(const Uv& uv) const;

    /// normalise(-dh/dx, -dh/dy, 1) of the texel that uv lies in; central differences, one-sided
    /// at a border.
    glm::dvec3 normal(const Uv& uv) const;

    /// The texels [floor(centre - half), floor(centre + half)) in both directions, clipped to a
    /// clamped map. With `widen` an axis without texels becomes one texel wide.
    MapBox box(const Uv& centre, const Uv& half, bool widen) const;

private:
    int64_t floor_of(int64_t u) const { return u >= 0 ? u / one_ : -((-u + one_ - 1) / one_); }
    int64_t texel(int64_t x, int64_t y) const;
    double slope(int64_t x, int64_t y, int axis) const;
    std::array<int64_t, 2> side(int64_t centre, int64_t half, int64_t size, bool widen) const;

    const DisplacementMap& map_;
    int64_t one_;
    bool wrap_;
};

}  // namespace repousse::reference
