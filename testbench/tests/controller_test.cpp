// controller: order, routes and the vertices of undisplaced triangles.

#include "datapath/units/controller.h"

#include <gtest/gtest.h>

#include <random>

#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

TEST(Controller, NumbersBaseTrianglesInOrderAndRoutesThem) {
    Controller<Fixed> controller(test::profile_with("default", {}));
    std::mt19937 random(3);
    controller.configure(100, false);
    uint64_t direct = 0;
    for (uint32_t base = 0; base < 1000; ++base) {
        const bool is_direct = random() % 2 == 0;
        const std::array<uint32_t, 3> vertices = {
            uint32_t(random() % 100), uint32_t(random() % 100), uint32_t(random() % 100)};
        const OrderToken token = controller(vertices, is_direct);
        ASSERT_EQ(token.base, base);
        ASSERT_EQ(token.route, is_direct ? Route::Direct : Route::Displaced);
        ASSERT_FALSE(controller.bad_index());
        direct += is_direct ? 1 : 0;
    }
    EXPECT_EQ(controller.counters().items, 1000U);
    EXPECT_EQ(controller.counters().direct, direct);
    EXPECT_EQ(controller.counters().displaced, 1000U - direct);
    controller.configure(100, false);  // a draw starts with number 0
    EXPECT_EQ(controller({0, 1, 2}, false).base, 0U);
}

TEST(Controller, ANumberThatNamesNoVertexIsBadInAnyPlace) {
    Controller<Fixed> controller(test::profile_with("default", {}));
    for (std::size_t k = 0; k < 3; ++k) {
        for (const uint32_t bad : {3U, 0xffffffffU}) {
            controller.configure(3, false);
            std::array<uint32_t, 3> vertices = {0, 1, 2};
            controller(vertices, false);
            EXPECT_FALSE(controller.bad_index());
            vertices[k] = bad;
            controller(vertices, k == 1);
            EXPECT_TRUE(controller.bad_index());
        }
    }
    EXPECT_EQ(controller.counters().bad_indices, 6U);
    controller.reset();
    EXPECT_FALSE(controller.bad_index());
    EXPECT_EQ(controller.counters().items, 0U);
}

Vertex<Fixed> corner() {
    Vertex<Fixed> v;
    v.uv = {-100, 257};
    v.position = {1, -2, 3};
    v.normal = {1 << 14, -(1 << 13), 5};  // s1.14
    return v;
}

TEST(Controller, UndisplacedVerticesKeepTheirPlaceAndNormal) {
    Controller<Fixed> controller(test::profile_with("default", {}));
    controller.configure(3, true);
    const SweepOutputVertex<Fixed> out = controller.undisplaced(corner(), 2);
    EXPECT_TRUE((out.name == VertexName{NameKind::Corner, 2, 0, 0}));
    EXPECT_EQ(out.uv, (Uv{-100, 257}));
    EXPECT_EQ(out.displaced, (Vec3<int32_t>{1, -2, 3}));
    // s1.11: three fraction bits less, 5/8 rounds to 1.
    EXPECT_EQ(out.displaced_normal, (Vec3<int32_t>{1 << 11, -(1 << 10), 1}));
    EXPECT_EQ(controller.counters().overflows, 0U);
}

TEST(Controller, WithoutBumpThereAreNoNormals) {
    Controller<Fixed> controller(test::profile_with("default", {}));
    controller.configure(3, false);
    EXPECT_EQ(controller.undisplaced(corner(), 0).displaced_normal, (Vec3<int32_t>{}));
}

TEST(Controller, RealKeepsNormalsAsTheyAre) {
    Controller<Real> controller(test::profile_with("default", {}));
    controller.configure(3, true);
    Vertex<Real> v;
    v.normal = {.1, .2, .3};
    EXPECT_EQ(controller.undisplaced(v, 0).displaced_normal, (Vec3<double>{.1, .2, .3}));
}

}  // namespace
}  // namespace repousse
