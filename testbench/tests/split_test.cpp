// split: the decision, the four patterns, the diagonal, and what children inherit.

#include "datapath/units/split.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using Ids = std::array<int, 3>;

const Profile kDefault = test::profile_with("default", {});

// A triangle whose corners 1, 2, 3 and midpoints 12, 23, 31 can be told apart by their handedness
// field, and its edges.
struct Fixture {
    Triangle<Fixed> triangle;
    std::array<Edge<Fixed>, 3> edges;
    Split<Fixed> unit{kDefault};
    Children<Fixed> children;

    Fixture() {
        const Uv corners[] = {{0, 0}, {800, 0}, {0, 800}};
        const int8_t ids[] = {12, 23, 31};
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k].uv = corners[k];
            triangle.corners[k].handedness = int8_t(k + 1);
        }
        for (std::size_t e = 0; e < 3; ++e) {
            const auto &a = triangle.corners[e], &b = triangle.corners[(e + 1) % 3];
            edges[e].mid.uv = {(a.uv.x + b.uv.x) / 2, (a.uv.y + b.uv.y) / 2};
            edges[e].mid.handedness = ids[e];
        }
        flat();
        triangle.path = Path{5, 0, {}}.child(3);
    }
    // P' as the texture coordinates say, and level.
    void flat() {
        const auto place = [](Vertex<Fixed>& v) { v.displaced = {v.uv.x * 64, v.uv.y * 64, 0}; };
        for (auto& v : triangle.corners) place(v);
        for (auto& edge : edges) place(edge.mid);
    }
    void split(int mask) {
        for (std::size_t e = 0; e < 3; ++e) edges[e].split = (mask >> e & 1) != 0;
        unit.tessellate(triangle, edges.data(), children);
    }
    std::vector<Ids> ids() const {
        std::vector<Ids> out;
        for (int i = 0; i < children.count; ++i) {
            const auto& c = children.triangles[std::size_t(i)].corners;
            out.push_back({c[0]->handedness, c[1]->handedness, c[2]->handedness});
        }
        return out;
    }
};

int64_t area(const Uv& a, const Uv& b, const Uv& c) {
    return int64_t(b.x - a.x) * (c.y - a.y) - int64_t(c.x - a.x) * (b.y - a.y);
}

TEST(Split, NoEdgePasses) {
    Fixture f;
    f.split(0);
    EXPECT_EQ(f.children.count, 0);
    EXPECT_EQ(f.unit.counters().edges_split[0], 1u);
}

// (A, M, C), (M, B, C) with A-B the split edge.
TEST(Split, OneEdgeMakesTwoTriangles) {
    Fixture f;
    f.split(1);
    EXPECT_EQ(f.ids(), (std::vector<Ids>{{1, 12, 3}, {12, 2, 3}}));
    f.split(2);
    EXPECT_EQ(f.ids(), (std::vector<Ids>{{2, 23, 1}, {23, 3, 1}}));
    f.split(4);
    EXPECT_EQ(f.ids(), (std::vector<Ids>{{3, 31, 2}, {31, 1, 2}}));
    EXPECT_EQ(f.unit.counters().edges_split[1], 3u);
}

TEST(Split, ThreeEdgesMakeFourTriangles) {
    Fixture f;
    f.split(7);
    EXPECT_EQ(f.ids(), (std::vector<Ids>{{1, 12, 31}, {12, 2, 23}, {31, 23, 3}, {12, 23, 31}}));
    EXPECT_EQ(f.unit.counters().edges_split[3], 1u);
}

// (M2, M1, C), then (A, B, M1), (A, M1, M2) or (A, B, M2), (B, M1, M2): A-B is unsplit, M1 lies
// on B-C and M2 on C-A. Raising M1 makes A-M1 the longer diagonal, raising M2 makes it B-M2.
TEST(Split, TwoEdgesMakeThreeTrianglesAlongTheShorterDiagonal) {
    struct Row {
        int mask;
        std::size_t m1, m2;
        std::vector<Ids> first, second;
    };
    const Row rows[] = {
        {6, 1, 2, {{31, 23, 3}, {1, 2, 23}, {1, 23, 31}}, {{31, 23, 3}, {1, 2, 31}, {2, 23, 31}}},
        {5, 2, 0, {{12, 31, 1}, {2, 3, 31}, {2, 31, 12}}, {{12, 31, 1}, {2, 3, 12}, {3, 31, 12}}},
        {3, 0, 1, {{23, 12, 2}, {3, 1, 12}, {3, 12, 23}}, {{23, 12, 2}, {3, 1, 23}, {1, 12, 23}}},
    };
    for (const Row& row : rows) {
        Fixture f;
        f.edges[row.m2].mid.displaced.z = 100'000;
        f.split(row.mask);
        EXPECT_EQ(f.ids(), row.first);
        f.flat();
        f.edges[row.m1].mid.displaced.z = 100'000;
        f.split(row.mask);
        EXPECT_EQ(f.ids(), row.second);
        EXPECT_EQ(f.unit.counters().edges_split[2], 2u);
    }
}

TEST(Split, AtATieTheDiagonalFromAIsTaken) {
    Fixture f;  // corners 1 and 2 mirror each other if corner 3 is above their middle
    f.triangle.corners[2].displaced = {400 * 64, 800 * 64, 0};
    f.edges[1].mid.displaced = {600 * 64, 400 * 64, 0};
    f.edges[2].mid.displaced = {200 * 64, 400 * 64, 0};
    f.split(6);
    EXPECT_EQ(f.ids()[1], (Ids{1, 2, 23}));
    f.edges[1].mid.displaced.z = 1;  // one LSB: no tie any more
    f.split(6);
    EXPECT_EQ(f.ids()[1], (Ids{1, 2, 31}));
}

// Whatever is chosen: the parent covered once with its own orientation, each child's path its
// parent's and a digit, and `unsplit` set for exactly the edges that are whole edges of the parent.
RC_GTEST_PROP(SplitProperty, ChildrenCoverTheParentAndKnowWhatWasTested, (uint64_t seed)) {
    Dice dice(seed);
    Fixture f;
    for (auto& v : f.triangle.corners) {
        v.uv = {2 * int32_t(dice.integer(-5000, 5000)), 2 * int32_t(dice.integer(-5000, 5000))};
    }
    for (std::size_t e = 0; e < 3; ++e) {
        const auto &a = f.triangle.corners[e], &b = f.triangle.corners[(e + 1) % 3];
        f.edges[e].mid.uv = {(a.uv.x + b.uv.x) / 2, (a.uv.y + b.uv.y) / 2};
        f.edges[e].mid.displaced = {dice.raw(kDefault.position), dice.raw(kDefault.position),
                                    dice.raw(kDefault.position)};
    }
    const auto& c = f.triangle.corners;
    const int64_t whole = area(c[0].uv, c[1].uv, c[2].uv);
    for (int mask = 1; mask < 8; ++mask) {
        f.split(mask);
        int64_t sum = 0;
        int whole_edges = 0;
        for (int i = 0; i < f.children.count; ++i) {
            const Child<Fixed>& child = f.children.triangles[std::size_t(i)];
            const int64_t part =
                area(child.corners[0]->uv, child.corners[1]->uv, child.corners[2]->uv);
            RC_ASSERT(whole == 0 || (part > 0) == (whole > 0));
            sum += part;
            RC_ASSERT(child.path.base == 5u);
            RC_ASSERT(child.path.depth == 2);
            RC_ASSERT(child.path.digits[0] == (3u | unsigned(i) << 2));
            for (unsigned e = 0; e < 3; ++e) {
                const bool shared = child.corners[e]->handedness <= 3 &&
                                    child.corners[(e + 1) % 3]->handedness <= 3;
                // Two corners of the parent: an edge of the parent, and not one that was split.
                RC_ASSERT(((child.unsplit_edges >> e & 1) != 0) == shared);
                whole_edges += shared;
            }
        }
        RC_ASSERT(sum == whole);
        RC_ASSERT(whole_edges == 3 - (mask & 1) - (mask >> 1 & 1) - (mask >> 2 & 1));
    }
}

// nt, sht, ct, vt, eligible, and whether the scene has a surface test: all 64 cases.
TEST(Split, DecisionIsSectionTwoSix) {
    Split<Fixed> unit(kDefault);
    for (int n = 0; n < 64; ++n) {
        Edge<Fixed> edge;
        edge.nt = n & 1;
        edge.sht = n & 2;
        edge.ct = n & 4;
        edge.vt = n & 8;
        edge.eligible = n & 16;
        const bool has_surface_test = n & 32;
        unit.configure(has_surface_test);
        unit.decide(Span<Edge<Fixed>>(&edge, 1));
        const bool detail = edge.nt || edge.sht || !has_surface_test;
        EXPECT_EQ(edge.split, detail && edge.ct && edge.vt && edge.eligible) << n;
    }
}

// Squared lengths of saturated differences still fit: the longest diagonal does not overflow into
// a short one.
TEST(Split, DiagonalsBeyondTheFormatSaturateAndAreCounted) {
    Fixture f;
    const auto far = int32_t(kDefault.position.max_raw());
    f.triangle.corners[0].displaced = {-far, -far, -far};
    f.edges[1].mid.displaced = {far, far, far};
    f.triangle.corners[1].displaced = {0, 0, 0};
    f.edges[2].mid.displaced = {1, 1, 1};
    f.split(6);
    EXPECT_EQ(f.ids()[1], (Ids{1, 2, 31}));  // B-M2 is the short one
    EXPECT_EQ(f.unit.counters().overflows, 3u);
}

TEST(Split, PathHoldsFortyFiveSplits) {
    Path path{3, 0, {}};
    for (unsigned i = 0; i < 45; ++i) path = path.child(i % 4);
    EXPECT_EQ(path.depth, 45);
    for (unsigned i = 0; i < 45; ++i) EXPECT_EQ(path.digits[i / 32] >> (2 * (i % 32)) & 3, i % 4);
}

}  // namespace
}  // namespace repousse
