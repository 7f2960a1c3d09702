#pragma once

#include <array>
#include <cstdint>

namespace repousse {

/// Texture coordinates in texels, fixed point with the fraction bits of the profile's `uv`. They
/// are integers at every level: a midpoint is (a+b)>>1, the same from both sides of an edge.
struct Uv {
    int32_t x = 0;
    int32_t y = 0;
};

inline bool operator==(Uv a, Uv b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(Uv a, Uv b) { return !(a == b); }

/// A vector in world units (raw in the profile's format, or double at level ref).
template <class V>
struct Vec3 {
    V x{};
    V y{};
    V z{};
};

template <class V>
inline bool operator==(const Vec3<V>& a, const Vec3<V>& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/// Linear light, in the format `colour` or `light`.
template <class V>
struct Colour {
    V red{};
    V green{};
    V blue{};
};

template <class V>
inline bool operator==(const Colour<V>& a, const Colour<V>& b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue;
}

/// A displaced vertex on the screen, in pixels; `near` says that it is not in front of the near
/// plane, so that x and y mean nothing.
template <class V>
struct ScreenPoint {
    V x{};
    V y{};
    bool near = false;
};

/// A vertex as the Pass or Tessellate unit hands it on (Doggett and Hirche 3.1.5).
template <class P>
struct Vertex {
    using V = typename P::Value;
    Uv uv;
    Vec3<V> position;          ///< P, on the base surface
    Vec3<V> displaced;         ///< P' = P + D N (equation 1)
    Vec3<V> normal;            ///< N, normalised
    Vec3<V> tangent;           ///< T, normalised
    Vec3<V> map_normal;        ///< N_D, as read from the map
    Vec3<V> displaced_normal;  ///< N', normalised
    ScreenPoint<V> screen;     ///< P' in pixels
    Colour<V> colour;          ///< of P' in the scene's light
    int8_t handedness = 1;     ///< the bitangent is handedness * (N x T)
    uint8_t generation = 0;    ///< 0 for base vertices, max of the parents + 1 for midpoints
};

/// Where an item stands in the architectural order: its base triangle, then one digit (the push
/// index among its siblings) a split. Depth is at most 3 * 15 with 4-bit generations, so two words
/// of 2-bit digits suffice.
struct Path {
    uint32_t base = 0;
    uint8_t depth = 0;
    std::array<uint64_t, 2> digits{};

    Path child(unsigned digit) const {
        Path next = *this;
        next.digits[depth / 32] |= uint64_t(digit) << (2 * (depth % 32));
        ++next.depth;
        return next;
    }
};

/// A triangle in flight. Corners are in cyclic order 1, 2, 3; edge e runs from corner e to e+1.
template <class P>
struct Triangle {
    std::array<Vertex<P>, 3> corners;
    Path path;
    uint8_t unsplit_edges = 0;  ///< bit e: edge e was tested in an ancestor and is not split
};

/// A triangle that another one turns into, by reference: its corners belong to the parent and to
/// the edges of the parent's batch.
template <class P>
struct Child {
    std::array<const Vertex<P>*, 3> corners{};
    Path path;
    uint8_t unsplit_edges = 0;
};

/// An edge on its way through the tests, with the vertex that would split it. The ends belong to
/// the triangle of the same batch.
template <class P>
struct Edge {
    const Vertex<P>* v1 = nullptr;
    const Vertex<P>* v2 = nullptr;
    Vertex<P> mid;
    bool eligible = true;   ///< below the generation cap, and not known to be unsplit
    bool undecided = true;  ///< some test may still be needed; the skip flag, inverted
    bool ct = true;         ///< Tex Coord Test
    bool vt = true;         ///< View Test
    bool nt = false;        ///< Normal Test
    bool sht = false;       ///< Summed Height Test
    bool split = false;     ///< the decision

    /// Whether the new vertex's attributes are wanted: before the normal test by every edge that
    /// is undecided (by all when eager), otherwise after the decision by those that are split.
    bool wants_attributes(bool for_test, bool eager) const {
        return for_test ? undecided || eager : split;
    }
};

}  // namespace repousse
