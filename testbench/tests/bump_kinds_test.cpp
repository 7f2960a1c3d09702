// bump by slopes and by two angles: against doubles, against the stored normals of the same map,
// and in frames that are none.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "datapath/units/bump.h"
#include "testbench/host/draw.h"
#include "testbench/host/encoder.h"
#include "testbench/host/map/normal_map.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 43;
constexpr double kPi = 3.14159265358979323846;
constexpr double kDegrees = 180.0 / kPi;

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegrees;
}

struct Case {
    const char* profile;
    const char* kind;
};

class BumpKinds : public testing::TestWithParam<Case> {
protected:
    const Profile profile_ =
        test::profile_with(GetParam().profile, {{"bump_kind", GetParam().kind}});
    const BumpKind kind_ = static_cast<BumpKind>(profile_.bump_kind);
    Bump<Fixed> unit_{profile_};

    /// A map of one texel, or of 3 x 3 with the heights around the middle one.
    void texel(Dice& dice) {
        map_.width = map_.height = kind_ == BumpKind::Slopes ? 3 : 1;
        normal_ = to_raw(upward(dice), profile_.map_normal);
        stored_ = {int16_t(normal_.x), int16_t(normal_.y), int16_t(normal_.z)};
        for (uint16_t& h : heights_) {
            h = static_cast<uint16_t>(dice.integer(0, profile_.height.max_raw()));
        }
        turn_ = {int16_t(to_raw(dice.real(-.45, .45), profile_.angle)),
                 int16_t(to_raw(dice.real(-.45, .45), profile_.angle))};
        // Slopes of up to 4 from one end of the heights to the other.
        const auto mantissa = static_cast<int32_t>(dice.integer(1 << 23, (1 << 24) - 1));
        map_.slope_u = {mantissa, profile_.height.width + 22};
        map_.slope_v = {(1 << 24) - 1, profile_.height.width + 23};
        map_.normals = {&stored_, 1};
        map_.heights = heights_;
        map_.turns = {&turn_, 1};
        unit_.configure(map_);
    }
    glm::dvec3 upward(Dice& dice) {
        glm::dvec3 d = dice.direction();
        d.z = std::abs(d.z) + 0.05;
        return glm::normalize(d);
    }
    /// What the texel stands for, in double.
    glm::dvec3 exact_vector() const {
        const auto scale = [](const SlopeScale<Fixed>& s) {
            return std::ldexp(s.mantissa, -s.exponent);
        };
        const double a = kPi * std::ldexp(turn_.about_b, -profile_.angle.frac);
        const double b = kPi * std::ldexp(turn_.about_t, -profile_.angle.frac);
        switch (kind_) {
            case BumpKind::Slopes:
                return {-(heights_[5] - heights_[3]) * scale(map_.slope_u),
                        -(heights_[7] - heights_[1]) * scale(map_.slope_v), 1.0};
            case BumpKind::Turns:
                return {std::sin(a), std::cos(a) * std::sin(b), std::cos(a) * std::cos(b)};
            case BumpKind::Normals:
                break;
        }
        return to_real(normal_, profile_.map_normal);
    }
    Vertex<Fixed> vertex(const Vec3<int32_t>& n, const Vec3<int32_t>& t, int hand = 1) const {
        Vertex<Fixed> v;
        v.normal = n;
        v.tangent = t;
        v.handedness = int8_t(hand);
        const int32_t middle = kind_ == BumpKind::Slopes ? 3 << profile_.uv.frac >> 1 : 0;
        v.uv = {middle, middle};
        return v;
    }
    glm::dvec3 found(Vertex<Fixed>& v) {
        unit_(v);
        return to_real(v.displaced_normal, profile_.displaced_normal);
    }
    /// Rounding of a component of N' alone, as an angle: it has three.
    double last_rounding_deg() const {
        return kDegrees * std::sqrt(3.0) * 0.5 * std::ldexp(1.02, -profile_.displaced_normal.frac);
    }

    MapView<Fixed> map_;
    Vec3<int32_t> normal_;
    Vec3<int16_t> stored_;
    std::array<uint16_t, 9> heights_{};
    Turn<int16_t> turn_;
};

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

/// What the host makes of a map for each kind.
struct Encoded {
    MapView<Fixed> view;
    MapTables<Fixed> tables;
};

void encode(const Profile& profile, const host::HeightMap& map, Encoded& e) {
    static const host::Mesh mesh = host::make_grid(2, 2);
    host::DrawInputs inputs;
    inputs.mesh = &mesh;
    inputs.map = &map;
    inputs.texel_size = {1.0 / map.width, 0.75 / map.height};
    host::Encoder<Fixed> encoder(profile);
    encoder.map(inputs, true, e.view, e.tables);
    ASSERT_TRUE(encoder.status().ok());
    e.view.heights = e.tables.heights;
    e.view.normals = e.tables.normals;
    e.view.turns = e.tables.turns;
}

// Kinds 1 and 2 say of a whole map what the stored normals say, borders and seams included; what a
// stored normal's own rounding may add is in the tolerance.
TEST_P(BumpKinds, AgreesWithStoredNormalsOnAWholeMap) {
    const Profile stored = test::profile_with(GetParam().profile, {{"bump_kind", "0"}});
    const int32_t one = 1 << profile_.normal.frac;
    for (const bool wrap : {false, true}) {
        host::HeightMap map = host::make_donut_map(24, 17);
        map.wrap = wrap;
        map.range_low = 0.0, map.range_high = 0.4;
        Encoded own, normals;
        encode(profile_, map, own);
        encode(stored, map, normals);
        EXPECT_EQ(own.tables.normals.empty(), kind_ != BumpKind::Normals);
        EXPECT_EQ(own.tables.turns.empty(), kind_ != BumpKind::Turns);
        Bump<Fixed> reference(stored);
        unit_.configure(own.view);
        reference.configure(normals.view);
        // Narrow heights are rounded before they are differenced, stored normals are made of
        // whole ones.
        const double step = 0.4 / double(profile_.height.max_raw()) * 24;
        const double of_heights = kind_ == BumpKind::Slopes ? kDegrees * step : 0.0;
        const double of_normals =
            kDegrees * std::sqrt(3.0) * std::ldexp(1.0, -profile_.map_normal.frac);
        const double of_sines = kDegrees * std::pow(kPi / 2 / (1 << profile_.sine_index_bits), 2);
        for (int y = 0; y < map.height; ++y) {
            for (int x = 0; x < map.width; ++x) {
                Vertex<Fixed> a = vertex({0, one, 0}, {one, 0, 0}, x % 2 == 0 ? 1 : -1);
                a.uv = {x << profile_.uv.frac, y << profile_.uv.frac};
                Vertex<Fixed> b = a;
                unit_(a);
                reference(b);
                ASSERT_LE(angle_deg(to_real(a.displaced_normal, profile_.displaced_normal),
                                    to_real(b.displaced_normal, profile_.displaced_normal)),
                          of_heights + of_normals + of_sines + 2 * last_rounding_deg())
                    << x << ", " << y << (wrap ? ", periodic" : "");
            }
        }
    }
}

// Through vector registers or not: the same bits and counts, frames that are none included.
TEST_P(BumpKinds, ABatchIsItsVerticesOneByOne) {
    host::HeightMap map = host::make_donut_map(24, 17);
    map.wrap = true;
    Encoded own;
    encode(profile_, map, own);
    Bump<Fixed> one_by_one(profile_);
    unit_.configure(own.view);
    one_by_one.configure(own.view);
    const auto batch = std::make_unique<FineVertices<Fixed>>();
    Dice dice(kSeed + 5);
    for (int round = 0; round < 200; ++round) {
        batch->size = static_cast<std::size_t>(dice.integer(0, kFineVertices));
        std::vector<Vec3<int32_t>> expected;
        for (std::size_t i = 0; i < batch->size; ++i) {
            FineVertex<Fixed> v;
            v.uv = {static_cast<int32_t>(dice.integer(0, (24 << profile_.uv.frac) - 1)),
                    static_cast<int32_t>(dice.integer(0, (17 << profile_.uv.frac) - 1))};
            const auto pick = dice.integer(0, 19);
            if (pick == 0) {  // any vectors: B and v saturate
                v.normal = {dice.raw(profile_.normal), dice.raw(profile_.normal), 1};
                v.tangent = {dice.raw(profile_.normal), 2, dice.raw(profile_.normal)};
            } else {
                v.normal = pick == 1 ? Vec3<int32_t>{} : to_raw(dice.direction(), profile_.normal);
                v.tangent = pick == 2   ? v.normal
                            : pick == 3 ? Vec3<int32_t>{}
                                        : to_raw(dice.direction(), profile_.normal);
            }
            v.handedness = dice.flip() ? 1 : -1;
            batch->u[i] = v.uv.x, batch->v[i] = v.uv.y;
            batch->normal.set(i, v.normal);
            batch->tangent.set(i, v.tangent);
            batch->handedness[i] = v.handedness;
            one_by_one(v);
            expected.push_back(v.displaced_normal);
        }
        unit_.run(*batch);
        for (std::size_t i = 0; i < batch->size; ++i) {
            ASSERT_EQ(batch->displaced_normal[i], expected[i]) << round << ", " << i;
        }
    }
    const BumpCounters &a = unit_.counters(), &b = one_by_one.counters();
    EXPECT_EQ(a.items, b.items);
    EXPECT_EQ(a.reads, b.reads);
    EXPECT_EQ(a.overflows, b.overflows);
    EXPECT_EQ(a.degenerate, b.degenerate);
    EXPECT_EQ(a.degenerate_frames, b.degenerate_frames);
    EXPECT_GT(a.degenerate, 0u);
    EXPECT_GT(a.degenerate_frames, a.degenerate);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BumpKinds,
                         testing::Values(Case{"default", "0"}, Case{"default", "1"},
                                         Case{"default", "2"}, Case{"narrow", "0"},
                                         Case{"narrow", "1"}, Case{"narrow", "2"}),
                         [](const auto& c) {
                             return std::string(c.param.profile) + "_" + c.param.kind;
                         });

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

TEST(BumpTurns, AreTheAnglesOfANormal) {
    Dice dice(kSeed);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = dice.direction();
        const glm::dvec2 turn = kPi * host::turns_of(n);
        const glm::dvec3 back(std::sin(turn.x), std::cos(turn.x) * std::sin(turn.y),
                              std::cos(turn.x) * std::cos(turn.y));
        EXPECT_LE(test::farthest(n, back), 1e-12);
    }
    EXPECT_EQ(host::turns_of({0, 0, 1}), glm::dvec2(0, 0));
}

}  // namespace
}  // namespace repousse
