// Every kind of bump in the device, by both methods: the bytes of the bare loops, the normals of
// level ref, and what is refused. Each device elaborates in a child process.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "testbench/tests/support/platform_draws.h"
#include "testbench/tests/support/platform_run.h"
#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

class BumpPlatform : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with("default", {{"bump_kind", GetParam()}});

    /// Few triangles, some of them split by the normal test.
    static host::DrawInputs adaptive_inputs() {
        host::DrawInputs inputs = test::inputs_for(test::grid(), true);
        inputs.settings.normal_threshold = 0.4;
        inputs.settings.generation_cap = 3;
        return inputs;
    }
    std::vector<shell::Draw> draws() const {
        return {*host::make_draw<Fixed>(profile_, adaptive_inputs()),
                test::sweep_draw(profile_, true, 4)};
    }
};

TEST_P(BumpPlatform, GivesTheBareLoopsBytesByBothMethods) {
    const std::vector<shell::Draw> both = draws();
    const DeviceConfig config = test::config_for(profile_, both);
    EXPECT_EXIT(std::exit(test::compare(config, both)), testing::ExitedWithCode(0), "");
}

// Where both levels have a vertex, by its texture coordinates.
TEST_P(BumpPlatform, NormalsAreThoseOfLevelRef) {
    const Profile reference = host::reference_profile(profile_);
    auto exact = host::make_draw<Real>(reference, adaptive_inputs());
    ASSERT_TRUE(exact.ok()) << exact.error().message();
    std::map<std::pair<int32_t, int32_t>, glm::dvec3> normals;
    AdaptivePipeline<Real>(reference, *exact).run([&](Span<const OutputTriangle<Real>> some) {
        for (const OutputTriangle<Real>& triangle : some) {
            for (const OutputVertex<Real>& v : triangle.corners) {
                const Vec3<double>& n = v.displaced_normal;
                normals[{v.uv.x, v.uv.y}] = {n.x, n.y, n.z};
            }
        }
    });
    const auto fixed = host::make_draw<Fixed>(profile_, adaptive_inputs());
    ASSERT_TRUE(fixed.ok()) << fixed.error().message();
    std::size_t found = 0;
    double worst = 0, tilt = 0;
    AdaptivePipeline<Fixed>(profile_, *fixed).run([&](Span<const OutputTriangle<Fixed>> some) {
        for (const OutputTriangle<Fixed>& triangle : some) {
            for (const OutputVertex<Fixed>& v : triangle.corners) {
                const auto at = normals.find({v.uv.x, v.uv.y});
                if (at == normals.end()) continue;
                ++found;
                const glm::dvec3 n = test::to_real(v.displaced_normal, profile_.displaced_normal);
                const glm::dvec3 across = glm::cross(n, at->second);
                worst = std::max(worst, glm::length(across) / glm::length(n));
                tilt = std::max(tilt, 1.0 - at->second.z);
            }
        }
    });
    EXPECT_GT(found, 100U);
    EXPECT_GT(tilt, 0.1);                 // the map has slopes
    EXPECT_LE(worst, 0.1 / 57.29577951);  // 0.1 degree
}

INSTANTIATE_TEST_SUITE_P(Kinds, BumpPlatform, testing::Values("0", "1", "2"));

TEST(BumpPlatformTables, AreOnlyThoseOfTheKind) {
    for (const char* kind : {"0", "1", "2"}) {
        const Profile profile = test::profile_with("default", {{"bump_kind", kind}});
        const auto draw = test::sweep_draw(profile, true, 4);
        EXPECT_EQ(draw.tables.normals.size(), kind[0] == '0' ? 64U * 64 : 0U);
        EXPECT_EQ(draw.tables.turns.size(), kind[0] == '2' ? 64U * 64 : 0U);
        EXPECT_EQ(draw.map.slope_u.mantissa != 0, kind[0] == '1');
    }
}

TEST(BumpPlatformTables, SlopesHaveNoNormalForTheTestInMapSpace) {
    const Profile profile = test::profile_with("default", {{"bump_kind", "1"}});
    host::DrawInputs inputs = test::inputs_for(test::grid(), false);
    inputs.settings.normal_threshold = 0.4;
    inputs.settings.normal_space = NormalSpace::Map;
    const auto refused = host::make_draw<Fixed>(profile, inputs);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message().find("map space"), std::string::npos);

    // A driver that asks for it all the same gets an error from the device.
    inputs.settings.normal_space = NormalSpace::World;
    auto draw = host::make_draw<Fixed>(profile, inputs);
    ASSERT_TRUE(draw.ok());
    draw->registers.normal_space = NormalSpace::Map;
    const std::vector<shell::Draw> draws{*draw};
    const DeviceConfig config = test::config_for(profile, draws);
    EXPECT_EXIT(std::exit(test::compare(config, draws)), testing::ExitedWithCode(2), "");
}

}  // namespace
}  // namespace repousse
