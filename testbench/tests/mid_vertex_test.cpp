// mid_vertex: the new vertex of an edge, against exact integers and doubles.

#include "datapath/units/mid_vertex.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::farthest;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 21;

Vertex<Fixed> random_vertex(Dice& dice, const Profile& p) {
    Vertex<Fixed> v;
    v.uv = {dice.raw(p.uv), dice.raw(p.uv)};
    v.position = {dice.raw(p.position), dice.raw(p.position), dice.raw(p.position)};
    v.normal = to_raw(dice.direction(), p.normal);
    v.tangent = to_raw(dice.direction(), p.normal);
    v.handedness = dice.flip() ? 1 : -1;
    v.generation = static_cast<uint8_t>(dice.integer(0, 14));
    return v;
}

Vertex<Fixed> middle(MidVertex<Fixed>& unit, const Vertex<Fixed>& a, const Vertex<Fixed>& b) {
    Vertex<Fixed> mid;
    unit.topology(a, b, mid);
    unit.attributes(a, b, mid);
    return mid;
}

int64_t floor_half(int64_t sum) { return (sum - (sum % 2 + 2) % 2) / 2; }

class MidVertexUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
    MidVertex<Fixed> unit_{profile_};
};

// Both triangles at an edge walk it in opposite directions and must make the same bits.
RC_GTEST_PROP(MidVertexProperty, IsSymmetricInItsEnds, (uint64_t seed, bool narrow)) {
    const Profile profile = test::profile_with(narrow ? "narrow" : "default", {});
    MidVertex<Fixed> unit(profile);
    Dice dice(seed);
    const auto a = random_vertex(dice, profile), b = random_vertex(dice, profile);
    const auto ab = middle(unit, a, b), ba = middle(unit, b, a);
    RC_ASSERT(ab.uv == ba.uv);
    RC_ASSERT(ab.position == ba.position);
    RC_ASSERT(ab.normal == ba.normal);
    RC_ASSERT(ab.tangent == ba.tangent);
    RC_ASSERT(ab.generation == ba.generation);
    RC_ASSERT(ab.handedness == ba.handedness);
}

TEST_P(MidVertexUnit, TextureCoordinatesAndPositionsAreFloorsOfExactHalves) {
    Dice dice(kSeed);
    for (int i = 0; i < 100'000; ++i) {
        const auto a = random_vertex(dice, profile_), b = random_vertex(dice, profile_);
        const auto m = middle(unit_, a, b);
        ASSERT_EQ(m.uv.x, floor_half(int64_t(a.uv.x) + b.uv.x));
        ASSERT_EQ(m.uv.y, floor_half(int64_t(a.uv.y) + b.uv.y));
        ASSERT_EQ(m.position.x, floor_half(int64_t(a.position.x) + b.position.x));
        ASSERT_EQ(m.position.y, floor_half(int64_t(a.position.y) + b.position.y));
        ASSERT_EQ(m.position.z, floor_half(int64_t(a.position.z) + b.position.z));
        ASSERT_EQ(m.generation, std::max(a.generation, b.generation) + 1);
    }
    EXPECT_EQ(unit_.counters().items, 100'000u);
    EXPECT_EQ(unit_.counters().attributes, 100'000u);
}

TEST_P(MidVertexUnit, OddSumsOfNegativeCoordinatesAreFloored) {
    Vertex<Fixed> a, b;
    a.uv = {-3, -1};
    b.uv = {0, 0};
    EXPECT_EQ(middle(unit_, a, b).uv, (Uv{-2, -1}));  // -1.5 and -0.5; truncation gives -1 and 0
    b.uv = {2, 4};
    EXPECT_EQ(middle(unit_, a, b).uv, (Uv{-1, 1}));
    a.uv = b.uv = {int32_t(profile_.uv.min_raw()), int32_t(profile_.uv.max_raw())};
    EXPECT_EQ(middle(unit_, a, b).uv, a.uv);
}

// Per component: the final rounding 1/2 LSB, and the relative error of the inverse square root,
// 2^-bits + 2^-30 of at most 1. The sum of the two normals is exact in both profiles. The length
// of the result is then within sqrt(3) times that of one.
TEST_P(MidVertexUnit, NormalIsTheRoundedExactMean) {
    const Format& f = profile_.normal;
    const double lsb = std::ldexp(1.0, -f.frac);
    const double bound =
        0.5 + std::ldexp(1.0, f.frac - profile_.inverse_sqrt_bits) + std::ldexp(1.0, f.frac - 30);
    Dice dice(kSeed + 1);
    double worst = 0, worst_length = 0;
    for (int i = 0; i < 200'000; ++i) {
        Vertex<Fixed> a, b;
        a.normal = to_raw(dice.direction(), f);
        b.normal = to_raw(dice.direction(), f);
        a.tangent = b.tangent = {1 << f.frac, 0, 0};
        const glm::dvec3 sum = to_real(a.normal, f) + to_real(b.normal, f);
        if (glm::length(sum) == 0.0) continue;
        const glm::dvec3 found = to_real(middle(unit_, a, b).normal, f);
        worst = std::max(worst, farthest(found, sum / glm::length(sum)) / lsb);
        worst_length = std::max(worst_length, std::abs(glm::length(found) - 1.0) / lsb);
    }
    std::printf("%s, seed %llu: worst component %.4f LSB (bound %.4f), length %.3f LSB\n",
                GetParam(), (unsigned long long)kSeed + 1, worst, bound, worst_length);
    EXPECT_LE(worst, bound);
    EXPECT_GT(worst, 0.45);  // the bound is not idle
    EXPECT_LE(worst_length, std::sqrt(3.0) * bound);
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

TEST_P(MidVertexUnit, AxesStayExactThroughFifteenGenerations) {
    const int32_t one = 1 << profile_.normal.frac;
    const Vec3<int32_t> axes[] = {{0, 0, one}, {0, 0, -one}, {one, 0, 0}, {0, -one, 0}};
    for (const auto& axis : axes) {
        Vertex<Fixed> end, v;
        end.normal = v.normal = axis;
        end.tangent = v.tangent = {axis.z, axis.x, axis.y};
        for (int generation = 1; generation <= 15; ++generation) {
            v = middle(unit_, end, v);
            ASSERT_EQ(v.normal, axis) << generation;
            ASSERT_EQ(v.tangent, end.tangent);
            ASSERT_EQ(v.generation, generation);
        }
    }
}

// A normal is averaged with itself along a straight crease: it must not creep. One LSB is what the
// first normalisation of a rounded vector may change.
TEST_P(MidVertexUnit, EqualNormalsDoNotDrift) {
    Dice dice(kSeed + 2);
    for (int i = 0; i < 2000; ++i) {
        Vertex<Fixed> v;
        v.normal = v.tangent = to_raw(dice.direction(), profile_.normal);
        const glm::dvec3 start = to_real(v.normal, profile_.normal);
        for (int generation = 1; generation <= 15; ++generation) {
            v = middle(unit_, v, v);
            ASSERT_LE(farthest(to_real(v.normal, profile_.normal), start),
                      std::ldexp(1.0, -profile_.normal.frac));
        }
    }
}

TEST_P(MidVertexUnit, OppositeNormalsHaveNoMeanAndAreCounted) {
    Vertex<Fixed> a, b;
    a.normal = {0, 0, 1 << profile_.normal.frac};
    b.normal = {0, 0, -(1 << profile_.normal.frac)};
    a.tangent = b.tangent = {1 << profile_.normal.frac, 0, 0};
    EXPECT_EQ(middle(unit_, a, b).normal, (Vec3<int32_t>{0, 0, 0}));
    EXPECT_EQ(unit_.counters().degenerate, 1u);
    unit_.reset();
    EXPECT_EQ(unit_.counters().degenerate, 0u);
}

TEST_P(MidVertexUnit, AttributesAreMadeWhereTheyAreWanted) {
    const auto v = Vertex<Fixed>{};
    const auto run = [&](bool for_test, bool eager) {
        Edge<Fixed> edges[4];
        for (Edge<Fixed>& edge : edges) edge.v1 = edge.v2 = &v;
        edges[0].undecided = edges[1].undecided = false;
        edges[0].split = edges[2].split = edges[3].split = true;
        unit_.reset();
        unit_.run_topology(edges);
        unit_.run_attributes(edges, for_test, eager);
        EXPECT_EQ(unit_.counters().items, 4u);
        return unit_.counters().attributes;
    };
    EXPECT_EQ(run(true, false), 2u);  // the undecided ones
    EXPECT_EQ(run(true, true), 4u);
    EXPECT_EQ(run(false, false), 3u);  // those that are split
    EXPECT_EQ(run(false, true), 3u);
}

INSTANTIATE_TEST_SUITE_P(Profile, MidVertexUnit, testing::Values("default", "narrow"));

TEST(MidVertexReal, IsThePlainFormula) {
    MidVertex<Real> unit(test::profile_with("default", {}));
    Vertex<Real> a, b, m;
    a.uv = {-3, 5};
    b.uv = {0, 0};
    a.position = {1, 2, 3};
    b.position = {0.5, 0, -3};
    a.normal = b.tangent = {1, 0, 0};
    b.normal = a.tangent = {0, 1, 0};
    unit.topology(a, b, m);
    unit.attributes(a, b, m);
    EXPECT_EQ(m.uv, (Uv{-2, 2}));
    EXPECT_EQ(m.position, (Vec3<double>{0.75, 1, 0}));
    EXPECT_DOUBLE_EQ(m.normal.x, std::sqrt(0.5));
    EXPECT_EQ(m.normal, m.tangent);
}

}  // namespace
}  // namespace repousse
