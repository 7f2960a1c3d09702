// Contexts: whatever their number and however many triangles share a batch, the same bytes leave
// in the same order.

#include "datapath/pipelines/contexts.h"

#include <gtest/gtest.h>

#include <vector>

#include "testbench/tests/support/soundness.h"

namespace repousse {
namespace {

using Output = OutputTriangle<Fixed>;

struct Stream {
    std::vector<Output> triangles;
    std::vector<std::size_t> chunks;  // sizes of what one call of `emit` hands over
    AdaptiveCounters counters;
};

Stream stream_of(const Profile& profile, const AdaptiveDraw<Fixed>& draw, int contexts) {
    Stream stream;
    AdaptivePipeline<Fixed> pipeline(profile, draw);
    EXPECT_TRUE(pipeline.run(
        [&](Span<const Output> triangles) {
            stream.chunks.push_back(triangles.size());
            for (const Output& t : triangles) stream.triangles.push_back(t);
        },
        contexts));
    stream.counters = pipeline.counters();
    return stream;
}

bool same(const Output& a, const Output& b) {
    bool equal = a.path.base == b.path.base && a.path.depth == b.path.depth &&
                 a.path.digits == b.path.digits;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &p = a.corners[k], &q = b.corners[k];
        equal = equal && p.uv == q.uv && p.displaced == q.displaced &&
                p.displaced_normal == q.displaced_normal && p.generation == q.generation;
    }
    return equal;
}

AdaptiveDraw<Fixed> draw_of(const Profile& profile, const test::Object& object) {
    host::DrawInputs in = object.inputs();
    host::CameraSettings camera;
    camera.eye = {1.5, -1.6, 1.8};
    in.view = host::view_frame(camera, {512, 512});
    auto draw = host::make_draw<Fixed>(profile, in);
    EXPECT_TRUE(draw) << draw.error().message();
    return *draw;
}

const Profile kDefault = test::profile_with("default", {});

TEST(Contexts, AnyNumberGivesTheSameStream) {
    for (test::Object object : {test::donut(), test::column(), test::jacksboro()}) {
        for (const auto order : {host::StackOrder::Lifo, host::StackOrder::Fifo}) {
            object.settings.order = order;
            object.settings.view_threshold_px = 4;
            const auto draw = draw_of(kDefault, object);
            const Stream one = stream_of(kDefault, draw, 1);
            ASSERT_GT(one.triangles.size(), 500u);
            for (const int contexts : {2, 4, 7, 64, 1000}) {
                const Stream many = stream_of(kDefault, draw, contexts);
                ASSERT_EQ(many.triangles.size(), one.triangles.size());
                for (std::size_t i = 0; i < one.triangles.size(); ++i) {
                    ASSERT_TRUE(same(many.triangles[i], one.triangles[i])) << contexts << ", " << i;
                }
                EXPECT_EQ(many.chunks, one.chunks);
                const auto a = one.counters.rows(), b = many.counters.rows();
                ASSERT_EQ(a.size(), b.size());
                for (std::size_t i = 0; i < a.size(); ++i) {
                    EXPECT_EQ(a[i].value, b[i].value) << a[i].unit << "." << a[i].name;
                }
            }
        }
    }
}

// Base triangles in their own order, one chunk each; within one, depth first with the last child
// first. The path alone says where a triangle belongs.
TEST(Contexts, OrderIsArchitectural) {
    const auto draw = draw_of(kDefault, test::donut());
    const Stream stream = stream_of(kDefault, draw, 64);
    EXPECT_EQ(stream.chunks.size(), draw.triangles.size());
    const auto digit = [](const Path& p, unsigned i) {
        return p.digits[i / 32] >> (2 * (i % 32)) & 3;
    };
    for (std::size_t i = 1; i < stream.triangles.size(); ++i) {
        const Path &before = stream.triangles[i - 1].path, &after = stream.triangles[i].path;
        ASSERT_LE(before.base, after.base);
        if (before.base != after.base) continue;
        unsigned k = 0;
        while (k < before.depth && k < after.depth && digit(before, k) == digit(after, k)) ++k;
        ASSERT_LT(k, before.depth);  // no triangle is an ancestor of another one
        ASSERT_LT(k, after.depth);
        ASSERT_GT(digit(before, k), digit(after, k));
    }
}

TEST(Contexts, AnEmptyDrawEmitsNothing) {
    auto draw = draw_of(kDefault, test::donut());
    draw.triangles.clear();
    const Stream stream = stream_of(kDefault, draw, 4);
    EXPECT_TRUE(stream.triangles.empty());
    EXPECT_TRUE(stream.chunks.empty());
    EXPECT_EQ(stream.counters.split.items, 0u);
}

// A stack that is too small must say so: here the bound is broken on purpose, by contexts made for
// a smaller cap than the edges obey.
TEST(Contexts, ABrokenBoundIsReported) {
    auto draw = draw_of(kDefault, test::donut());
    Contexts<Fixed> lanes(1, StackOrder::Lifo, 0);
    std::vector<Triangle<Fixed>> batch(1);
    ASSERT_EQ(
        lanes.gather(batch, [&](Triangle<Fixed>& t) { return t = draw.base_triangle(0), true; }),
        1u);
    Split<Fixed> split(kDefault);
    std::array<Edge<Fixed>, 3> edges;
    for (auto& edge : edges) edge.split = true;
    Children<Fixed> children;
    split.tessellate(batch[0], edges.data(), children);
    EXPECT_FALSE(lanes.scatter(0, batch[0], children));
    EXPECT_EQ(lanes.peak(), 1u);
}

}  // namespace
}  // namespace repousse
