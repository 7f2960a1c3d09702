// bump of each kind against doubles, and in frames that are none.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "testbench/tests/support/bump_kinds.h"

namespace repousse {
namespace {

using study::angle_deg;
using study::kDegrees;
using test::Dice;
using test::kPi;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 43;

class BumpKinds : public test::BumpKinds {};

// As an angle, in radians, before the last rounding, for frames at right angles and relative to a
// length of one or more: the bitangent's rounding and that of v (sqrt(3)/2 LSB each), and what D is
// off: sqrt(2)/2 LSB of two slopes; or 1.5 errors of a sine and half an LSB each in two products
// and one in the first component. 0.99 allows for the quantised frame's length.
TEST_P(BumpKinds, IsWithinItsRoundingOfTheExactRotation) {
    const auto lsb = [](const Format& f) { return std::ldexp(1.0, -f.frac); };
    const double h = kPi / 2 / (1 << profile_.sine_index_bits);
    const double sine = h * h / 8 + 0x1.8p-20 + lsb(profile_.normal) / 2;
    const double product = 2 * sine + lsb(profile_.normal) / 2;
    double before = std::sqrt(0.75) * lsb(profile_.normal);
    if (kind_ == BumpKind::Slopes) {
        before += std::sqrt(0.5) * lsb(profile_.slope) +
                  std::sqrt(0.75) * std::ldexp(1.0, 2 - profile_.unnormalised.width);
    } else {
        before += std::sqrt(0.75) * lsb(profile_.unnormalised);
    }
    if (kind_ == BumpKind::Turns) before += std::sqrt(sine * sine + 2 * product * product);
    const double root = std::ldexp(1.8, -profile_.inverse_sqrt_bits) + 0x1p-29;
    const double bound = last_rounding_deg() + kDegrees * (before / 0.99 + root);
    Dice dice(kSeed);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        texel(dice);
        const glm::dvec3 n = dice.direction();
        const glm::dvec3 t = glm::normalize(glm::cross(n, dice.direction()));
        const int hand = dice.flip() ? 1 : -1;
        Vertex<Fixed> v = vertex(to_raw(n, profile_.normal), to_raw(t, profile_.normal), hand);
        const glm::dvec3 nq = to_real(v.normal, profile_.normal);
        const glm::dvec3 tq = to_real(v.tangent, profile_.normal);
        const glm::dvec3 d = exact_vector();
        const glm::dvec3 exact = tq * d.x + double(hand) * glm::cross(nq, tq) * d.y + nq * d.z;
        worst = std::max(worst, angle_deg(found(v), exact));
    }
    std::printf("%s, kind %s, seed %llu: worst angle %.4f degrees (bound %.4f)\n",
                GetParam().profile, GetParam().kind, (unsigned long long)kSeed, worst, bound);
    EXPECT_LE(worst, bound);
    EXPECT_GT(worst, bound / 10);
    if (GetParam().profile == std::string("default")) {
        EXPECT_LE(worst, 0.1);
    }
    EXPECT_EQ(unit_.counters().overflows, 0u);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
    EXPECT_EQ(unit_.counters().degenerate_frames, 0u);
    EXPECT_EQ(unit_.counters().reads, kind_ == BumpKind::Slopes ? 400'000u : 100'000u);
}

// The tests below leave the texel as it is: any one will do.

TEST_P(BumpKinds, ZeroTangentLeavesTheNormal) {
    Dice dice(kSeed);
    for (int i = 0; i < 100; ++i) {
        texel(dice);
        Vertex<Fixed> v = vertex(to_raw(dice.direction(), profile_.normal), {});
        EXPECT_LE(angle_deg(found(v), to_real(v.normal, profile_.normal)),
                  last_rounding_deg() + 0.04);
    }
    EXPECT_EQ(unit_.counters().degenerate_frames, 100u);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

TEST_P(BumpKinds, TangentParallelOrAntiparallelToTheNormalLeavesTheNormal) {
    Dice dice(kSeed + 1);
    for (int i = 0; i < 100; ++i) {
        texel(dice);
        const Vec3<int32_t> n = to_raw(dice.direction(), profile_.normal);
        for (const Vec3<int32_t>& t : {n, Vec3<int32_t>{-n.x, -n.y, -n.z}}) {
            Vertex<Fixed> v = vertex(n, t, dice.flip() ? 1 : -1);
            EXPECT_LE(angle_deg(found(v), to_real(n, profile_.normal)), last_rounding_deg() + 0.04);
        }
    }
    EXPECT_EQ(unit_.counters().degenerate_frames, 200u);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

// What opposite normals have left in mid_vertex.
TEST_P(BumpKinds, ZeroNormalStaysZeroAndIsCounted) {
    Dice dice(kSeed + 2);
    texel(dice);
    const Vec3<int32_t> t = to_raw(dice.direction(), profile_.normal);
    for (const Vec3<int32_t>& tangent : {t, Vec3<int32_t>{}}) {
        Vertex<Fixed> v = vertex({}, tangent);
        unit_(v);
        EXPECT_EQ(v.displaced_normal, Vec3<int32_t>{});
    }
    EXPECT_EQ(unit_.counters().degenerate, 2u);
    EXPECT_EQ(unit_.counters().degenerate_frames, 2u);
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

// Two ends with opposite normals and tangents: N' of the one is the other's, turned around.
TEST_P(BumpKinds, AntiparallelNormalsStayInRange) {
    Dice dice(kSeed + 3);
    for (int i = 0; i < 1000; ++i) {
        texel(dice);
        const glm::dvec3 n = dice.direction();
        const glm::dvec3 t = glm::normalize(glm::cross(n, dice.direction()));
        Vertex<Fixed> a = vertex(to_raw(n, profile_.normal), to_raw(t, profile_.normal));
        Vertex<Fixed> b = vertex(to_raw(-n, profile_.normal), to_raw(-t, profile_.normal), -1);
        EXPECT_LE(angle_deg(found(a), -found(b)), 4 * last_rounding_deg());
    }
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

// A mirrored map: the other handedness and the opposite bitangent.
TEST_P(BumpKinds, HandednessTurnsTheBitangent) {
    Dice dice(kSeed + 4);
    const int32_t one = 1 << profile_.normal.frac;
    for (int i = 0; i < 100; ++i) {
        texel(dice);
        Vertex<Fixed> right = vertex({0, 0, one}, {one, 0, 0}, 1);
        Vertex<Fixed> left = vertex({0, 0, one}, {one, 0, 0}, -1);
        unit_(right);
        unit_(left);
        EXPECT_EQ(right.displaced_normal.x, left.displaced_normal.x);
        EXPECT_NEAR(right.displaced_normal.y, -left.displaced_normal.y, 1);
        EXPECT_EQ(right.displaced_normal.z, left.displaced_normal.z);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BumpKinds, test::kBumpCases, test::bump_case_name);

TEST(BumpSlopes, SteepOnesSaturateAndAreCounted) {
    const Profile profile = test::profile_with("default", {{"bump_kind", "1"}});
    Bump<Fixed> unit(profile);
    const uint16_t heights[] = {0, 0, 65535};
    MapView<Fixed> map;
    map.width = 3, map.height = 1;
    map.slope_u = map.slope_v = {(1 << 24) - 1, 20};  // 16 a height LSB
    map.heights = heights;
    unit.configure(map);
    const int32_t one = 1 << profile.normal.frac;
    Vertex<Fixed> v;
    v.uv = {1 << profile.uv.frac, 0};
    v.normal = {0, 0, one};
    v.tangent = {one, 0, 0};
    unit(v);
    EXPECT_EQ(unit.counters().overflows, 1u);
    const glm::dvec3 found = to_real(v.displaced_normal, profile.displaced_normal);
    EXPECT_LE(angle_deg(found, {-32.0, 0.0, 1.0}), 0.05);
}

}  // namespace
}  // namespace repousse
