#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_buffer.h"
#include "tlm/records.h"
#include "tlm/stage.h"

namespace repousse::shell {

/// What sweep-line remeshing hands on: base vertices, base triangles, then steps of the sweep line
/// with the vertices of the fine mesh. Batches refer to what their source keeps.

/// Base triangles in a batch. Together with what setup makes of them they stay in the second-level
/// cache.
inline constexpr std::size_t kBatchBases = 32;

/// A base vertex on the grid.
struct GridVertex {
    EyePoint<Fixed> eye;
    GridPoint<Fixed> point;
    SweepCorner corner;  ///< `id` is set by the source
};

/// Base vertices on their way to the grid.
struct CornerBatch {
    Span<const Vertex<Fixed>> vertices;
    Span<GridVertex> corners;
};

/// A base triangle that is to be displaced.
struct BaseItem {
    uint32_t base = 0;
    std::array<const GridVertex*, 3> corners{};
    int32_t max_displacement = 0;  ///< raw `displacement`
    bool rejected = false;         ///< clipped: neither set up nor swept
};

/// Base triangles on their way to the sweep line, in order.
struct BaseBatch {
    Span<BaseItem> items;
    Span<SweepTriangle> triangles;  ///< one an item, made by the setup
};

/// Consecutive steps of one base triangle.
struct FinePiece {
    uint32_t base = 0;
    uint32_t runs = 0;
    uint32_t vertices = 0;
    bool last = false;     ///< the base triangle is complete after them
    bool runaway = false;  ///< it was given up: what the strip holds of it is void
    const TexelSteps<int32_t>* texel_steps = nullptr;  ///< the base triangle's; null: no vertices
};

/// Steps on their way to the triangle buffer, of one base triangle or several. `vertices` are those
/// of the steps, in their order.
struct FineBatch {
    Span<const FinePiece> pieces;
    Span<const SweepRun> runs;
    FineVertices<Fixed>& vertices;
};

using CornerCall = Call<CornerBatch>;
using FineCall = Call<FineBatch>;

/// An undisplaced triangle.
using DirectTriangle = repousse::TriangleBuffer<FineRecord>::Direct;

/// The triangle buffer as the controller sees it.
class OrderSink : public virtual sc_core::sc_interface {
public:
    virtual void expect(const OrderToken& token) = 0;
    virtual void push_direct(const DirectTriangle& triangle) = 0;
};

/// The triangle buffer as the stripping unit sees it. Vertices and triangles are those of the base
/// triangle that is under way.
class FineSink : public virtual sc_core::sc_interface {
public:
    /// Vertices first .. first + count - 1 of a batch. The number of the first one.
    virtual uint32_t push(const FineVertices<Fixed>& batch, std::size_t first,
                          std::size_t count) = 0;
    virtual void push(uint32_t base, Span<const std::array<uint32_t, 3>> triangles) = 0;
    virtual void finish() = 0;  ///< the base triangle is complete
};

}  // namespace repousse::shell
