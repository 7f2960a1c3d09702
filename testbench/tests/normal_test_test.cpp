// normal_test: strict comparisons of absolute differences, in both spaces, against plain integers.

#include "datapath/units/normal_test.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;

// A map normal coarser than N', so that the threshold has bits it cannot see.
Profile profile_of(int kind) {
    if (kind == 0) return test::profile_with("default", {});
    if (kind == 1) return test::profile_with("narrow", {});
    return test::profile_with("default", {{"map_normal", "s1.7 SC_RND SC_SAT"}});
}

Vec3<int32_t> random_vector(Dice& dice, const Format& f) {
    const auto one = int64_t(1) << f.frac;
    const auto c = [&] { return int32_t(dice.integer(-one, one)); };
    return {c(), c(), c()};
}

// |a - b| > threshold * 2^-threshold_frac in some component, by exact integers.
bool differs(const Vec3<int32_t>& a, const Vec3<int32_t>& b, int frac, int64_t threshold,
             int threshold_frac) {
    const auto beyond = [&](int64_t p, int64_t q) {
        return std::abs(p - q) << (20 - frac) > threshold << (20 - threshold_frac);
    };
    return beyond(a.x, b.x) || beyond(a.y, b.y) || beyond(a.z, b.z);
}

RC_GTEST_PROP(NormalTestProperty, IsTheExactComparisonAndSymmetric, (uint64_t seed)) {
    Dice dice(seed);
    const Profile p = profile_of(int(dice.integer(0, 2)));
    const auto vertex = [&] {
        Vertex<Fixed> v;
        v.normal = random_vector(dice, p.normal);
        v.map_normal = random_vector(dice, p.map_normal);
        v.displaced_normal = random_vector(dice, p.displaced_normal);
        return v;
    };
    const auto v1 = vertex(), v2 = vertex();
    auto mid = vertex();
    const auto threshold = int32_t(dice.integer(0, int64_t(2) << p.displaced_normal.frac));
    if (dice.flip()) {  // onto the threshold, and beside it
        mid = v2;
        const auto step = int32_t(dice.integer(-1, 1));
        mid.displaced_normal.y += threshold + step;
        mid.map_normal.x -= (threshold >> (p.displaced_normal.frac - p.map_normal.frac)) + step;
        mid.normal.z += (threshold << (p.normal.frac - p.displaced_normal.frac)) + step;
    }
    NormalTest<Fixed> unit(p);
    const int t = p.displaced_normal.frac;
    unit.configure(threshold, NormalSpace::World);
    const auto in = [&](Vec3<int32_t> Vertex<Fixed>::*n, int frac) {
        return differs(mid.*n, v1.*n, frac, threshold, t) ||
               differs(mid.*n, v2.*n, frac, threshold, t);
    };
    RC_ASSERT(unit(v1, v2, mid) == in(&Vertex<Fixed>::displaced_normal, t));
    RC_ASSERT(unit(v1, v2, mid) == unit(v2, v1, mid));
    unit.configure(threshold, NormalSpace::Map);
    RC_ASSERT(unit(v1, v2, mid) == (in(&Vertex<Fixed>::map_normal, p.map_normal.frac) ||
                                    in(&Vertex<Fixed>::normal, p.normal.frac)));
    RC_ASSERT(unit(v1, v2, mid) == unit(v2, v1, mid));
}

TEST(NormalTest, EachComponentAndEachEndAloneIsEnough) {
    NormalTest<Fixed> unit(profile_of(0));
    constexpr int32_t kThreshold = 400;
    unit.configure(kThreshold, NormalSpace::World);
    for (int end = 0; end < 2; ++end) {
        for (int component = 0; component < 3; ++component) {
            for (const int sign : {-1, 1}) {
                Vertex<Fixed> v[2], mid;
                Vec3<int32_t>& n = v[end].displaced_normal;
                int32_t& c = component == 0 ? n.x : component == 1 ? n.y : n.z;
                c = sign * kThreshold;
                EXPECT_FALSE(unit(v[0], v[1], mid));  // strictly greater
                c = sign * (kThreshold + 1);
                EXPECT_TRUE(unit(v[0], v[1], mid));
            }
        }
    }
}

// Printed without absolute value and with its sense turned: equal normals would split, and so
// would everything else.
TEST(NormalTest, EqualNormalsNeverSplitAndOppositeOnesDo) {
    for (const auto space : {NormalSpace::World, NormalSpace::Map}) {
        NormalTest<Fixed> unit(profile_of(0));
        Vertex<Fixed> v1, v2, mid;
        for (Vertex<Fixed>* v : {&v1, &v2, &mid}) {
            v->displaced_normal = v->map_normal = {0, 0, 2048};
            v->normal = {0, 0, 16384};
        }
        unit.configure(0, space);
        EXPECT_FALSE(unit(v1, v2, mid));
        mid.displaced_normal = mid.map_normal = {0, 0, -2048};
        unit.configure(4095, space);
        EXPECT_TRUE(unit(v1, v2, mid));
        unit.configure(4096, space);  // 2.0: no difference is larger
        EXPECT_FALSE(unit(v1, v2, mid));
    }
}

TEST(NormalTest, SkipsWhatIsDecidedUnlessEager) {
    NormalTest<Fixed> unit(profile_of(0));
    unit.configure(0, NormalSpace::World);
    Vertex<Fixed> v1, v2;
    v2.displaced_normal.x = 5;
    for (const bool eager : {false, true}) {
        std::array<Edge<Fixed>, 3> edges;
        for (auto& edge : edges) edge.v1 = &v1, edge.v2 = &v2;
        edges[1].undecided = false;
        edges[2].v2 = &v1;
        unit.reset();
        unit.run(Span<Edge<Fixed>>(edges.data(), 3), eager);
        EXPECT_TRUE(edges[0].nt);
        EXPECT_EQ(edges[1].nt, eager);
        EXPECT_FALSE(edges[2].nt);
        EXPECT_EQ(unit.counters().items, 3u);
        EXPECT_EQ(unit.counters().tests, eager ? 3u : 2u);
        EXPECT_EQ(unit.counters().positives, eager ? 2u : 1u);
    }
}

}  // namespace
}  // namespace repousse
