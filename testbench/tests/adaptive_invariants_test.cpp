// What no number format and no setting may break at level lt: the same vertex has the same bits,
// no T-vertex, no flipped or empty triangle. Nothing here has a tolerance.

#include <gtest/gtest.h>

#include "testbench/tests/support/soundness.h"

namespace repousse {
namespace {

using test::Object;
using test::Outcome;

struct Scene {
    const char* name;
    Object (*make)();
};

const Scene kScenes[] = {
    {"donut", [] { return test::donut(); }},
    {"column", [] { return test::column(); }},
    {"jacksboro", [] { return test::jacksboro(); }},
};

class Invariants : public testing::TestWithParam<Scene> {
protected:
    const Object object_ = GetParam().make();
    int natural_cap() const { return host::natural_cap(object_.inputs(), 8); }
};

TEST_P(Invariants, HoldAtEveryUvFraction) {
    for (const char* shipped : {"default", "narrow"}) {
        for (int frac = 4; frac <= 16; ++frac) {
            const Outcome outcome =
                test::tessellate<Fixed>(test::profile_with_uv(shipped, frac), object_);
            test::expect_sound(outcome, std::string(shipped) + ", F = " + std::to_string(frac));
            EXPECT_GT(outcome.report.triangles, 10 * outcome.run.base.size());
        }
    }
}

TEST_P(Invariants, HoldAtEveryCap) {
    const int natural = natural_cap();
    for (const char* shipped : {"default", "narrow"}) {
        for (const int frac : {4, 8}) {
            std::size_t before = 0;
            for (int cap = 0; cap <= natural; ++cap) {
                Object object = object_;
                object.settings.generation_cap = cap;
                const Outcome outcome =
                    test::tessellate<Fixed>(test::profile_with_uv(shipped, frac), object);
                test::expect_sound(outcome, std::string(shipped) + ", cap " + std::to_string(cap));
                EXPECT_GE(outcome.report.triangles, before);
                before = outcome.report.triangles;
            }
            EXPECT_GT(before, 10 * object_.mesh.triangles.size());
        }
    }
}

TEST_P(Invariants, HoldWithEveryTestAndOption) {
    for (int tests = 0; tests < 5; ++tests) {
        for (int options = 0; options < 16; ++options) {
            Object object = object_;
            host::AdaptiveSettings& s = object.settings;
            if (tests >= 3) s.normal_threshold.reset();
            if (tests == 0) s.height_threshold.reset();
            const bool sum = tests == 2 || tests == 4;
            s.height_mode = sum ? host::HeightMode::Sum : host::HeightMode::Average;
            if (sum) s.height_threshold = 2e5;
            s.box = options & 1 ? host::BoxKind::Literal : host::BoxKind::Square;
            s.normal_space = options & 2 ? host::NormalSpace::Map : host::NormalSpace::World;
            object.filter =
                options & 4 ? host::HeightFilter::Bilinear : host::HeightFilter::Nearest;
            const char* shipped = options & 8 ? "narrow" : "default";
            const Outcome outcome =
                test::tessellate<Fixed>(test::profile_with(shipped, {}), object);
            test::expect_sound(
                outcome, "tests " + std::to_string(tests) + ", options " + std::to_string(options));
        }
    }
}

TEST_P(Invariants, HoldUnderTheViewTest) {
    host::CameraSettings camera;
    camera.eye = {1.5, -1.6, 1.8};
    camera.target = {0.3, 0.3, 0.4};
    const host::ViewFrame view = host::view_frame(camera, {512, 512});
    std::size_t before = ~std::size_t{0};
    for (const double pixels : {0.0, 4.0, 16.0, 64.0, 4096.0}) {
        Object object = object_;
        object.settings.view_threshold_px = pixels;
        const Outcome outcome =
            test::tessellate<Fixed>(test::profile_with("default", {}), object, 64, view);
        test::expect_sound(outcome, std::to_string(pixels) + " pixels");
        EXPECT_LE(outcome.report.triangles, before);
        before = outcome.report.triangles;
    }
    EXPECT_EQ(before, object_.mesh.triangles.size());  // nothing is longer than 4096 pixels
}

// Order and skipping are the hardware's own business: they must not show in the mesh.
TEST_P(Invariants, OrderAndEagernessChangeNoLeaf) {
    const Profile profile = test::profile_with("default", {});
    const Outcome plain = test::tessellate<Fixed>(profile, object_);
    for (int options = 1; options < 4; ++options) {
        Object object = object_;
        object.settings.order = options & 1 ? host::StackOrder::Fifo : host::StackOrder::Lifo;
        object.settings.eager = (options & 2) != 0;
        const Outcome other = test::tessellate<Fixed>(profile, object);
        EXPECT_EQ(reference::hash_leaves(other.run.leaves),
                  reference::hash_leaves(plain.run.leaves));
        EXPECT_EQ(other.report.vertices, plain.report.vertices);
        EXPECT_EQ(other.run.counters.split.edges_split, plain.run.counters.split.edges_split);
        if (object.settings.eager) {
            EXPECT_EQ(other.run.counters.height_test->tests, other.run.counters.edge_iter.items);
            EXPECT_LT(plain.run.counters.height_test->tests, plain.run.counters.edge_iter.items);
        }
    }
}

// Beyond the natural cap edges are shorter than a texel, and with few fraction bits a midpoint's
// rounding can turn a sliver over. Edges still match: that is a property of names, not of shapes.
TEST_P(Invariants, EdgesMatchBeyondTheNaturalCapToo) {
    const int natural = natural_cap();
    for (const int frac : {0, 1, 2, 3, 4, 5, 6, 8, 16}) {
        for (int over = 1; over <= 3; ++over) {
            Object object = object_;
            object.settings.generation_cap = natural + over;
            const Outcome outcome =
                test::tessellate<Fixed>(test::profile_with_uv("default", frac), object);
            EXPECT_EQ(outcome.report.open_edges, 0u) << frac << ", natural cap + " << over;
            if (outcome.report.flipped + outcome.report.zero_area != 0) {
                std::printf("F = %d, natural cap + %d: %zu flipped, %zu empty of %zu triangles\n",
                            frac, over, outcome.report.flipped, outcome.report.zero_area,
                            outcome.report.triangles);
                EXPECT_LT(frac, 6);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, Invariants, testing::ValuesIn(kScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace repousse
