#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"

namespace repousse {

/// What `edge_iter` counted.
struct EdgeIterCounters {
    uint64_t items = 0;          ///< edges sent on
    uint64_t capped = 0;         ///< of these, not eligible because of the generation cap
    uint64_t known_unsplit = 0;  ///< of these, not eligible because an ancestor tested them
};

/// Get Triangle's second half (Doggett and Hirche 3.1): sends the edges 12, 23, 31 of a triangle
/// through the one tests pipeline, one after the other.
///
/// An edge may only be split if its new vertex stays within the generation cap. The printed
/// recursion need not end: along long thin triangles it repeats a 2-cycle at 1/3 and 2/3 for ever.
/// A generation is a function of the two end vertices alone, so both triangles at the edge agree,
/// and every step of a chain raises it, so chains have at most 3 * cap steps.
template <class P>
class EdgeIter {
public:
    static constexpr int kMaxCap = 15;  ///< generations have 4 bits

    /// `cap`: the highest generation a new vertex may have, 0 (never split) to kMaxCap.
    void configure(int cap) { cap_ = cap; }

    /// Writes three edges for each triangle; `edges` has 3 * triangles.size() places. The edges
    /// refer to the triangles' corners.
    void run(Span<const Triangle<P>> triangles, Span<Edge<P>> edges);

    const EdgeIterCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    int cap_ = 0;
    EdgeIterCounters counters_;
};

}  // namespace repousse
