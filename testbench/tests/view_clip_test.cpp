// The hard cases of conservative clipping, by name, in eye space.

#include "datapath/units/view_clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "testbench/host/clip_registers.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

int32_t rounded(double x, const Format& format) {
    return static_cast<int32_t>(std::clamp(std::floor(std::ldexp(x, format.frac) + 0.5),
                                           static_cast<double>(format.min_raw()),
                                           static_cast<double>(format.max_raw())));
}

class ViewClipCase : public testing::Test {
protected:
    ViewClipCase() : profile_(*shipped_profile("default")), unit_(profile_) {
        host::CameraSettings camera;
        camera.fov_deg = 90;
        camera.near = 1;
        camera.far = 100;
        unit_.configure(host::make_clip_registers<Fixed>(profile_, camera, {800, 800}));
    }

    static EyePoint<Fixed> point(double x, double y, double w) {
        const Format clip = (*shipped_profile("default")).clip;
        return {rounded(x, clip), rounded(y, clip), rounded(w, clip)};
    }
    bool rejects(EyePoint<Fixed> a, EyePoint<Fixed> b, EyePoint<Fixed> c, double d) {
        return unit_({a, b, c}, rounded(d, profile_.displacement));
    }
    uint64_t beyond(ClipPlane plane) const {
        return unit_.counters().planes[static_cast<std::size_t>(plane)];
    }

    Profile profile_;
    ViewClip<Fixed> unit_;
};

TEST_F(ViewClipCase, EachPlane) {
    const auto at = [&](double x, double y, double w) {
        return rejects(point(x, y, w), point(x, y, w), point(x, y, w), 0);
    };
    EXPECT_FALSE(at(0, 0, 10));
    EXPECT_TRUE(at(-11, 0, 10));
    EXPECT_EQ(beyond(ClipPlane::Left), 1U);
    EXPECT_TRUE(at(11, 0, 10));
    EXPECT_EQ(beyond(ClipPlane::Right), 1U);
    EXPECT_TRUE(at(0, -11, 10));
    EXPECT_EQ(beyond(ClipPlane::Bottom), 1U);
    EXPECT_TRUE(at(0, 11, 10));
    EXPECT_EQ(beyond(ClipPlane::Top), 1U);
    EXPECT_TRUE(at(0, 0, 0.99));
    EXPECT_EQ(beyond(ClipPlane::Near), 1U);
    EXPECT_TRUE(at(0, 0, 100.1));
    EXPECT_EQ(beyond(ClipPlane::Far), 1U);
    EXPECT_EQ(unit_.counters().items, 7U);
    EXPECT_EQ(unit_.counters().rejected, 6U);
}

TEST_F(ViewClipCase, CornersBeyondDifferentPlanesAreKept) {
    EXPECT_FALSE(rejects(point(-20, 0, 10), point(20, 0, 10), point(0, 30, 10), 0));
}

TEST_F(ViewClipCase, TriangleThroughTheEye) {
    EXPECT_FALSE(rejects(point(0, 0, 0), point(5, 0, 10), point(-5, 0, 10), 0));
    EXPECT_FALSE(rejects(point(1, 1, -5), point(-1, 1, 5), point(0, -1, 5), 0));
}

TEST_F(ViewClipCase, BehindTheEye) {
    EXPECT_TRUE(rejects(point(0, 0, -5), point(1, 0, -6), point(0, 1, -7), 0));
    EXPECT_FALSE(rejects(point(0, 0, -5), point(1, 0, -6), point(0, 1, -7), 8))
        << "displaced past the eye";
}

TEST_F(ViewClipCase, DisplacementLargerThanTheNearDistance) {
    // Equation 8 has its pole at d = near and the wrong sign beyond.
    for (const double d : {0.99, 1.0, 1.01, 5.0}) {
        EXPECT_FALSE(rejects(point(0, 0, 0.5), point(0.1, 0, 0.5), point(0, 0.1, 0.5), d)) << d;
        EXPECT_TRUE(rejects(point(50, 0, 10), point(51, 0, 10), point(50, 1, 10), d)) << d;
    }
}

TEST_F(ViewClipCase, ReachIsOneOverTheCosine) {
    // 90 degrees: d_xy = d sqrt(2) at the depth of the corners (equation 7).
    const auto at = [&](double x) {
        return rejects(point(x, 0, 10), point(x, 0.1, 10), point(x, -0.1, 10), 1.0);
    };
    EXPECT_FALSE(at(10 + std::sqrt(2.0) - 0.001));
    EXPECT_TRUE(at(10 + std::sqrt(2.0) + 0.001));
}

TEST_F(ViewClipCase, SaturatedCornersAreKept) {
    // x = 40000, w = 80000 is in the view, but both are cut to 32768 on their way.
    const auto p = point(40000, 0, 80000);
    EXPECT_FALSE(rejects(p, p, p, 0));
}

TEST_F(ViewClipCase, HugeDisplacement) {
    const auto low = static_cast<int32_t>(profile_.clip.min_raw());
    const auto high = static_cast<int32_t>(profile_.clip.max_raw());
    const auto most = static_cast<int32_t>(profile_.displacement.max_raw());
    EXPECT_FALSE(unit_({{{low, low, low}, {high, high, high}, {low, high, low}}}, most));
    EXPECT_FALSE(unit_({{{low, 0, 0}, {low, 0, 1}, {low, 1, 0}}}, most));
    EXPECT_FALSE(rejects(point(2000, 0, 10), point(2000, 1, 10), point(2000, 0, 11), 2000));
    EXPECT_TRUE(rejects(point(9000, 0, 10), point(9000, 1, 10), point(9000, 0, 11), 2000));
}

TEST_F(ViewClipCase, TransactionsSurvivePacking) {
    const ViewClipIn in{{{{1, -2, 3}, {-4, 5, -6}, {7, 8, 9}}}, 10};
    EXPECT_EQ(ViewClipIn::unpack(in.pack().data()).pack(), in.pack());
}

TEST(ViewClipReal, HasExactPlanesAndNoMargin) {
    const Profile profile = *shipped_profile("default");
    ViewClip<Real> unit(profile);
    host::CameraSettings camera;
    camera.fov_deg = 60;
    unit.configure(host::make_clip_registers<Real>(profile, camera, {100, 100}));
    const double slope = std::tan(glm::radians(30.0));
    const auto at = [&](double x) {
        const EyePoint<Real> p{x, 0, 10};
        return unit({p, p, p}, 0.0);
    };
    EXPECT_FALSE(at(10 * slope * (1 - 1e-12)));
    EXPECT_TRUE(at(10 * slope * (1 + 1e-12)));
    EXPECT_TRUE(at(1e9)) << "doubles do not saturate";
}

}  // namespace
}  // namespace repousse
