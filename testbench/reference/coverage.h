#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace repousse::reference {

/// A vertex of a remeshed base triangle by its name, from which everything else follows.
struct CoverVertex {
    enum class Kind : uint8_t { Corner, Edge, Interior };
    Kind kind = Kind::Corner;
    int part = 0;   ///< corner 0..2; edge e, from corner e to corner (e+1)%3
    int64_t a = 0;  ///< Edge: step counted from corner e. Interior: coordinate on the first axis
    int64_t b = 0;  ///< Interior: coordinate on the second axis
};

using CoverTriangle = std::array<CoverVertex, 3>;

/// A base triangle on the integer grid, and the two axes interior vertices are given in.
struct CoverBase {
    std::array<std::array<int64_t, 3>, 3> corners{};
    int axis_a = 0;
    int axis_b = 1;
};

/// What is wrong with a cover. All zero: the base triangle is covered exactly once.
struct CoverReport {
    std::size_t triangles = 0;
    std::size_t bad_names = 0;     ///< an edge step or an interior point that does not exist
    std::size_t not_positive = 0;  ///< zero or negative area
    std::size_t open_edges = 0;    ///< half-edges without a partner, or with two
    bool area_differs = false;     ///< the areas do not sum to the base triangle's

    bool exact() const {
        return triangles > 0 && bad_names == 0 && not_positive == 0 && open_edges == 0 &&
               !area_differs;
    }
};

/// Judges covers of base triangles in exact arithmetic.
///
/// A vertex is a row of three barycentric weights: a corner is a unit row, point k of an edge of n
/// steps (n-k, k)/n on its two corners, an interior point follows from the plane of the two axes. n
/// is the largest coordinate difference of the edge, at least 1. Weights are symbolic: a base
/// triangle whose corners are collinear, or coincide, has area too. A triangle's area is the
/// determinant of its rows; all must be positive and sum to 1 = that of the base. The half-edges,
/// together with the three edge sequences walked backwards, must pair up.
///
/// Corners lie within +-4096, so weights have 27 bits, 2x2 minors 55, determinants 83.
class CoverageChecker {
public:
    void start(const CoverBase& base);
    void add(const CoverTriangle& triangle);
    CoverReport finish();

private:
    __extension__ using Wide = __int128;

    /// A vertex's weights times its denominator, which is `scale_[denominator]`, or 1 if negative.
    struct Row {
        std::array<int64_t, 3> weight{};
        int denominator = -1;  ///< 0..2: that edge's steps; 3: twice the projected area
        uint64_t id = 0;
    };

    bool row_of(const CoverVertex& vertex, Row& row) const;
    Wide scaled_area(const std::array<Row, 3>& rows) const;
    void add_half_edge(uint64_t from, uint64_t to);
    std::size_t count_open_edges();

    CoverBase base_;
    std::array<int64_t, 4> scale_{};  ///< steps of the edges, then twice the projected area
    int64_t sign_ = 1;                ///< of the projected area
    std::array<uint64_t, 3> edge_ids_{};
    uint64_t interior_ids_ = 0;
    std::array<int64_t, 2> low_{}, high_{};
    Wide area_ = 0;  ///< times all of scale_
    std::vector<uint64_t> half_edges_;
    CoverReport report_;
};

}  // namespace repousse::reference
