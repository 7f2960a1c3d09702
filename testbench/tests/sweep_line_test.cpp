// sweep_line: the closed form, one lane and two, what it counts, and how it stops.

#include "datapath/units/sweep_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <tuple>

#include "testbench/reference/remesher.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using test::GridTriangle;
using test::SweepChain;
using test::TriangleKind;

constexpr int kTwoLanes = 256;

SweepLineOptions lanes(int column_depth) { return {column_depth, {}}; }

TEST(SweepLine, TwoLanesMakeTheTrianglesOfOne) {
    std::mt19937_64 random(1);
    for (const int depth : {1, 3, kTwoLanes}) {
        SweepChain one, two(lanes(depth));
        for (int n = 0; n < 4000; ++n) {
            const auto corners = test::with_data(test::mixed_triangle(n, random), random);
            one.remesh(corners);
            two.remesh(corners);
            ASSERT_EQ(one.triangles().size(), two.triangles().size());
            for (std::size_t t = 0; t < one.triangles().size(); ++t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    ASSERT_EQ(one.triangles()[t][k].name, two.triangles()[t][k].name) << n;
                    ASSERT_EQ(one.triangles()[t][k].data, two.triangles()[t][k].data) << n;
                }
            }
        }
        EXPECT_FALSE(two.strip.bad_ref());
        EXPECT_LE(two.strip.counters().deepest, std::size_t(depth));
        EXPECT_EQ(one.sweep.counters().highest_register, 11u);
        EXPECT_LT(two.sweep.counters().highest_register, 15u);
        EXPECT_EQ(one.sweep.counters().commands, one.strip.counters().commands);
        EXPECT_EQ(one.sweep.counters().swaps, one.strip.counters().swaps);
        EXPECT_EQ(two.sweep.counters().triangles, two.strip.counters().triangles);
    }
}

using CoverKey = std::tuple<int, int, int64_t, int64_t>;

// A triangle from its smallest vertex on: where it starts is no part of what it is.
std::array<CoverKey, 3> rotated(const reference::CoverTriangle& triangle) {
    std::array<CoverKey, 3> keys;
    for (std::size_t k = 0; k < 3; ++k) {
        keys[k] = {int(triangle[k].kind), triangle[k].part, triangle[k].a, triangle[k].b};
    }
    std::rotate(keys.begin(), std::min_element(keys.begin(), keys.end()), keys.end());
    return keys;
}

// Triangle by triangle what the closed form makes, in its order.
bool is_as_in_closed_form(SweepChain& chain, const GridTriangle& points) {
    std::array<std::array<int64_t, 3>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) std::copy_n(points[i].begin(), 3, corners[i].begin());
    const reference::Remeshing expected = reference::remesh(corners);
    chain.remesh(test::corners_of(points));
    if (chain.triangles().size() != expected.triangles.size()) return false;
    for (std::size_t t = 0; t < expected.triangles.size(); ++t) {
        reference::CoverTriangle found;
        for (std::size_t k = 0; k < 3; ++k) {
            found[k] = test::cover_vertex(chain.triangles()[t][k].name, chain.base());
        }
        if (rotated(found) != rotated(expected.triangles[t])) return false;
    }
    return true;
}

TEST(SweepLine, TheMachineMakesTheTrianglesOfTheClosedForm) {
    SweepChain chain({}, {AdderKind::Exact, 0, 0});
    int different = 0;
    for (int i = 0; i < 262'144; ++i) {
        GridTriangle t;
        for (int k = 0; k < 9; ++k) t[std::size_t(k / 3)][std::size_t(k % 3)] = i >> (2 * k) & 3;
        different += !is_as_in_closed_form(chain, t);
    }
    EXPECT_EQ(different, 0) << "of all ordered triples of a 4^3 cube";
    std::mt19937_64 random(11);
    for (int n = 0; n < 8000; ++n) {
        ASSERT_TRUE(is_as_in_closed_form(chain, test::mixed_triangle(n, random))) << n;
    }
}

// Where the FIFOs are deep enough, nothing is displaced twice.
TEST(SweepLine, TwoLanesSendEachVertexOnce) {
    std::mt19937_64 random(10);
    SweepChain chain(lanes(kTwoLanes), {AdderKind::Exact, 0, 0});
    for (int n = 0; n < 4000; ++n) {
        const uint64_t before = chain.sweep.counters().displaced;
        chain.remesh(test::corners_of(test::mixed_triangle(n, random)));
        std::map<test::VertexKey, test::VertexData> vertices;
        test::collect_vertices(chain, vertices);
        ASSERT_EQ(chain.sweep.counters().displaced - before, vertices.size()) << n;
    }
}

// Fine triangles are at most two grid units wide and high in the remeshing plane.
TEST(SweepLine, TrianglesStayWithinTwoGridUnitsInThePlane) {
    std::mt19937_64 random(6);
    SweepChain chain({}, {AdderKind::Exact, 0, 3});
    for (int n = 0; n < 2000; ++n) {
        auto corners = test::corners_of(test::mixed_triangle(n, random));
        for (auto& corner : corners) {
            for (std::size_t x = 0; x < 3; ++x) corner.data[x] = corner.slot[x] * 1000;
        }
        chain.remesh(corners);
        if (chain.base().single) continue;
        for (const auto& triangle : chain.triangles()) {
            for (const std::size_t axis :
                 {std::size_t(chain.base().sweep_axis), std::size_t(chain.base().side_axis)}) {
                const auto [low, high] = std::minmax(
                    {triangle[0].data[axis], triangle[1].data[axis], triangle[2].data[axis]});
                ASSERT_LE(high - low, 2001) << n;
            }
        }
    }
}

TEST(SweepLine, AbortLeavesItReadyForTheNextTriangle) {
    std::mt19937_64 random(7);
    SweepChain chain(lanes(8)), fresh(lanes(8));
    SweepTriangle base;
    for (int n = 0; n < 200; ++n) {
        chain.setup(test::with_data(test::random_triangle(TriangleKind::Small, random), random),
                    base);
        chain.sweep.load(base);
        SweepStep step;
        StripTriangles<SweepVertex> made;
        for (unsigned i = 0; i < random() % 20 && chain.sweep.step(step); ++i) {
            chain.strip(step.strip, {step.vertices.data(), step.vertex_count}, made);
        }
        chain.sweep.abort();
        chain.strip.flush();
        EXPECT_FALSE(chain.sweep.busy());
        EXPECT_FALSE(chain.sweep.step(step));

        const auto corners =
            test::with_data(test::random_triangle(TriangleKind::Small, random), random);
        chain.remesh(corners);
        fresh.remesh(corners);
        ASSERT_EQ(chain.triangles().size(), fresh.triangles().size());
        for (std::size_t t = 0; t < fresh.triangles().size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_EQ(chain.triangles()[t][k].name, fresh.triangles()[t][k].name);
                ASSERT_EQ(chain.triangles()[t][k].data, fresh.triangles()[t][k].data);
            }
        }
    }
    EXPECT_FALSE(chain.strip.bad_ref());
}

TEST(SweepLine, CommandsDoNotDependOnWhatWentBefore) {
    std::mt19937_64 random(13);
    SweepChain chain(lanes(8));
    for (int n = 0; n < 500; ++n) {
        SweepTriangle base;
        chain.setup(test::corners_of(test::mixed_triangle(n, random)), base);
        SweepLine fresh(lanes(8));
        fresh.load(base);
        chain.sweep.load(base);
        SweepStep a, b;
        while (fresh.step(a)) {
            ASSERT_TRUE(chain.sweep.step(b));
            ASSERT_EQ(a.strip.init, b.strip.init);
            ASSERT_EQ(a.strip.count, b.strip.count);
            for (std::size_t i = 0; i < a.strip.count; ++i) {
                ASSERT_EQ(a.strip.commands[i].op, b.strip.commands[i].op);
                ASSERT_EQ(a.strip.commands[i].place, b.strip.commands[i].place);
                ASSERT_EQ(a.strip.commands[i].keep, b.strip.commands[i].keep);
            }
        }
        ASSERT_FALSE(chain.sweep.step(b));
    }
}

// Repair R2 is what ends the walk where two edges share slots. The guard gives the triangle up,
// says so, and the next one is remeshed as ever.
TEST(SweepLine, RunawayIsStoppedAndReported) {
    SweepLineOptions options;
    options.repairs.drag_below = false;
    SweepChain chain(options);
    std::mt19937_64 random(8);
    for (int n = 0; n < 1000 && !chain.sweep.runaway(); ++n) {
        chain.remesh(test::corners_of(test::random_triangle(TriangleKind::Thin, random)));
    }
    EXPECT_TRUE(chain.sweep.runaway());
    EXPECT_EQ(chain.sweep.counters().runaways, 1u);
    EXPECT_FALSE(chain.sweep.busy());
    chain.remesh(test::corners_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
    EXPECT_EQ(chain.triangles().size(), 1u);
    EXPECT_TRUE(chain.sweep.runaway()) << "sticky";
    chain.sweep.reset();
    EXPECT_FALSE(chain.sweep.runaway());
    EXPECT_EQ(chain.sweep.counters().triangles, 0u);
}

// Triangles with corners uniform in a square of `size`, as the paper counts them.
SweepLineCounters flat(int size, int column_depth, int count) {
    std::mt19937_64 random(5);
    SweepChain chain(lanes(column_depth), {AdderKind::Exact, 0, 0});
    for (int n = 0; n < count; ++n)
        chain.remesh(test::corners_of(test::flat_triangle(size, random)));
    EXPECT_FALSE(chain.strip.bad_ref());
    return chain.sweep.counters();
}

// A step is a cycle of two lanes, an addition a cycle of one.
TEST(SweepLine, Figures) {
    struct Row {
        int size, count;
        double additions, commands, sent, displaced, steps, one_lane;  // bounds; 9: none
    };
    const Row rows[] = {
        {8, 20000, 9, 9, 9, 9, 0.70, 9}, {16, 10000, 9, 9, 1.05, 9, 0.62, 9},
        {32, 5000, 9, 9, 9, 9, 9, 9},    {64, 2000, 9, 1.25, 1.005, 0.58, 0.56, 1.15},
        {128, 600, 9, 9, 9, 9, 9, 9},    {256, 200, 2.1, 1.07, 9, 0.53, 0.52, 9}};
    std::printf("      per quad:             per triangle:\n");
    std::printf(
        "  px  additions  (2 lanes)  commands   sent  displaced(2)  swaps  steps  additions\n");
    for (const Row& row : rows) {
        const SweepLineCounters one = flat(row.size, 0, row.count);
        const SweepLineCounters two = flat(row.size, kTwoLanes, row.count);
        const auto each = [](uint64_t n, uint64_t d) { return double(n) / double(d); };
        const double steps = each(two.steps + two.ears, two.triangles);
        std::printf("%4d %10.3f %10.3f %9.3f %6.3f %13.3f %6.3f %6.3f %10.3f\n", row.size,
                    each(one.additions, one.quads), each(two.additions, two.quads),
                    each(one.commands, one.triangles), each(one.displaced, one.triangles),
                    each(two.displaced, two.triangles), each(one.swaps, one.triangles), steps,
                    each(one.additions, one.triangles));
        EXPECT_LE(each(one.additions, one.quads), row.additions) << row.size;
        EXPECT_LE(each(one.commands, one.triangles), row.commands) << row.size;
        EXPECT_LE(each(one.displaced, one.triangles), row.sent) << row.size;
        EXPECT_LE(each(two.displaced, two.triangles), row.displaced) << row.size;
        EXPECT_LE(steps, row.steps) << row.size;
        EXPECT_LE(each(one.additions, one.triangles), row.one_lane) << row.size;
    }
}

}  // namespace
}  // namespace repousse
