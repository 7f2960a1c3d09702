// normalise: both kinds against doubles, at every length from one LSB on, and inside mid_vertex and
// bump with vectors that have no direction.

#include "datapath/units/normalise.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "datapath/numbers/cordic.h"
#include "datapath/units/bump.h"
#include "datapath/units/mid_vertex.h"
#include "testbench/host/files.h"
#include "testbench/study/normalise.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::farthest;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 41;

struct Case {
    const char* profile;
    int kind;
};

class NormaliseUnit : public testing::TestWithParam<Case> {
protected:
    const Profile profile_ = test::profile_with(
        GetParam().profile, {{"normalise_kind", std::to_string(GetParam().kind)}});
    Normalise<Fixed> unit_{profile_};
};

INSTANTIATE_TEST_SUITE_P(Kinds, NormaliseUnit,
                         testing::Values(Case{"default", 0}, Case{"default", 1}, Case{"narrow", 0},
                                         Case{"narrow", 1}),
                         [](const auto& c) {
                             return std::string(c.param.profile) +
                                    (c.param.kind == 0 ? "InverseSqrt" : "Cordic");
                         });

glm::dvec3 exact(const Vec3<int32_t>& v) { return glm::normalize(glm::dvec3(v.x, v.y, v.z)); }

TEST_P(NormaliseUnit, ErrsByLittleMoreThanHalfAUnitAtEveryLength) {
    const double lsb = std::ldexp(1.0, -profile_.normal.frac);
    // Before the last rounding: 2^-bits + 2^-30 by the inverse square root, a quarter by CORDIC.
    const double before = GetParam().kind == 0 ? 2 * std::ldexp(1.0, -profile_.inverse_sqrt_bits) +
                                                     std::ldexp(1.0, -30)
                                               : lsb / 4;
    Dice dice(kSeed);
    double worst = 0;
    for (int bits = 1; bits < profile_.unnormalised.width; ++bits) {
        const int64_t limit = int64_t{1} << (bits - 1);
        for (int i = 0; i < 20'000; ++i) {
            const auto component = [&] { return int32_t(dice.integer(-limit, limit - 1)); };
            const Vec3<int32_t> v{component(), component(), component()};
            if (v == Vec3<int32_t>{}) continue;
            worst = std::max(worst, farthest(to_real(unit_(v), profile_.normal), exact(v)));
        }
    }
    std::printf("worst component: %.4f LSB\n", worst / lsb);
    EXPECT_LE(worst, lsb / 2 + before);
    EXPECT_GT(worst, 0.45 * lsb);
    EXPECT_GT(unit_.counters().items, 0U);
}

TEST_P(NormaliseUnit, EveryShortVector) {
    // All 9 261 vectors of up to ten LSB a component; the opposite vector gives the opposite result
    // but where a tie goes up.
    const double lsb = std::ldexp(1.0, -profile_.normal.frac);
    for (int32_t x = -10; x <= 10; ++x) {
        for (int32_t y = -10; y <= 10; ++y) {
            for (int32_t z = -10; z <= 10; ++z) {
                const Vec3<int32_t> v{x, y, z};
                const Vec3<int32_t> unit = unit_(v);
                if (v == Vec3<int32_t>{}) {
                    EXPECT_EQ(unit, v);
                    continue;
                }
                ASSERT_LE(farthest(to_real(unit, profile_.normal), exact(v)), 0.75 * lsb);
                const Vec3<int32_t> back = unit_({-x, -y, -z});
                ASSERT_LE(std::abs(unit.x + back.x), 1);
                ASSERT_LE(std::abs(unit.y + back.y), 1);
                ASSERT_LE(std::abs(unit.z + back.z), 1);
            }
        }
    }
    EXPECT_EQ(unit_.counters().degenerate, 1U);
}

TEST_P(NormaliseUnit, AxesAreExactAtEveryLength) {
    const int32_t one = 1 << profile_.normal.frac;
    const auto most = static_cast<int32_t>(profile_.unnormalised.max_raw());
    for (int32_t length = 1; length > 0 && length <= most; length = length * 2 + 1) {
        EXPECT_EQ(unit_({length, 0, 0}), (Vec3<int32_t>{one, 0, 0}));
        EXPECT_EQ(unit_({0, -length, 0}), (Vec3<int32_t>{0, -one, 0}));
        EXPECT_EQ(unit_({0, 0, length}), (Vec3<int32_t>{0, 0, one}));
    }
    const auto least = static_cast<int32_t>(profile_.unnormalised.min_raw());
    EXPECT_EQ(unit_({least, 0, 0}), (Vec3<int32_t>{-one, 0, 0}));
}

TEST_P(NormaliseUnit, CornersOfTheFormat) {
    const double lsb = std::ldexp(1.0, -profile_.normal.frac);
    const auto most = static_cast<int32_t>(profile_.unnormalised.max_raw());
    const auto least = static_cast<int32_t>(profile_.unnormalised.min_raw());
    for (const int32_t x : {least, 0, 1, most}) {
        for (const int32_t y : {least, -1, 0, most}) {
            for (const int32_t z : {least, most}) {
                const Vec3<int32_t> v{x, y, z};
                EXPECT_LE(farthest(to_real(unit_(v), profile_.normal), exact(v)), 0.75 * lsb);
            }
        }
    }
}

TEST_P(NormaliseUnit, OppositeNormalsAndTangentsInMidVertex) {
    MidVertex<Fixed> unit(profile_);
    Dice dice(kSeed + 1);
    for (int i = 0; i < 1000; ++i) {
        Vertex<Fixed> a, b, mid;
        a.normal = to_raw(dice.direction(), profile_.normal);
        a.tangent = to_raw(dice.direction(), profile_.normal);
        b.normal = {-a.normal.x, -a.normal.y, -a.normal.z};
        b.tangent = {1 - a.tangent.x, -a.tangent.y, -a.tangent.z};  // all but opposite
        unit.attributes(a, b, mid);
        ASSERT_EQ(mid.normal, Vec3<int32_t>{});
        ASSERT_EQ(mid.tangent, (Vec3<int32_t>{1 << profile_.normal.frac, 0, 0}));
    }
    EXPECT_EQ(unit.counters().degenerate, 1000U);
    EXPECT_EQ(unit.counters().overflows, 0U);
}

TEST_P(NormaliseUnit, DegenerateFramesInBump) {
    const int32_t one = 1 << profile_.normal.frac, map_one = 1 << profile_.map_normal.frac;
    const Vec3<int32_t> axis{0, 0, one}, none{}, tilted{one / 2, -one / 2, one / 2};
    for (const Vec3<int32_t>& normal : {axis, none, tilted}) {
        for (const Vec3<int32_t>& tangent : {axis, none, tilted}) {
            Bump<Fixed> unit(profile_);
            const Vec3<int16_t> texels[] = {{int16_t(map_one / 2), int16_t(-map_one / 2), 0}};
            MapView<Fixed> map;
            map.width = map.height = 1;
            map.wrap = true;
            map.normals = texels;
            unit.configure(map);
            Vertex<Fixed> vertex;
            vertex.normal = normal;
            vertex.tangent = tangent;
            unit(vertex);
            EXPECT_EQ(unit.counters().overflows, 0U);
            const bool zero = vertex.displaced_normal == Vec3<int32_t>{};
            EXPECT_EQ(unit.counters().degenerate, zero ? 1U : 0U);
            if (!zero) {
                const glm::dvec3 n = to_real(vertex.displaced_normal, profile_.displaced_normal);
                EXPECT_NEAR(glm::length(n), 1.0, std::ldexp(2.0, -profile_.displaced_normal.frac));
            }
        }
    }
}

TEST(Cordic, IsWithinAQuarterOfTheLastBitBeforeRounding) {
    for (int frac = Cordic::kMinFrac; frac <= Cordic::kMaxFrac; ++frac) {
        const Cordic cordic(frac);
        Dice dice(kSeed + 2);
        double worst = 0;
        for (int i = 0; i < 50'000; ++i) {
            const int64_t limit = int64_t{1} << dice.integer(0, Cordic::kInputBits - 1);
            const auto component = [&] { return dice.integer(-limit, limit - 1); };
            const int64_t x = component(), y = component(), z = component();
            if ((x | y | z) == 0) continue;
            const auto found = cordic(x, y, z);
            const glm::dvec3 unit = glm::normalize(glm::dvec3(x, y, z));
            for (int k = 0; k < 3; ++k) {
                const double value = std::ldexp(double(found[std::size_t(k)]), -cordic.bits());
                worst = std::max(worst, std::abs(value - unit[k]));
            }
        }
        EXPECT_LE(worst, std::ldexp(0.25, -frac)) << frac;
    }
    EXPECT_EQ(Cordic(14)(0, 0, 0), (std::array<int64_t, 3>{}));
    EXPECT_EQ(Cordic(0).steps(), Cordic(Cordic::kMinFrac).steps());
    EXPECT_EQ(Cordic(60).bits(), Cordic(Cordic::kMaxFrac).bits());
}

TEST(NormaliseStudy, AngularErrorAndTheDocumentThatSaysSo) {
    const study::NormaliseReport report = study::normalise_study(1);
    for (const study::NormaliseError& e : report.errors) {
        if (e.profile == "default") {
            EXPECT_LE(e.max_deg, 0.1) << e.what;
        }
    }
    ASSERT_EQ(report.bumps.size(), 12U);
    for (const study::BumpError& e : report.bumps) {
        if (e.profile == "default") {
            EXPECT_LE(e.max_deg, 0.1) << e.bump_kind;
            EXPECT_LE(e.map_max_deg, 0.1) << e.bump_kind;
        }
    }
    const auto text = host::read_file("docs/normalise.md");
    ASSERT_TRUE(text) << text.error().message();
    EXPECT_EQ(*text, study::normalise_markdown(report))
        << "stale: run repousse study normalise -o docs/normalise.md";
}

}  // namespace
}  // namespace repousse
