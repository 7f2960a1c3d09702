// edge_iter: which edges a triangle sends, and which of them may be split at all.

#include "datapath/units/edge_iter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace repousse {
namespace {

Triangle<Fixed> with_generations(int a, int b, int c) {
    Triangle<Fixed> triangle;
    triangle.corners[0].generation = uint8_t(a);
    triangle.corners[1].generation = uint8_t(b);
    triangle.corners[2].generation = uint8_t(c);
    return triangle;
}

TEST(EdgeIter, SendsTheEdgesOneTwoTwoThreeThreeOne) {
    std::vector<Triangle<Fixed>> triangles(5);
    std::vector<Edge<Fixed>> edges(15);
    // What a batch before has left behind.
    for (Edge<Fixed>& edge : edges) {
        edge.ct = edge.vt = edge.undecided = edge.eligible = false;
        edge.nt = edge.sht = edge.split = true;
    }
    EdgeIter<Fixed> unit;
    unit.configure(4);
    unit.run(triangles, edges);
    for (std::size_t t = 0; t < 5; ++t) {
        for (std::size_t e = 0; e < 3; ++e) {
            const Edge<Fixed>& edge = edges[3 * t + e];
            EXPECT_EQ(edge.v1, &triangles[t].corners[e]);
            EXPECT_EQ(edge.v2, &triangles[t].corners[(e + 1) % 3]);
            EXPECT_TRUE(edge.eligible && edge.undecided && edge.ct && edge.vt);
            EXPECT_FALSE(edge.nt || edge.sht || edge.split);
        }
    }
    EXPECT_EQ(unit.counters().items, 15u);
    EXPECT_EQ(unit.counters().capped, 0u);
}

// All caps, all generations, all flags: an edge is eligible if and only if the new vertex's
// generation, max + 1, is within the cap, and no ancestor has found it flat.
TEST(EdgeIter, EligibilityExhaustively) {
    EdgeIter<Fixed> unit;
    std::vector<Edge<Fixed>> edges(3);
    uint64_t capped = 0, known = 0, items = 0;
    for (int cap = 0; cap <= EdgeIter<Fixed>::kMaxCap; ++cap) {
        unit.configure(cap);
        for (int n = 0; n < 16 * 16 * 16 * 8; ++n) {
            Triangle<Fixed> t = with_generations(n & 15, n >> 4 & 15, n >> 8 & 15);
            t.unsplit_edges = uint8_t(n >> 12);
            unit.run(Span<const Triangle<Fixed>>(&t, 1), edges);
            for (unsigned e = 0; e < 3; ++e) {
                const int generation =
                    std::max(t.corners[e].generation, t.corners[(e + 1) % 3].generation) + 1;
                const bool flagged = (t.unsplit_edges & (1u << e)) != 0;
                ASSERT_EQ(edges[e].eligible, generation <= cap && !flagged);
                ASSERT_EQ(edges[e].undecided, edges[e].eligible);
                capped += generation > cap;
                known += flagged && generation <= cap;
                ++items;
            }
        }
    }
    EXPECT_EQ(unit.counters().items, items);
    EXPECT_EQ(unit.counters().capped, capped);
    EXPECT_EQ(unit.counters().known_unsplit, known);
    unit.reset();
    EXPECT_EQ(unit.counters().items, 0u);
}

// Eligibility is a function of the edge alone, or its two triangles could disagree.
TEST(EdgeIter, TheOppositeCornerDoesNotMatter) {
    EdgeIter<Fixed> unit;
    unit.configure(6);
    std::vector<Edge<Fixed>> edges(3);
    for (int opposite = 0; opposite < 16; ++opposite) {
        const Triangle<Fixed> forth = with_generations(5, 3, opposite);
        unit.run(Span<const Triangle<Fixed>>(&forth, 1), edges);
        EXPECT_TRUE(edges[0].eligible);
        const Triangle<Fixed> back = with_generations(3, 5, opposite);
        unit.run(Span<const Triangle<Fixed>>(&back, 1), edges);
        EXPECT_TRUE(edges[0].eligible);
    }
}

}  // namespace
}  // namespace repousse
