// Exact coverage: what setup, sweep line and strip make of a base triangle covers it exactly once,
// and with a repair switched off it does not. REPOUSSE_NIGHTLY=1 runs the long version.

#include "testbench/reference/coverage.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using reference::CoverageChecker;
using reference::CoverBase;
using reference::CoverReport;
using reference::CoverVertex;
using test::GridTriangle;
using test::SweepChain;
using test::TriangleKind;

const TriangleSetupOptions kNoData = {AdderKind::Exact, 0, 0};

// ---- the verifier itself ------------------------------------------------------------------------

CoverVertex corner(int i) { return {CoverVertex::Kind::Corner, i, 0, 0}; }
CoverVertex edge(int e, int k) { return {CoverVertex::Kind::Edge, e, k, 0}; }
CoverVertex inside(int x, int y) { return {CoverVertex::Kind::Interior, 0, x, y}; }

CoverReport judge(const std::vector<reference::CoverTriangle>& triangles) {
    CoverBase base;  // legs of 2: edge 0 on the x axis, edge 1 the hypotenuse, edge 2 on y
    base.corners = {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}};
    CoverageChecker checker;
    checker.start(base);
    for (const auto& triangle : triangles) checker.add(triangle);
    return checker.finish();
}

std::vector<reference::CoverTriangle> four() {
    return {{corner(0), edge(0, 1), edge(2, 1)},
            {edge(0, 1), corner(1), edge(1, 1)},
            {edge(2, 1), edge(1, 1), corner(2)},
            {edge(0, 1), edge(1, 1), edge(2, 1)}};
}

TEST(CoverageChecker, AcceptsAnExactCover) { EXPECT_TRUE(judge(four()).exact()); }

TEST(CoverageChecker, RefusesEachKindOfMistake) {
    auto t = four();
    t.pop_back();
    EXPECT_EQ(judge(t).open_edges, 3u) << "a hole";
    EXPECT_TRUE(judge(t).area_differs);
    t = four();
    t.push_back(t[0]);
    EXPECT_GT(judge(t).open_edges, 0u) << "a triangle twice";
    t = four();
    std::swap(t[3][1], t[3][2]);
    EXPECT_EQ(judge(t).not_positive, 1u) << "a flipped triangle";
    t = four();
    t[1][2] = inside(1, 1);  // the place of edge(1, 1), under another name
    const CoverReport renamed = judge(t);
    EXPECT_EQ(renamed.not_positive, 0u);
    EXPECT_FALSE(renamed.area_differs);
    EXPECT_GT(renamed.open_edges, 0u) << "a vertex of an edge that the neighbour does not know";
    t = four();
    t[0][1] = edge(0, 2);
    EXPECT_EQ(judge(t).bad_names, 1u) << "an edge of two steps has one point";
    EXPECT_GT(judge({{corner(0), corner(1), corner(2)}}).open_edges, 0u) << "T-vertices";
    EXPECT_FALSE(judge({}).exact());
}

// ---- all triples of a cube ----------------------------------------------------------------------

GridTriangle cube_triple(int n, int index) {
    GridTriangle t;
    for (auto& point : t) {
        for (int& x : point) {
            x = index % n;
            index /= n;
        }
    }
    return t;
}

std::size_t broken_triples(int n, int count, const SweepLineOptions& options,
                           std::size_t* triangles = nullptr) {
    SweepChain chain(options, kNoData);
    std::size_t bad = 0;
    for (int i = 0; i < count; ++i) bad += !chain.cover(cube_triple(n, i)).exact();
    if (triangles != nullptr) *triangles = chain.sweep.counters().triangles;
    return bad;
}

TEST(Coverage, AllOrderedTriplesOfACubeOfFive) {
    std::size_t triangles = 0;
    EXPECT_EQ(broken_triples(5, 1'953'125, {}, &triangles), 0u);
    EXPECT_EQ(triangles, 14'074'825u);
}

TEST(Coverage, AllOrderedTriplesOfACubeOfFourInTwoLanes) {
    EXPECT_EQ(broken_triples(4, 262'144, {256, {}}), 0u);
    EXPECT_EQ(broken_triples(4, 262'144, {1, {}}), 0u);
}

// R4 is automatic with R1 and has nothing to break in so small a cube.
TEST(Coverage, WithoutAnyOneRepairItFails) {
    struct Row {
        const char* name;
        bool SweepRepairs::*repair;
        std::size_t broken;  // 0: not known from elsewhere
    };
    const Row rows[] = {
        {"R1", &SweepRepairs::climb, 0},           {"R2", &SweepRepairs::drag_below, 0},
        {"R3", &SweepRepairs::last_column, 72952}, {"R5", &SweepRepairs::other_edge, 0},
        {"R6", &SweepRepairs::single, 64},         {"R7", &SweepRepairs::right_stall, 0},
        {"R8", &SweepRepairs::closing_fan, 24}};
    for (const Row& row : rows) {
        SweepLineOptions options;
        options.repairs.*row.repair = false;
        const std::size_t broken = broken_triples(4, 262'144, options);
        std::printf("without %s: %zu of 262144 triples broken\n", row.name, broken);
        EXPECT_GT(broken, 0u) << row.name;
        if (row.broken != 0) {
            EXPECT_EQ(broken, row.broken) << row.name;
        }
    }
}

// ---- random triangles ---------------------------------------------------------------------------

TEST(Coverage, RandomTrianglesOfElevenKinds) {
    const bool nightly = std::getenv("REPOUSSE_NIGHTLY") != nullptr;
    const int counts[test::kTriangleKinds] = {60000, 30000, 2000,  10,    5000, 5000,
                                              60000, 120,   30000, 30000, 1000};
    std::size_t all = 0, fine = 0;
    for (int k = 0; k < test::kTriangleKinds; ++k) {
        const auto kind = static_cast<TriangleKind>(k);
        std::mt19937_64 random(100 + static_cast<unsigned>(k));
        SweepChain chain({k % 2 == 0 ? 0 : 256, {}}, kNoData);
        const int count = counts[k] * (nightly ? 8 : 1);
        std::size_t bad = 0;
        for (int n = 0; n < count; ++n) {
            const GridTriangle t = test::random_triangle(kind, random);
            const CoverReport report = chain.cover(t);
            bad += !report.exact();
        }
        EXPECT_EQ(bad, 0u) << test::name_of(kind);
        EXPECT_EQ(chain.sweep.counters().runaways, 0u);
        EXPECT_FALSE(chain.strip.bad_ref());
        const auto& forms = chain.setup.counters().forms;
        std::printf("%-10s %7d triangles, %9llu fine; roof %llu increasing %llu decreasing %llu\n",
                    test::name_of(kind).c_str(), count,
                    static_cast<unsigned long long>(chain.sweep.counters().triangles),
                    static_cast<unsigned long long>(forms[0]),
                    static_cast<unsigned long long>(forms[1]),
                    static_cast<unsigned long long>(forms[2]));
        all += static_cast<std::size_t>(count);
        fine += chain.sweep.counters().triangles;
    }
    std::printf("%zu triangles, %zu fine\n", all, fine);
    EXPECT_GE(all, nightly ? 1'000'000u : 100'000u);
    EXPECT_GE(fine, nightly ? 100'000'000u : 10'000'000u);
}

// Above 10^5 fine triangles each, so for the night only.
TEST(Coverage, TrianglesOfMillions) {
    if (std::getenv("REPOUSSE_NIGHTLY") == nullptr) GTEST_SKIP() << "needs REPOUSSE_NIGHTLY=1";
    std::mt19937_64 random(200);
    for (const int limit : {600, 1500, 4096}) {
        SweepChain chain({256, {}}, kNoData);
        for (int n = 0; n < 1 + 3000 / limit; ++n) {
            GridTriangle t;
            for (auto& p : t) {
                for (int& x : p)
                    x = static_cast<int>(random() % (2u * unsigned(limit) + 1)) - limit;
            }
            if (limit == kGridLimit) t = {{{-4096, -4096, 4096}, {4096, 3500, 0}, {4096, 4096, 7}}};
            EXPECT_TRUE(chain.cover(t).exact()) << limit << ' ' << n;
        }
        std::printf("+-%d: %llu fine triangles\n", limit,
                    static_cast<unsigned long long>(chain.sweep.counters().triangles));
    }
}

// ---- hard cases by name -------------------------------------------------------------------------

bool covers(const GridTriangle& t, const SweepLineOptions& options = {}) {
    SweepChain chain(options, kNoData);
    return chain.cover(t).exact();
}

// Every order of the corners, so every role that one can play.
bool covers_in_any_order(const GridTriangle& t) {
    static constexpr std::size_t kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                  {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (const auto& order : kOrders) {
        if (!covers({t[order[0]], t[order[1]], t[order[2]]})) return false;
    }
    return true;
}

TEST(HardCase, SliversOfHeightOne) {
    for (int n = 1; n <= 40; ++n) {
        for (int k = 0; k <= n; ++k) {
            EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {n, 0, 0}, {k, 1, 0}}})) << n << ' ' << k;
            EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {n, n, 3}, {k, k, 4}}})) << n << ' ' << k;
        }
    }
}

TEST(HardCase, RoofWithTheSplitAtACorner) {
    const GridTriangle at_a = {{{0, 0, 0}, {9, 2, 0}, {0, 7, 3}}};
    const GridTriangle at_b = {{{0, 0, 0}, {9, 2, 0}, {9, 8, 3}}};
    for (const GridTriangle& t : {at_a, at_b}) {
        SweepChain chain({}, kNoData);
        EXPECT_TRUE(chain.cover(t).exact());
        EXPECT_NE(chain.base().halves[0].columns == 0, chain.base().halves[1].columns == 0);
        EXPECT_TRUE(covers_in_any_order(t));
    }
}

// Without repair R5 everything lies where it should, but the split column's vertices are not those
// that the neighbour makes of the same edge.
TEST(HardCase, SplitAtACornerIsTheNeighboursEdge) {
    SweepLineOptions options;
    options.repairs.other_edge = false;
    SweepChain chain(options, kNoData);
    const CoverReport report = chain.cover({{{0, 0, 0}, {9, 2, 0}, {0, 7, 0}}});
    EXPECT_EQ(report.not_positive, 0u);
    EXPECT_EQ(report.bad_names, 0u);
    EXPECT_FALSE(report.area_differs);
    EXPECT_GT(report.open_edges, 0u);
}

TEST(HardCase, ThreeEdgePointsInOneSlot) {
    SweepLineOptions two_at_most;
    two_at_most.repairs.many_points = false;
    for (const GridTriangle& t : {GridTriangle{{{6, 6, 3}, {6, 2, 0}, {1, 0, 4}}},
                                  GridTriangle{{{1, 0, 2}, {0, 6, 1}, {4, 4, 2}}}}) {
        EXPECT_TRUE(covers_in_any_order(t));
        EXPECT_FALSE(covers(t, two_at_most)) << "there are no three points in a slot";
    }
}

TEST(HardCase, ThreeDifferentMainDirections) {
    EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {10, 1, 2}, {7, 8, 9}}}));
    EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {-1000, 10, 20}, {-70, 80, 99}}}));
}

TEST(HardCase, ExactHalfTies) {
    for (int n = 2; n <= 64; n += 2) {
        for (const int odd : {1, n / 2, n - 1}) {
            EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {n, odd, 0}, {n / 2, n + 1, 0}}}));
            EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {n, n / 2, odd}, {odd, -n, n / 2}}}));
        }
    }
}

TEST(HardCase, CornersOnOneGridPoint) {
    EXPECT_TRUE(covers({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}}));
    EXPECT_TRUE(covers_in_any_order({{{5, 5, 5}, {5, 5, 5}, {6, 5, 5}}}));
    EXPECT_TRUE(covers_in_any_order({{{5, 5, 5}, {5, 5, 5}, {-40, 17, 5}}}));
    EXPECT_TRUE(covers_in_any_order({{{0, 0, 0}, {3, 3, 3}, {9, 9, 9}}}));
}

TEST(HardCase, CornersAtTheGuardBand) {
    EXPECT_TRUE(
        covers_in_any_order({{{-4096, -4096, -4096}, {4096, 4096, 4096}, {4096, 4096, 4095}}}));
    EXPECT_TRUE(covers_in_any_order({{{-4096, 0, 4096}, {4096, 1, 4096}, {4096, 0, 4096}}}));
    EXPECT_TRUE(covers_in_any_order({{{-4096, 4096, 0}, {4096, -4096, 0}, {0, 1, 4096 / 512}}}));
}

}  // namespace
}  // namespace repousse
