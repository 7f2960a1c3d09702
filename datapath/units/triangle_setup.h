#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/sweep_items.h"
#include "datapath/units/triangle_setup_desc.h"

namespace repousse {

/// The registers of the triangle setup.
struct TriangleSetupRegisters {
    int32_t guard = kGridLimit;  ///< corners are clamped to +-guard grid units
    int32_t z_offset = 0;        ///< grid units, subtracted from z before it is clamped
};

/// How the unit is built.
struct TriangleSetupOptions {
    AdderKind adder = AdderKind::Exact;
    int guard_bits = 0;  ///< 0..13 below the LSB of vertex data; the exact kind has none
    int components = kSweepComponents;
    bool footprints = false;  ///< steps of texture coordinates and c are wanted by `footprint`
    int data_bits = 32;       ///< of such a step of u c or v c, and ...
    int c_bits = 32;          ///< ... of c: more saturates
};

/// What `triangle_setup` counted.
struct TriangleSetupCounters {
    uint64_t items = 0;
    uint64_t clamped = 0;             ///< corners that the guard band moved: sampled too coarsely
    uint64_t single = 0;              ///< all corners on one grid point
    uint64_t collinear = 0;           ///< of the others: no area in either plane
    std::array<uint64_t, 3> forms{};  ///< by SweepCase
    uint64_t divisions = 0;
};

/// Base triangle setup (Gumhold and Huettner 3.4.1 to 3.4.3; step 6 for 4.1).
///
///  1. corners to the grid, round half up, one function of the vertex alone, then the guard clamp;
///  2. main direction of each edge: the largest difference, x before y before z; that difference
///     is its number of steps, a function of the two ends alone;
///  3. primary edge: the one with most steps, then the lowest number. The third corner always lies
///     within its range, or another edge would be longer. Its main direction is the sweep axis;
///     of the other two axes that with the larger determinant becomes the side axis, then the
///     lower one. A -> B is the primary edge in increasing sweep direction, C is the third corner,
///     above it after mirroring;
///  4. roof, increasing or decreasing, hence two halves, each swept so that its edge rises;
///  5. differences: edges by their steps, gradients by the determinant, from integer corners
///     (instead of equations 9 to 11, which subtract rounded products and fail on slivers):
///       D      = (sB-sA)(yC-yA) - (yB-yA)(sC-sA)
///       Dsweep = ((XB-XA)(yC-yA) - (XC-XA)(yB-yA)) / D
///       Dside  = ((XC-XA)(sB-sA) - (XB-XA)(sC-sA)) / D
///     D is 0 only if the corners are collinear in space; then nothing lies inside;
///  6. for footprints the same quotients of u c, v c and c, rounded towards zero: a division gives
///     them with the exact ones, and turning an edge round only changes their sign. Edges count
///     from the end with the lower id, so both triangles have the same bits, with every adder.
class TriangleSetup {
public:
    explicit TriangleSetup(const TriangleSetupOptions& options = {}) : options_(options) {
        if (options_.adder == AdderKind::Exact) options_.guard_bits = 0;
    }

    void configure(const TriangleSetupRegisters& registers) { registers_ = registers; }

    /// Between draws: the components of a vertex that are in use, at most kSweepComponents.
    void use_components(int components) { options_.components = components; }
    void use_footprints(bool wanted) { options_.footprints = wanted; }

    /// Step 1: a grid position with kGridFractionBits fraction bits to its slot.
    std::array<int32_t, 3> slot(const std::array<int32_t, 3>& position);

    /// Steps 2 to 5 for corners within +-kGridLimit.
    void operator()(const std::array<SweepCorner, 3>& corners, SweepTriangle& out);

    const TriangleSetupOptions& options() const { return options_; }
    const TriangleSetupCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// The local frame of one triangle, and what follows from it.
    struct Frame {
        std::array<int, 3> abc{};        ///< corners A, B, C
        std::array<int32_t, 3> s{};      ///< sweep coordinate of each corner of the input
        std::array<int32_t, 3> y{};      ///< side coordinate, mirrored
        std::array<int32_t, 3> steps{};  ///< of each edge of the input, 0 for length 0
        bool odd = false;                ///< A, B, C is an odd permutation of the input
    };

    bool choose_plane(SweepTriangle& out, Frame& frame) const;
    void set_gradients(SweepTriangle& out, const Frame& frame) const;
    void set_primary(SweepTriangle& out, const Frame& frame) const;
    PrimaryWalk primary_walk(const SweepTriangle& out, const Frame& frame, int from, int to) const;
    void set_halves(SweepTriangle& out, const Frame& frame) const;
    EdgeWalk edge_walk(const SweepTriangle& out, const Frame& frame, int from, int to) const;
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    static int32_t at_least_one(int32_t steps) { return steps > 1 ? steps : 1; }

    // Whether an edge's steps are counted from `from`: the same answer for both triangles on the
    // edge. Corners without ids of their own are told apart by their number.
    static bool is_canonical(const SweepTriangle& triangle, int from, int to) {
        const uint32_t p = triangle.corners[index(from)].id, q = triangle.corners[index(to)].id;
        return p != q ? p < q : from < to;
    }

    SweepVector edge_difference(const SweepTriangle& out, int from, int to, int32_t steps) const;
    SweepVector edge_start(const SweepTriangle& out, int from, int to, int32_t steps,
                           const SweepVector& difference) const;
    int64_t rounded_quotient(int64_t numerator, int64_t divisor) const;
    void set_texel_steps(SweepTriangle& out, const Frame& frame) const;
    template <class Numerator>
    TexelStep<int32_t> texel_step(Numerator&& numerator, int64_t divisor) const;

    TriangleSetupOptions options_;
    TriangleSetupRegisters registers_;
    TriangleSetupCounters counters_;
};

}  // namespace repousse
