#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "datapath/transaction.h"
#include "datapath/units/bump.h"
#include "datapath/units/displace.h"
#include "datapath/units/edge_iter.h"
#include "datapath/units/mid_vertex.h"
#include "datapath/units/normal_test.h"
#include "datapath/units/shade.h"
#include "datapath/units/split.h"
#include "datapath/units/vertex_transform.h"

namespace repousse {

/// One number that a unit counted.
struct CounterRow {
    std::string_view unit;
    std::string_view name;
    uint64_t value;
};

/// What the units of adaptive tessellation counted in one draw. They count functions of the data,
/// so bit-accurate levels agree on every one. Units that were not built have no counters.
struct AdaptiveCounters {
    uint64_t stack_peak = 0;
    EdgeIterCounters edge_iter;
    MidVertexCounters mid_vertex;
    TestCounters texcoord_test;
    DisplaceCounters displace;
    SplitCounters split;
    std::optional<VertexTransformCounters> vertex_transform;
    std::optional<TestCounters> view_test;
    std::optional<BumpCounters> bump;
    std::optional<ShadeCounters> shade;
    std::optional<TestCounters> normal_test;
    std::optional<TestCounters> height_test;
    uint64_t height_test_reads = 0;

    /// Every counter under its unit, in pipeline order.
    std::vector<CounterRow> rows() const;
};

/// Adds the rows of one draw to those of the draws before it; a `peak` is the larger one.
void merge_rows(std::vector<CounterRow>& total, const std::vector<CounterRow>& rows);

}  // namespace repousse
