#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/sweep_draw.h"
#include "datapath/sweep_items.h"

namespace repousse::shell {

/// What lies in memory between the driver and the device, in the host's byte order.

/// A base vertex: raw values in the profile's formats.
struct VertexRecord {
    std::array<int32_t, 2> uv;
    std::array<int32_t, 3> position;
    std::array<int32_t, 3> normal;
    std::array<int32_t, 3> tangent;
    int32_t handedness;  ///< +1 or -1
};
static_assert(sizeof(VertexRecord) == 48);

/// A base triangle of sweep-line remeshing.
struct SweepRecord {
    std::array<uint32_t, 3> vertices;
    int32_t max_displacement;  ///< raw `displacement`, not negative
    uint32_t flags;            ///< kDirect
};
static_assert(sizeof(SweepRecord) == 20);

enum SweepFlag : uint32_t {
    kDirect = 1,  ///< not displaced
};

/// A finished triangle of adaptive tessellation.
struct OutputRecord {
    struct Corner {
        std::array<int32_t, 2> uv;
        std::array<int32_t, 3> displaced;
        std::array<int32_t, 3> displaced_normal;
        std::array<int32_t, 3> colour;  ///< red, green, blue; 0 without shade
        uint32_t generation;
    };
    uint32_t base;   ///< index of the base triangle
    uint32_t depth;  ///< digits of the path
    std::array<uint64_t, 2> digits;
    std::array<Corner, 3> corners;
};
static_assert(sizeof(OutputRecord) == 168);

/// What sweep-line remeshing writes: vertices of the fine mesh; and triangles, which refer to
/// vertices by how many have been written before them in the frame. Both as the datapath has them.
using FineRecord = SweepOutputVertex<Fixed>;
static_assert(sizeof(FineRecord) == 52 && std::is_trivially_copyable_v<FineRecord>);
static_assert(sizeof(VertexName) == 6 && offsetof(VertexName, a) == 2);
static_assert(offsetof(FineRecord, uv) == 8 && offsetof(FineRecord, displaced) == 16 &&
              offsetof(FineRecord, displaced_normal) == 28 && offsetof(FineRecord, colour) == 40);
using FineTriangleRecord = FineTriangle;
static_assert(sizeof(FineTriangleRecord) == 16);

VertexRecord record_of(const Vertex<Fixed>& vertex);
SweepRecord record_of(const SweepBase<Fixed>& base);
OutputRecord record_of(const OutputTriangle<Fixed>& triangle);

Vertex<Fixed> vertex_of(const VertexRecord& record);
void read_record(const OutputRecord& record, OutputTriangle<Fixed>& triangle);

}  // namespace repousse::shell
