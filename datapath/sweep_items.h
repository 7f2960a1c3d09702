#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"

namespace repousse {

/// What sweep-line remeshing passes from unit to unit. Two frames are in use. The *grid* is the
/// integer lattice of rounded corner positions, common to all triangles. The *local frame* is one
/// triangle's remeshing plane: the sweep coordinate of the grid, and its side coordinate, negated
/// where that puts the third corner above the primary edge.

/// Most components of vertex data. In their order: position 3, normal 3, texture 2, c = w_scale /
/// w; and, where a frame of tangents is wanted, tangent 3 and handedness.
inline constexpr int kSweepComponents = 13;
inline constexpr int kInverseWComponent = 8;
inline constexpr int kPlainComponents = 9;  ///< without tangents
/// Places in a vector, those behind the components being 0: loops of constant length are faster.
inline constexpr int kSweepPlaces = 16;

/// Corners lie within +-4096 (s14). Then steps and differences reach 8192 (s15), and twice a step
/// count, which bounds a remainder, 16384 (u15).
inline constexpr int32_t kGridLimit = 4096;

/// How vertex data advance. Slots and names are integers and the same with every kind.
enum class AdderKind : uint8_t {
    Plain,      ///< rounded differences from wherever a walk starts, as printed: edges crack
    Canonical,  ///< rounded differences from one end of an edge, one origin inside: no crack, drift
    Exact,      ///< quotient and remainder: no crack, within half an LSB everywhere
};

enum class NameKind : uint8_t { Corner, Edge, Interior };

/// What a vertex is, independent of its bits. Within a triangle:
///   Corner    `part` = corner 0..2
///   Edge      `part` = edge e from corner e to corner (e+1)%3, a = step counted from the corner
///             with the lower base vertex id, 1 .. steps - 1
///   Interior  a, b = grid coordinates along the sweep and the side axis (s14)
/// With the ids of the corners, or of the triangle, it is the vertex's name in the whole mesh.
struct VertexName {
    NameKind kind = NameKind::Corner;
    uint8_t part = 0;
    int16_t a = 0;
    int16_t b = 0;
};

inline bool operator==(const VertexName& x, const VertexName& y) {
    return x.kind == y.kind && x.part == y.part && x.a == y.a && x.b == y.b;
}

/// A corner of a base triangle after rounding to the grid.
struct SweepCorner {
    uint32_t id = 0;                ///< base vertex: the same for all triangles around it
    std::array<int32_t, 3> slot{};  ///< x, y, z of the grid, s14, within +-kGridLimit
    std::array<int32_t, kSweepComponents>
        data{};  ///< attributes times 1/w, not rounded to the grid
};

/// A vertex or a difference of vertices as the adders hold it. Exact kind: the value is
/// floor(true value + 1/2), and `remainder` counts the rest in units of 1/modulus, modulus being
/// twice the divisor; so a corner starts with remainder = divisor, and no end of an edge is
/// preferred. Other kinds: guard bits below the value, remainder 0.
///
/// Values wrap: a grid point outside a sliver may extrapolate far, but no such point is emitted,
/// and modulo arithmetic brings the walk back exactly.
struct SweepVector {
    std::array<int64_t, kSweepPlaces> value{};
    std::array<int32_t, kSweepPlaces> remainder{};  ///< < modulus: u15 on edges, u27 inside
    int32_t modulus = 1;
};

/// One coordinate of a slot on its way along an edge: the step's quotient and remainder.
struct SlotStep {
    int32_t quotient = 0;
    int32_t remainder = 0;  ///< in units of 1/modulus, u15
};

/// A slot coordinate that advances exactly: `at` = round half up of the true position.
struct SlotWalk {
    int32_t at = 0;
    int32_t remainder = 0;  ///< u15; below 2 * 16384 before the conditional subtraction
    int32_t modulus = 2;    ///< twice the number of steps, u15

    void advance(const SlotStep& step) {
        at += step.quotient;
        remainder += step.remainder;
        if (remainder >= modulus) {
            remainder -= modulus;
            ++at;
        }
    }
};

/// An edge as it is walked, from corner `from` to corner `to`, in unit steps of its main direction.
struct EdgeWalk {
    uint8_t edge = 0;
    uint8_t from = 0;
    uint8_t to = 0;
    int8_t name_step = 1;    ///< +1 if `from` is the canonical end, else -1
    int32_t name_start = 0;  ///< step number of `from`: 0, or `steps`
    int32_t steps = 1;       ///< at least 1: an edge of length 0 is one step
    SlotWalk row;            ///< side coordinate, local frame, at `from`
    SlotStep row_step;
    SweepVector start;  ///< what the accumulator holds at `from`
    SweepVector difference;
};

/// The vertex at a step of an edge. Ends are corners, so that an edge's last accumulated value,
/// which the rounding kinds of adder miss, is never sent.
inline VertexName point_of(const EdgeWalk& edge, int32_t step) {
    if (step == 0) return {NameKind::Corner, edge.from, 0, 0};
    if (step == edge.steps) return {NameKind::Corner, edge.to, 0, 0};
    const int32_t canonical = edge.name_start + edge.name_step * step;
    return {NameKind::Edge, edge.edge, static_cast<int16_t>(canonical), 0};
}

/// One of the two halves of a base triangle: columns from `edge.from` to `edge.to`, below the
/// edge, above the primary edge (Gumhold and Huettner 3.4.3).
struct SubTriangle {
    EdgeWalk edge;
    SlotStep column_step;      ///< of the edge, in columns from its start; modulus 2 * edge.steps
    int32_t columns = 0;       ///< 0: the half has no width and produces nothing
    int8_t direction = 1;      ///< of the sweep
    bool flip = false;         ///< generated triangles are wound the other way
    bool tip = false;          ///< starts at an end of the primary edge
    bool closing = false;      ///< ends at an end of the primary edge
    bool other_left = false;   ///< the first left column is the other side edge (repair R5)
    bool other_right = false;  ///< the last right column is the other side edge (repair R5)
};

/// A walk along the primary edge, from one of its ends inwards.
struct PrimaryWalk {
    EdgeWalk edge;
    SweepVector base;  ///< Vbase at its start, where grid point and corner are one
};

/// How u c, v c and c change over one step. Of integers, half an LSB is the unit that makes it the
/// change over half a step.
template <class V>
struct TexelStep {
    V u{};
    V v{};
    V c{};
};

/// What footprints are made of: steps along the edges, counted from the end with the lower base
/// vertex id, and inside along the sweep and the side axis of the grid.
template <class V>
struct TexelSteps {
    std::array<TexelStep<V>, 3> edges;
    TexelStep<V> sweep;
    TexelStep<V> side;
};

/// The three forms of a triangle above its primary edge (figure 13).
enum class SweepCase : uint8_t { Roof, Increasing, Decreasing };

/// A base triangle, ready for the sweep line.
struct SweepTriangle {
    std::array<SweepCorner, 3> corners;
    int components = kSweepComponents;
    int guard_bits = 0;   ///< below the LSB of every SweepVector
    bool single = false;  ///< all corners on one grid point: one triangle (repair R6)
    SweepCase form = SweepCase::Roof;
    uint8_t sweep_axis = 0;
    uint8_t side_axis = 1;
    int8_t mirror = 1;    ///< -1: the side axis is negated in the local frame
    uint8_t primary = 0;  ///< edge
    int32_t primary_steps = 1;
    int32_t determinant = 0;  ///< twice the projected area, 0 .. 2^26; s28 while it is computed
    uint32_t step_limit = 0;  ///< no column takes more steps: the runaway guard
    std::array<PrimaryWalk, 2> walks;  ///< of each half; the second is unused if `continues`
    bool continues = false;            ///< the second half goes on where the first one ended
    std::array<SubTriangle, 2> halves;
    SweepVector sweep_difference;     ///< one column in increasing sweep direction
    SweepVector side_difference;      ///< one row up in the local frame
    TexelSteps<int32_t> texel_steps;  ///< set only where footprints are wanted
};

/// A vertex on its way out: its name and its data, rounded, still multiplied by 1/w. Components
/// that the triangle does not have are not set.
struct SweepVertex {
    VertexName name;
    std::array<int32_t, kSweepComponents> data{};
};

/// A vertex of the fine mesh behind `perspective`, in the formats of the profile.
template <class P>
struct FineVertex {
    using V = typename P::Value;
    VertexName name;
    Uv uv;                     ///< texels
    Vec3<V> position;          ///< on the base surface
    Vec3<V> normal;            ///< normalised after interpolation (equation 1)
    Vec3<V> tangent;           ///< normalised; unused without bump
    int8_t handedness = 1;     ///< the bitangent is handedness * (N x T)
    LevelRead read;            ///< of the displacement map; the default without filter levels
    Vec3<V> displaced;         ///< P' = P + D N
    Vec3<V> displaced_normal;  ///< N'; unused without bump
};

/// What leaves of a vertex of the fine mesh.
template <class P>
struct SweepOutputVertex {
    VertexName name;
    Uv uv;                                     ///< texels
    Vec3<typename P::Value> displaced;         ///< P'
    Vec3<typename P::Value> displaced_normal;  ///< N'; zero without bump
    Colour<typename P::Value> colour{};        ///< zero without shade
};

/// A triangle of the fine mesh as it leaves: its vertices by their numbers, in the order in which
/// vertices have left since the draw began.
struct FineTriangle {
    uint32_t base = 0;  ///< base triangle
    std::array<uint32_t, 3> vertices{};
};

inline bool operator==(const FineTriangle& a, const FineTriangle& b) {
    return a.base == b.base && a.vertices == b.vertices;
}

/// Where a base triangle goes (Gumhold and Huettner 2.2).
enum class Route : uint8_t {
    Displaced,  ///< through the displacement unit
    Direct,     ///< as it is to the triangle buffer
};

/// What the controller leaves in the triangle buffer for each base triangle: the order of output.
struct OrderToken {
    uint32_t base = 0;
    Route route = Route::Displaced;
};

/// What the stripping unit does with a register (Gumhold and Huettner 2.3).
enum class StripOp : uint8_t {
    Ref,     ///< add the vertex in the register to the strip
    New,     ///< setref: load the register with the next vertex that arrives, and add it
    Column,  ///< setref from the column FIFO
    Split,   ///< setref from the split FIFO
};

/// Where a vertex is kept beside its register, for the next column or the second half.
enum class StripKeep : uint8_t { No, Column, Split };

struct StripCommand {
    StripOp op = StripOp::Ref;
    uint8_t place = 0;  ///< register 0..3
    StripKeep keep = StripKeep::No;
};

/// What one step of the sweep line asks of the stripping unit.
struct StripStep {
    bool init = false;  ///< start a new strip first
    bool flip = false;  ///< with init: the strip's winding
    uint8_t count = 0;
    std::array<StripCommand, 4> commands{};
};

}  // namespace repousse
