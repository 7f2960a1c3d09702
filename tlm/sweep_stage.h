#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/sweep_line.h"
#include "tlm/records.h"
#include "tlm/stage.h"

namespace repousse::shell {

/// What sweep-line remeshing hands on: base vertices, base triangles, then steps of the sweep line
/// with the vertices of the fine mesh. Batches refer to what their source keeps.

/// Base triangles in a batch. Together with what setup makes of them they stay in the second-level
/// cache.
inline constexpr std::size_t kBatchBases = 32;

/// Steps of the sweep line in a batch; they may belong to several base triangles. Their vertices,
/// one to two each, stay close to the first-level cache.
inline constexpr std::size_t kBatchSweepSteps = 64;

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
    uint32_t steps = 0;
    bool last = false;     ///< the base triangle is complete after them
    bool runaway = false;  ///< it was given up: what the strip holds of it is void
};

/// Steps on their way to the triangle buffer. `vertices` are those of the steps, in their order.
struct FineBatch {
    Span<const FinePiece> pieces;
    Span<const SweepStep> steps;
    Span<FineVertex<Fixed>> vertices;
};

using CornerCall = Call<CornerBatch>;
using FineCall = Call<FineBatch>;

/// The triangle buffer as the controller sees it.
class OrderSink : public virtual sc_core::sc_interface {
public:
    virtual void expect(const OrderToken& token) = 0;
    virtual void push_direct(const OutputRecord& triangle) = 0;
};

/// Finished triangles of a base triangle, by the numbers of their vertices.
struct StripBatch {
    uint32_t base = 0;
    Span<const std::array<uint32_t, 3>> triangles;
    Span<const OutputRecord::Corner> vertices;
};

/// The triangle buffer as the stripping unit sees it.
class TriangleSink : public virtual sc_core::sc_interface {
public:
    virtual void push(const StripBatch& batch) = 0;
    virtual void finish() = 0;  ///< the base triangle is complete
};

}  // namespace repousse::shell
