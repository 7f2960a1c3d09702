// The registers of view_clip: rounded so that nothing visible is lost.

#include "testbench/host/clip_registers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>

#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using Registers = ClipRegisters<Fixed>;

TEST(ClipRegisters, PlanesAreTurnedOutwardsAndAtMostOneLong) {
    const Profile profile = *shipped_profile("default");
    const double one = std::ldexp(1.0, profile.view_row.frac);
    for (double fov = 0.5; fov < 179.9; fov += 0.37) {
        host::CameraSettings camera;
        camera.fov_deg = fov;
        const Registers r = host::make_clip_registers<Fixed>(profile, camera, {1000, 600});
        const double slope = std::tan(0.5 * glm::radians(fov));
        EXPECT_GE(double(r.sine_y), slope * r.cosine_y) << fov;
        EXPECT_GE(double(r.sine_x), slope * r.cosine_x * 1000 / 600) << fov;
        EXPECT_LE(std::hypot(double(r.sine_x), double(r.cosine_x)), one);
        EXPECT_LE(std::hypot(double(r.sine_y), double(r.cosine_y)), one);
        EXPECT_NEAR(std::atan2(r.sine_y, r.cosine_y), 0.5 * glm::radians(fov), 1e-4) << fov;
    }
}

TEST(ClipRegisters, DisplacementIsRoundedUpOrRefused) {
    const Profile profile = *shipped_profile("default");
    for (const double d : {0.0, 1e-9, 0.25, -0.25, 3.0, 2000.0}) {
        const auto raw = host::max_displacement_register<Fixed>(profile, d);
        ASSERT_TRUE(raw.ok());
        const double value = std::ldexp(*raw, -profile.displacement.frac);
        EXPECT_GT(value, std::abs(d));
        EXPECT_LT(value, std::abs(d) * 1.0002 + 4e-6);
    }
    EXPECT_FALSE(host::max_displacement_register<Fixed>(profile, 2048.0).ok());
}

}  // namespace
}  // namespace repousse
