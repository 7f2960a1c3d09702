#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "datapath/units/strip.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/reference/coverage.h"

namespace repousse::test {

using GridPoint = std::array<int32_t, 3>;
using GridTriangle = std::array<GridPoint, 3>;

/// Three corners with ids 0, 1, 2 and no data.
std::array<SweepCorner, 3> corners_of(const GridTriangle& points);

/// The same with data of `bits` random bits and a sign.
std::array<SweepCorner, 3> with_data(const GridTriangle& points, std::mt19937_64& random,
                                     int bits = 31);

/// A name of the device as the verifier writes it.
reference::CoverVertex cover_vertex(const VertexName& name, const SweepTriangle& triangle);

/// Setup, sweep line and strip in a row, and the verifier behind them.
class SweepChain {
public:
    explicit SweepChain(const SweepLineOptions& sweep = {}, const TriangleSetupOptions& setup = {});

    /// Remeshes a triangle; the result is in triangles().
    void remesh(const std::array<SweepCorner, 3>& corners);

    /// Remeshes a triangle without data and judges the cover.
    reference::CoverReport cover(const GridTriangle& points);

    using Triangles = std::vector<std::array<SweepVertex, 3>>;
    const Triangles& triangles() const { return triangles_; }
    const SweepTriangle& base() const { return base_; }

    TriangleSetup setup;
    SweepLine sweep;
    Strip<SweepVertex> strip;

private:
    template <class Sink>
    void each_triangle(const std::array<SweepCorner, 3>& corners, Sink&& sink);

    SweepTriangle base_;
    StripTriangles<SweepVertex> made_;
    Triangles triangles_;
    reference::CoverageChecker checker_;
};

/// A name that can be sorted, and the data that came with it.
using VertexKey = std::tuple<int, int, int, int>;
using VertexData = std::array<int32_t, kSweepComponents>;

/// Adds the vertices of the chain's last triangle; returns how many had a known name but other
/// bits.
std::size_t collect_vertices(const SweepChain& chain, std::map<VertexKey, VertexData>& vertices);

/// The kinds of random triangles that a remesher meets, or should survive.
enum class TriangleKind {
    Tiny,      ///< corners in 0..6
    Small,     ///< in 0..20
    Medium,    ///< in 0..100
    Large,     ///< in +-400
    Facing,    ///< 40 x 40 x 3
    Edgewise,  ///< 3 x 40 x 40
    Thin,      ///< nearly collinear
    FarThin,   ///< nearly collinear, up to +-4096
    TwoEqual,
    Collinear,
    Point,
};
inline constexpr int kTriangleKinds = 11;
std::string name_of(TriangleKind kind);
GridTriangle random_triangle(TriangleKind kind, std::mt19937_64& random);

/// A triangle of the n-th kind by turns, the largest kinds and the point left out.
GridTriangle mixed_triangle(int n, std::mt19937_64& random);

/// Corners uniform in a square of `size` at depth 0.
GridTriangle flat_triangle(int size, std::mt19937_64& random);

}  // namespace repousse::test
