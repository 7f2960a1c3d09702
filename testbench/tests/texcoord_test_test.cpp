// The Tex Coord Test against a floor computed in double, and its properties.

#include "datapath/units/texcoord_test.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "datapath/numbers/policy.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

Profile default_profile() { return *shipped_profile("default"); }

/// The test as the paper words it, on real numbers.
bool oracle(Uv u1, Uv u2, Uv u12, int frac) {
    const auto texel = [frac](int32_t x) { return std::floor(std::ldexp(x, -frac)); };
    const auto same = [&](Uv a, Uv b) {
        return texel(a.x) == texel(b.x) && texel(a.y) == texel(b.y);
    };
    return !(same(u12, u1) || same(u12, u2));
}

Uv middle(Uv a, Uv b) { return {(a.x + b.x) >> 1, (a.y + b.y) >> 1}; }

TEST(TexcoordTest, DegenerateEdgeIsNeverSplit) {
    const TexcoordTest ct(default_profile());
    for (const int32_t x : {-4000, -1, 0, 1, 255, 256, 4096}) {
        EXPECT_FALSE(ct({x, x}, {x, x}, {x, x})) << x;
    }
}

TEST(TexcoordTest, NegativeCoordinatesAreFloored) {
    const TexcoordTest ct(default_profile());
    // -1/256 lies in texel -1, not in texel 0.
    EXPECT_TRUE(ct({0, 0}, {-1024, 0}, {-1, 0}));
    EXPECT_FALSE(ct({-1, 0}, {-1024, 0}, {-256, 0}));
}

TEST(TexcoordTest, BothComponentsMustMatchTheSameEnd) {
    const TexcoordTest ct(default_profile());
    EXPECT_TRUE(ct({0, 0}, {1024, 1024}, {0, 1024}));
    EXPECT_TRUE(ct({0, 0}, {1024, 1024}, {1024, 0}));
    EXPECT_FALSE(ct({0, 0}, {1024, 1024}, {255, 255}));
}

TEST(TexcoordTest, EdgeOfOneTexelIsNeverSplitAndOneOfThreeIs) {
    const TexcoordTest ct(default_profile());
    for (int32_t x = -600; x < 600; ++x) {
        const Uv u1{x, 0};
        EXPECT_FALSE(ct(u1, {x + 256, 0}, middle(u1, {x + 256, 0}))) << x;
        EXPECT_TRUE(ct(u1, {x + 768, 0}, middle(u1, {x + 768, 0}))) << x;
    }
}

RC_GTEST_PROP(TexcoordTest, AgreesWithFloorInDoubleAndIsSymmetric, ()) {
    Profile profile = default_profile();
    profile.uv.frac = *rc::gen::inRange(0, 17);
    const TexcoordTest ct(profile);
    const auto coordinate = [&] {
        const int32_t reach = 3 << profile.uv.frac;
        return *rc::gen::inRange<int32_t>(-reach, reach + 1);
    };
    const Uv u1{coordinate(), coordinate()};
    const Uv u2{coordinate(), coordinate()};
    const Uv u12 = *rc::gen::arbitrary<bool>() ? middle(u1, u2) : Uv{coordinate(), coordinate()};
    RC_ASSERT(ct(u1, u2, u12) == oracle(u1, u2, u12, profile.uv.frac));
    RC_ASSERT(ct(u1, u2, u12) == ct(u2, u1, u12));
}

TEST(TexcoordTest, DroppingTheFractionTowardZeroIsCaught) {
    // The mutant that divides instead of shifting merges texels -1 and 0.
    const TexcoordTest ct(default_profile());
    int different = 0;
    for (int32_t x = -512; x < 0; ++x) {
        const Uv u1{x, 0}, u2{x + 700, 0}, u12 = middle(u1, u2);
        const auto same = [](Uv a, Uv b) {
            return a.x / 256 == b.x / 256 && a.y / 256 == b.y / 256;
        };
        different += ct(u1, u2, u12) != !(same(u12, u1) || same(u12, u2));
    }
    EXPECT_GT(different, 0);
}

TEST(TexcoordTest, RunSkipsDecidedEdgesUnlessEager) {
    std::vector<Vertex<Fixed>> ends(2);
    ends[1].uv = {2048, 0};
    const auto make_edges = [&] {
        std::vector<Edge<Fixed>> edges(3);
        for (Edge<Fixed>& e : edges) e.v1 = &ends[0], e.v2 = &ends[1], e.mid.uv = {1024, 0};
        edges[1].mid.uv = {0, 0};  // in the first end's texel
        edges[2].mid.uv = {0, 0};
        edges[2].undecided = false;
        return edges;
    };
    TexcoordTest ct(default_profile());
    std::vector<Edge<Fixed>> edges = make_edges();
    ct.run(Span<Edge<Fixed>>(edges), false);
    EXPECT_TRUE(edges[0].ct && edges[0].undecided);
    EXPECT_FALSE(edges[1].ct || edges[1].undecided);
    EXPECT_TRUE(edges[2].ct) << "a skipped edge keeps what it had";
    EXPECT_EQ(ct.counters().items, 3U);
    EXPECT_EQ(ct.counters().tests, 2U);
    EXPECT_EQ(ct.counters().positives, 1U);

    ct.reset();
    edges = make_edges();
    ct.run(Span<Edge<Fixed>>(edges), true);
    EXPECT_FALSE(edges[2].ct);
    EXPECT_EQ(ct.counters().tests, 3U);
}

TEST(TexcoordTest, TransactionsSurvivePacking) {
    const TexcoordTestIn in{true, {-1, 2}, {3, -4}, {-5, 6}};
    const TexcoordTestIn back = TexcoordTestIn::unpack(in.pack().data());
    EXPECT_EQ(back.pack(), in.pack());
    EXPECT_FALSE(TexcoordTest(default_profile())(in).ct) << "skipped: result 0";
}

}  // namespace
}  // namespace repousse
