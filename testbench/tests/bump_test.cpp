// bump: the map's normal in the vertex's frame, against doubles.

#include "datapath/units/bump.h"

#include <gtest/gtest.h>

#include <vector>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 41;

class BumpUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
    Bump<Fixed> unit_{profile_};
    std::vector<Vec3<int16_t>> normals_;
    MapView<Fixed> map_;

    void map(int width, int height, bool wrap) {
        map_.width = width;
        map_.height = height;
        map_.wrap = wrap;
        normals_.resize(std::size_t(width) * std::size_t(height));
        map_.normals = normals_;
        unit_.configure(map_);
    }
    void set(std::size_t i, const glm::dvec3& n) {
        const auto raw = to_raw(n, profile_.map_normal);
        normals_[i] = {int16_t(raw.x), int16_t(raw.y), int16_t(raw.z)};
    }
    Vertex<Fixed> vertex(const glm::dvec3& n, const glm::dvec3& t, int hand) const {
        Vertex<Fixed> v;
        v.normal = to_raw(n, profile_.normal);
        v.tangent = to_raw(t, profile_.normal);
        v.handedness = int8_t(hand);
        return v;
    }
    glm::dvec3 found(Vertex<Fixed>& v) {
        unit_(v);
        return to_real(v.displaced_normal, profile_.displaced_normal);
    }
};

// The map's normals upwards of the horizon, as finite differences make them.
glm::dvec3 upward(Dice& dice) {
    glm::dvec3 d = dice.direction();
    d.z = std::abs(d.z) + 0.05;
    return glm::normalize(d);
}

// In LSB of N', for orthonormal frames: 1/2 for the last rounding; before it the bitangent's
// rounding (1/2 LSB of `normal`) and that of the vector to be normalised (1/2 LSB), at most sqrt(3)
// times their sum in any direction and divided by a length that is one but for the quantised
// inputs (0.99 allowed); and the inverse root's 2^-bits + 2^-30.
TEST_P(BumpUnit, IsWithinItsRoundingOfTheExactRotation) {
    map(1, 1, false);
    const int frac = profile_.displaced_normal.frac;
    const auto in_lsb = [frac](int bits) { return std::ldexp(1.0, frac - bits); };
    const double before =
        0.5 * in_lsb(profile_.normal.frac) + 0.5 * in_lsb(profile_.unnormalised.frac);
    const double bound =
        0.5 + std::sqrt(3.0) * before / 0.99 + in_lsb(profile_.inverse_sqrt_bits) + in_lsb(30);
    Dice dice(kSeed);
    double worst = 0, worst_angle = 0;
    for (int i = 0; i < 200'000; ++i) {
        const glm::dvec3 n = dice.direction();
        const glm::dvec3 t = glm::normalize(glm::cross(n, dice.direction()));
        const int hand = dice.flip() ? 1 : -1;
        set(0, upward(dice));
        Vertex<Fixed> v = vertex(n, t, hand);
        const glm::dvec3 nq = to_real(v.normal, profile_.normal);
        const glm::dvec3 tq = to_real(v.tangent, profile_.normal);
        const glm::dvec3 got = found(v);
        const glm::dvec3 d = to_real(v.map_normal, profile_.map_normal);
        const glm::dvec3 exact =
            glm::normalize(tq * d.x + double(hand) * glm::cross(nq, tq) * d.y + nq * d.z);
        worst = std::max(worst, std::ldexp(test::farthest(got, exact), frac));
        const double cosine = glm::dot(glm::normalize(got), exact);
        worst_angle = std::max(worst_angle, std::acos(std::min(1.0, cosine)) * 57.29577951308232);
    }
    std::printf("%s, seed %llu: worst component %.3f LSB (bound %.3f), worst angle %.4f degrees\n",
                GetParam(), (unsigned long long)kSeed, worst, bound, worst_angle);
    EXPECT_LE(worst, bound);
    EXPECT_GT(worst, 0.5);
    EXPECT_LE(worst_angle, std::sqrt(3.0) * bound * std::ldexp(57.3, -frac));
    EXPECT_EQ(unit_.counters().overflows, 0u);
    EXPECT_EQ(unit_.counters().degenerate, 0u);
}

TEST_P(BumpUnit, FlatMapKeepsTheAxesExactly) {
    map(1, 1, false);
    set(0, {0, 0, 1});
    const int32_t one = 1 << profile_.displaced_normal.frac;
    Vertex<Fixed> up = vertex({0, 0, 1}, {1, 0, 0}, 1);
    unit_(up);
    EXPECT_EQ(up.displaced_normal, (Vec3<int32_t>{0, 0, one}));
    Vertex<Fixed> west = vertex({-1, 0, 0}, {0, 1, 0}, -1);
    unit_(west);
    EXPECT_EQ(west.displaced_normal, (Vec3<int32_t>{-one, 0, 0}));
}

TEST_P(BumpUnit, HandednessTurnsTheBitangent) {
    map(1, 1, false);
    set(0, {0, 0.6, 0.8});
    Vertex<Fixed> right = vertex({0, 0, 1}, {1, 0, 0}, 1);
    Vertex<Fixed> left = vertex({0, 0, 1}, {1, 0, 0}, -1);
    unit_(right);
    unit_(left);
    EXPECT_GT(right.displaced_normal.y, 0);  // B = N x T = +y
    EXPECT_EQ(left.displaced_normal.y, -right.displaced_normal.y);
    EXPECT_EQ(left.displaced_normal.z, right.displaced_normal.z);
    EXPECT_EQ(left.displaced_normal.x, 0);
}

TEST_P(BumpUnit, ReadsTheTexelThatUvLiesIn) {
    for (const bool wrap : {false, true}) {
        map(5, 3, wrap);
        for (std::size_t i = 0; i < normals_.size(); ++i) normals_[i] = {int16_t(i), 0, 1};
        for (int y = -2; y < 6; ++y) {
            for (int x = -4; x < 9; ++x) {
                Vertex<Fixed> v = vertex({0, 0, 1}, {1, 0, 0}, 1);
                // The last fraction of the texel, so that a rounded address would miss it.
                const int one = 1 << profile_.uv.frac;
                v.uv = {(x + 1) * one - 1, (y + 1) * one - 1};
                unit_(v);
                const int column = wrap ? (x + 5) % 5 : std::clamp(x, 0, 4);
                const int row = wrap ? (y + 3) % 3 : std::clamp(y, 0, 2);
                ASSERT_EQ(v.map_normal.x, row * 5 + column) << x << ", " << y;
            }
        }
    }
}

TEST_P(BumpUnit, AVectorWithoutDirectionIsCounted) {
    map(1, 1, false);
    set(0, {0, 0, 1});
    Vertex<Fixed> v = vertex({0, 0, 0}, {0, 0, 0}, 1);  // the mean of opposite normals
    unit_(v);
    EXPECT_EQ(v.displaced_normal, (Vec3<int32_t>{0, 0, 0}));
    EXPECT_EQ(unit_.counters().degenerate, 1u);
}

// Opposite frames at one place, as on both sides of a crease: any map normal stays in range.
TEST_P(BumpUnit, ParallelTangentLeavesTheOtherTwoTerms) {
    map(1, 1, false);
    set(0, {0.6, 0.0, 0.8});
    Vertex<Fixed> v = vertex({0, 0, 1}, {0, 0, 1}, 1);  // N x T = 0
    unit_(v);
    EXPECT_EQ(v.displaced_normal, (Vec3<int32_t>{0, 0, 1 << profile_.displaced_normal.frac}));
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

TEST_P(BumpUnit, RunsWhereNormalsAreWanted) {
    map(1, 1, false);
    set(0, {0, 0, 1});
    const auto run = [&](bool for_test, bool eager) {
        Edge<Fixed> edges[4];
        edges[0].undecided = false;
        edges[0].split = edges[1].split = true;
        unit_.reset();
        unit_.run(edges, for_test, eager);
        EXPECT_EQ(unit_.counters().reads, unit_.counters().items);
        return unit_.counters().items;
    };
    EXPECT_EQ(run(true, false), 3u);
    EXPECT_EQ(run(true, true), 4u);
    EXPECT_EQ(run(false, false), 2u);
}

INSTANTIATE_TEST_SUITE_P(Profile, BumpUnit, testing::Values("default", "narrow"));

}  // namespace
}  // namespace repousse
