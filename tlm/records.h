#pragma once

#include <array>
#include <cstdint>

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

/// A finished triangle.
struct OutputRecord {
    struct Corner {
        std::array<int32_t, 2> uv;
        std::array<int32_t, 3> displaced;
        std::array<int32_t, 3> displaced_normal;
        uint32_t tag;  ///< adaptive: the generation; sweep: the name, pack_name()
    };
    uint32_t base;   ///< index of the base triangle
    uint32_t depth;  ///< adaptive: digits of the path
    std::array<uint64_t, 2> digits;
    std::array<Corner, 3> corners;
};
static_assert(sizeof(OutputRecord) == 136);

/// A vertex's name in a word: kind, part, a, b from the top; 2, 2, 14 and 14 bits. Steps of an edge
/// are below 8192 and grid coordinates s14, so nothing is lost.
uint32_t pack_name(const VertexName& name);
VertexName unpack_name(uint32_t word);

VertexRecord record_of(const Vertex<Fixed>& vertex);
SweepRecord record_of(const SweepBase<Fixed>& base);
OutputRecord record_of(const OutputTriangle<Fixed>& triangle);
OutputRecord::Corner corner_of(const SweepOutputVertex<Fixed>& vertex);
OutputRecord::Corner corner_of(const FineVertex<Fixed>& vertex);

Vertex<Fixed> vertex_of(const VertexRecord& record);
void read_record(const OutputRecord& record, OutputTriangle<Fixed>& triangle);
void read_record(const OutputRecord& record, SweepOutput<Fixed>& triangle);

}  // namespace repousse::shell
