#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <unordered_set>

#include "datapath/pipelines/draw.h"
#include "testbench/cosim/vector_file.h"

namespace repousse::cosim {

/// The edges of real runs as transactions of the Tessellation Tests: a draw runs through the bare
/// pipeline, and what enters and leaves the tests there is recorded.
class TestedEdges {
public:
    /// Edges in one portion; all are under the draw's registers, with its summed-area table.
    static constexpr std::size_t kPortion = 4096;

    explicit TestedEdges(const Profile& profile) : profile_(profile) {}

    /// Tessellates a draw and hands its edges on, portion by portion, with the decisions that the
    /// pipeline has taken. Edges that may not be split are among them, as the hardware sees them.
    void run(const AdaptiveDraw<Fixed>& draw, const std::function<void(const Recorded&)>& take);

    uint64_t edges() const { return edges_; }

    /// Edges that differ in registers, table or ends, whichever end comes first: an edge between
    /// two triangles comes by twice, and again if it stays whole while they are split.
    uint64_t distinct() const { return seen_.size(); }

private:
    Profile profile_;
    uint64_t edges_ = 0;
    std::unordered_set<uint64_t> seen_;  // hashes
};

}  // namespace repousse::cosim
