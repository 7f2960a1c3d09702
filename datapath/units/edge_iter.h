#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/edge_iter_desc.h"

namespace repousse {

/// What edge_iter needs to know of a triangle: the input ports of the description.
struct EdgeIterIn {
    std::array<uint8_t, 3> generations{};  ///< of the corners
    uint8_t unsplit = 0;                   ///< bit e: edge e is known to be unsplit

    std::array<Word, 4> pack() const {
        return {generations[0], generations[1], generations[2], unsplit};
    }
    static EdgeIterIn unpack(const Word* w) {
        const auto byte = [w](int i) { return static_cast<uint8_t>(w[i]); };
        return {{byte(0), byte(1), byte(2)}, byte(3)};
    }
};
static_assert(ports_are(kEdgeIterDesc, PortKind::Input,
                        {"generation1", "generation2", "generation3", "unsplit"}));
static_assert(ports_are(kEdgeIterDesc, PortKind::Config, {"cap"}));

/// One of the three beats that it makes of a triangle.
struct EdgeIterOut {
    uint8_t number = 0;
    bool eligible = false;
    bool last = false;

    std::array<Word, 3> pack() const { return {number, eligible, last}; }
};
static_assert(ports_are(kEdgeIterDesc, PortKind::Output, {"number", "eligible", "last"}));

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

    /// One item of the unit: its three beats.
    std::array<EdgeIterOut, 3> operator()(const EdgeIterIn& in) const;

    /// Writes three edges for each triangle; `edges` has 3 * triangles.size() places. The edges
    /// refer to the triangles' corners.
    void run(Span<const Triangle<P>> triangles, Span<Edge<P>> edges);

    const EdgeIterCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// Whether the vertex between ends of these generations would be beyond the cap.
    bool capped(int generation1, int generation2) const {
        return (generation1 > generation2 ? generation1 : generation2) >= cap_;
    }

    int cap_ = 0;
    EdgeIterCounters counters_;
};

}  // namespace repousse
