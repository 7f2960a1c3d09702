// The View Test in both policies against wide integers, and its properties.

#include "datapath/units/view_test.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>
#include <vector>

#include "datapath/numbers/policy.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using Point = ScreenPoint<int32_t>;

Profile default_profile() { return *shipped_profile("default"); }

ViewTest<Fixed> view_test(int64_t threshold) {
    ViewTest<Fixed> vt(default_profile());
    vt.configure(threshold);
    return vt;
}

TEST(ViewTest, IsStrictlyGreater) {
    const ViewTest<Fixed> vt = view_test(100);
    EXPECT_FALSE(vt({0, 0, false}, {60, 39, false}));
    EXPECT_FALSE(vt({0, 0, false}, {-60, 40, false}));
    EXPECT_TRUE(vt({0, 0, false}, {60, -41, false}));
}

TEST(ViewTest, ThresholdZeroAndMax) {
    const Profile profile = default_profile();
    const auto low = static_cast<int32_t>(profile.screen.min_raw());
    const auto high = static_cast<int32_t>(profile.screen.max_raw());
    EXPECT_FALSE(view_test(0)({7, -7, false}, {7, -7, false}));
    EXPECT_TRUE(view_test(0)({7, -7, false}, {7, -6, false}));
    const int64_t longest = 2 * (int64_t{high} - low);
    EXPECT_LE(longest, ViewTest<Fixed>::max_threshold(profile));
    EXPECT_TRUE(view_test(longest - 1)({low, low, false}, {high, high, false}));
    EXPECT_FALSE(view_test(longest)({low, low, false}, {high, high, false}));
    EXPECT_FALSE(
        view_test(ViewTest<Fixed>::max_threshold(profile))({low, high, false}, {high, low, false}));
}

TEST(ViewTest, AnEndBehindTheNearPlaneMakesTheEdgeLong) {
    const ViewTest<Fixed> vt = view_test(ViewTest<Fixed>::max_threshold(default_profile()));
    EXPECT_TRUE(vt({0, 0, true}, {0, 0, false}));
    EXPECT_TRUE(vt({0, 0, false}, {0, 0, true}));
    EXPECT_TRUE(vt({0, 0, true}, {0, 0, true}));
    EXPECT_FALSE(vt({0, 0, false}, {0, 0, false}));
}

RC_GTEST_PROP(ViewTest, AgreesWithWideIntegersIsSymmetricAndSameInBothPolicies, ()) {
    const Profile profile = default_profile();
    const auto coordinate = [&] {
        return *rc::gen::inRange<int32_t>(static_cast<int32_t>(profile.screen.min_raw()),
                                          static_cast<int32_t>(profile.screen.max_raw()) + 1);
    };
    const Point p1{coordinate(), coordinate(), *rc::gen::inRange(0, 16) == 0};
    const Point p2{coordinate(), coordinate(), *rc::gen::inRange(0, 16) == 0};
    const int64_t length = std::llabs(int64_t{p1.x} - p2.x) + std::llabs(int64_t{p1.y} - p2.y);
    const int64_t threshold = std::max<int64_t>(0, length + *rc::gen::inRange(-1, 2));
    const bool expected = p1.near || p2.near || length > threshold;

    const ViewTest<Fixed> fixed = view_test(threshold);
    RC_ASSERT(fixed(p1, p2) == expected);
    RC_ASSERT(fixed(p2, p1) == expected);
    ViewTest<Real> real(profile);
    real.configure(double(threshold));
    const auto as_real = [](Point p) {
        return ScreenPoint<double>{double(p.x), double(p.y), p.near};
    };
    RC_ASSERT(real(as_real(p1), as_real(p2)) == expected);
}

TEST(ViewTest, ManhattanNotMaximum) {
    // A mutant that takes the larger difference instead of the sum is caught.
    const ViewTest<Fixed> vt = view_test(100);
    EXPECT_TRUE(vt({0, 0, false}, {60, 60, false}));
}

TEST(ViewTest, RunSkipsDecidedEdgesUnlessEager) {
    std::vector<Vertex<Fixed>> ends(3);
    ends[1].screen = {200, 0, false};
    ends[2].screen = {50, 0, false};
    const auto make_edges = [&] {
        std::vector<Edge<Fixed>> edges(3);
        for (Edge<Fixed>& e : edges) e.v1 = &ends[0], e.v2 = &ends[2];
        edges[0].v2 = &ends[1];
        edges[2].undecided = false;
        return edges;
    };
    ViewTest<Fixed> vt = view_test(100);
    std::vector<Edge<Fixed>> edges = make_edges();
    vt.run(edges, false);
    EXPECT_TRUE(edges[0].vt && edges[0].undecided);
    EXPECT_FALSE(edges[1].vt || edges[1].undecided);
    EXPECT_TRUE(edges[2].vt) << "a skipped edge keeps what it had";
    EXPECT_EQ(vt.counters().tests, 2U);
    EXPECT_EQ(vt.counters().positives, 1U);

    vt.reset();
    edges = make_edges();
    vt.run(edges, true);
    EXPECT_FALSE(edges[2].vt);
    EXPECT_EQ(vt.counters().tests, 3U);
}

TEST(ViewTest, TransactionsSurvivePacking) {
    const ViewTestIn in{true, {-1, 2, true}, {3, -4, false}};
    EXPECT_EQ(ViewTestIn::unpack(in.pack().data()).pack(), in.pack());
    EXPECT_FALSE(view_test(0)(in).vt) << "skipped: result 0";
}

}  // namespace
}  // namespace repousse
