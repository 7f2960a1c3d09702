// vertex_transform: pixels against doubles, with a bound made of the formats' roundings.

#include "datapath/units/vertex_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include <glm/vec2.hpp>

#include "testbench/tests/support/profiles.h"
#include "testbench/tests/support/vertices.h"

namespace repousse {
namespace {

using test::Dice;
using test::to_raw;
using test::to_real;

constexpr uint64_t kSeed = 51;

class VertexTransformUnit : public testing::TestWithParam<const char*> {
protected:
    const Profile profile_ = test::profile_with(GetParam(), {});
    VertexTransform<Fixed> unit_{profile_};
    ViewRegisters<Fixed> view_;
    // What the registers were made from.
    glm::dvec3 eye_{0.0}, right_{1, 0, 0}, up_{0, 1, 0}, forward_{0, 0, -1};
    double focal_ = 700.0, centre_ = 512.0, near_ = 0.25;

    void camera(const glm::dvec3& eye, const glm::dvec3& direction) {
        eye_ = to_real(to_raw(eye, profile_.position), profile_.position);
        forward_ = glm::normalize(direction);
        right_ = glm::normalize(glm::cross(forward_, glm::dvec3(0.1, 0.2, 1.0)));
        up_ = glm::cross(right_, forward_);
        view_.eye = to_raw(eye_, profile_.position);
        view_.right = to_raw(right_, profile_.view_row);
        view_.up = to_raw(up_, profile_.view_row);
        view_.forward = to_raw(forward_, profile_.view_row);
        view_.near = to_raw(near_, profile_.clip);
        view_.focal_x = to_raw(focal_, profile_.focal);
        view_.focal_y = to_raw(-focal_, profile_.focal);
        view_.centre_x = view_.centre_y = to_raw(centre_, profile_.focal);
        unit_.configure(view_);
    }
    double half_lsb(const Format& f) const { return std::ldexp(0.5, -f.frac); }
    double pixels(int32_t raw) const { return std::ldexp(raw, -profile_.screen.frac); }
};

// In pixels: the last rounding; and focal times the error of x/w, which has its own rounding, that
// of the reciprocal, and the errors of x and w. Those are a rounding to `clip` and three rounded
// components of a row times |e|.
TEST_P(VertexTransformUnit, PixelsAreWithinTheRoundingsOfTheExactProjection) {
    Dice dice(kSeed);
    double worst = 0, worst_share = 0;
    int visible = 0;
    for (int n = 0; n < 200; ++n) {
        camera({dice.real(-20, 20), dice.real(-20, 20), dice.real(-20, 20)}, dice.direction());
        for (int i = 0; i < 500; ++i) {
            const double depth = std::exp(dice.real(std::log(0.3), std::log(20.0)));
            const glm::dvec3 wanted = eye_ + depth * (forward_ + dice.real(-0.7, 0.7) * right_ +
                                                      dice.real(-0.7, 0.7) * up_);
            const auto p = to_raw(wanted, profile_.position);
            const glm::dvec3 e = to_real(p, profile_.position) - eye_;
            const double w = glm::dot(forward_, e);
            const glm::dvec2 ratio(glm::dot(right_, e) / w, glm::dot(up_, e) / w);
            const auto screen = unit_(p);
            const double side = half_lsb(profile_.clip) +
                                std::sqrt(3.0) * half_lsb(profile_.view_row) * glm::length(e);
            for (int axis = 0; axis < 2; ++axis) {
                const double r = std::abs(ratio[axis]);
                const double in_ratio = half_lsb(profile_.ndc) + (1 + r) * side / (w - side) +
                                        r * std::ldexp(1.0, -profile_.reciprocal_bits);
                const double bound = half_lsb(profile_.screen) + focal_ * in_ratio;
                const double exact = centre_ + (axis == 0 ? focal_ : -focal_) * ratio[axis];
                const double error = std::abs(pixels(axis == 0 ? screen.x : screen.y) - exact);
                ASSERT_LE(error, bound) << "w = " << w;
                worst_share = std::max(worst_share, error / bound);
                if (w >= 1.0) worst = std::max(worst, error);
            }
            visible += !screen.near;
        }
    }
    std::printf("%s, seed %llu: worst %.4f pixels at w >= 1, %.2f of the bound at any w\n",
                GetParam(), (unsigned long long)kSeed, worst, worst_share);
    EXPECT_EQ(visible, 200 * 500);
    EXPECT_EQ(unit_.counters().overflows, 0u);
    EXPECT_GT(worst_share, 0.3);
    EXPECT_LE(worst, std::string(GetParam()) == "default" ? 1.0 / 16 : 1.0 / 4);
}

TEST_P(VertexTransformUnit, TheViewAxisMeetsTheCentre) {
    camera({1, 2, 3}, {1, 0, 0});
    for (const double depth : {0.5, 1.0, 7.0}) {
        const auto screen = unit_(to_raw(eye_ + glm::dvec3(depth, 0, 0), profile_.position));
        EXPECT_EQ(pixels(screen.x), centre_);
        EXPECT_EQ(pixels(screen.y), centre_);
        EXPECT_FALSE(screen.near);
    }
}

TEST_P(VertexTransformUnit, RowsRunDownwards) {
    camera({0, 0, 0}, {0, 1, 0});
    const auto above = unit_(to_raw(2.0 * forward_ + up_, profile_.position));
    EXPECT_LT(above.y, above.x);
    EXPECT_NEAR(pixels(above.y), centre_ - focal_ / 2, 0.2);
}

TEST_P(VertexTransformUnit, TheNearPlaneItselfIsNear) {
    camera({0, 0, 0}, {1, 0, 0});
    const int32_t at = to_raw(near_, profile_.position);
    EXPECT_TRUE(unit_({at, 0, 0}).near);
    // The next depth that `clip` can tell apart.
    const int32_t step = 1 << std::max(0, profile_.position.frac - profile_.clip.frac);
    EXPECT_FALSE(unit_({at + step, 0, 0}).near);
    const auto behind = unit_({-at, 5, 5});
    EXPECT_TRUE(behind.near);
    EXPECT_EQ(behind.x, 0);
    EXPECT_EQ(behind.y, 0);
    EXPECT_TRUE(unit_({0, 0, 0}).near);  // at the eye
    EXPECT_EQ(unit_.counters().behind, 3u);
    EXPECT_EQ(unit_.counters().items, 4u);
}

TEST_P(VertexTransformUnit, FarOutsideSaturatesWithTheRightSignAndIsCounted) {
    camera({0, 0, 0}, {1, 0, 0});
    const double side = std::ldexp(1.0, profile_.position.width - profile_.position.frac - 2);
    const auto p = to_raw(0.3 * forward_ + side * right_, profile_.position);
    const auto screen = unit_(p);
    EXPECT_FALSE(screen.near);
    EXPECT_EQ(screen.x, profile_.screen.max_raw());
    EXPECT_GE(unit_.counters().overflows, 1u);
    const auto other = unit_(to_raw(0.3 * forward_ - side * right_, profile_.position));
    EXPECT_EQ(other.x, profile_.screen.min_raw());
    unit_.reset();
    EXPECT_EQ(unit_.counters().overflows, 0u);
}

TEST_P(VertexTransformUnit, OnlySplitEdgesAreTransformed) {
    camera({0, 0, 0}, {1, 0, 0});
    Edge<Fixed> edges[3];
    edges[1].split = true;
    unit_.run(edges);
    EXPECT_EQ(unit_.counters().items, 1u);
    EXPECT_TRUE(edges[1].mid.screen.near);
}

INSTANTIATE_TEST_SUITE_P(Profile, VertexTransformUnit, testing::Values("default", "narrow"));

TEST(VertexTransformReal, IsThePlainFormula) {
    ViewRegisters<Real> view;
    view.eye = {0, 0, 5};
    view.right = {1, 0, 0};
    view.up = {0, 1, 0};
    view.forward = {0, 0, -1};
    view.near = 0.1;
    view.focal_x = 100;
    view.focal_y = -100;
    view.centre_x = view.centre_y = 50;
    VertexTransform<Real> unit(test::profile_with("default", {}));
    unit.configure(view);
    const auto p = unit({1, 2, 1});
    EXPECT_DOUBLE_EQ(p.x, 75);
    EXPECT_DOUBLE_EQ(p.y, 0);
    EXPECT_TRUE(unit({0, 0, 4.95}).near);
}

}  // namespace
}  // namespace repousse
