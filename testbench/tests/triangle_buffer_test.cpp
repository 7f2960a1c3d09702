// triangle_buffer: whatever order two sources offer their triangles in, they leave in the order of
// their base triangles, none lost and none twice.

#include "datapath/units/triangle_buffer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace repousse {
namespace {

// A triangle that says where it belongs: base triangle, number within it.
using Item = std::pair<uint32_t, uint32_t>;
// A buffer whose vertices say which triangle they came with; a triangle comes with one.
struct Buffer : TriangleBuffer<Item> {
    using TriangleBuffer<Item>::TriangleBuffer;

    std::size_t push(Span<const Item> items) {
        const uint32_t first = vertex_count();
        const std::size_t n =
            push_vertices(items.size(), [&](std::size_t i, Item& vertex) { vertex = items[i]; });
        if (n == 0) return 0;
        return TriangleBuffer<Item>::push(n, [&](std::size_t i, FineTriangle& triangle) {
            const uint32_t number = first + static_cast<uint32_t>(i);
            triangle = {items[i].first, {number, number, number}};
        });
    }
    bool push_direct(Item item) {
        return TriangleBuffer<Item>::push_direct({item.first, {item, item, item}});
    }
    void clear() {
        TriangleBuffer<Item>::clear();
        vertices.clear();
    }

    std::vector<Item> vertices;  // that have left
};

OrderToken displaced(uint32_t base) { return {base, Route::Displaced}; }
OrderToken direct(uint32_t base) { return {base, Route::Direct}; }

// What leaves, by the vertices that the triangles refer to: they have left before.
struct Sink {
    void operator()(Span<const Item> some) {
        vertices.insert(vertices.end(), some.begin(), some.end());
    }
    void operator()(Span<const FineTriangle> some) {
        for (const FineTriangle& triangle : some) {
            for (const uint32_t number : triangle.vertices) {
                ASSERT_LT(number, vertices.size());
                ASSERT_EQ(vertices[number].first, triangle.base);
            }
            out.push_back(vertices[triangle.vertices[0]]);
        }
    }
    std::vector<Item>& vertices;
    std::vector<Item> out;
};

std::vector<Item> drained(Buffer& buffer) {
    Sink sink{buffer.vertices, {}};
    buffer.drain(sink);
    return sink.out;
}

bool push(Buffer& buffer, Item item) { return buffer.push({&item, 1}) == 1; }

// A draw of base triangles with any number of fine ones, 0 included.
struct Work {
    std::vector<OrderToken> tokens;
    std::vector<uint32_t> counts;  // of a displaced one
    std::vector<Item> expected;
};

Work random_work(std::mt19937& random, uint32_t bases) {
    Work work;
    for (uint32_t base = 0; base < bases; ++base) {
        const bool is_direct = random() % 3 == 0;
        const uint32_t count = is_direct ? 1 : random() % 4 == 0 ? 0 : random() % 40;
        work.tokens.push_back(is_direct ? direct(base) : displaced(base));
        work.counts.push_back(count);
        for (uint32_t i = 0; i < count; ++i) work.expected.push_back({base, i});
    }
    return work;
}

// Plays controller, displacement unit and rasteriser, whichever a coin chooses, with FIFOs of any
// size; whoever is refused tries again later.
std::vector<Item> interleaved(const Work& work, std::mt19937& random, Buffer& buffer) {
    std::vector<Item> out;
    std::size_t next_token = 0;          // of the controller
    bool holds_direct = false;           // it offers the triangle of the token before
    std::vector<std::size_t> under_way;  // displaced base triangles that the unit has
    uint32_t next_fine = 0;              // of the first of them
    while (out.size() < work.expected.size() || next_token < work.tokens.size() ||
           !under_way.empty()) {
        const unsigned who = random() % 8;
        if (who < 3 && holds_direct) {
            holds_direct = !buffer.push_direct({work.tokens[next_token - 1].base, 0});
        } else if (who < 3 && next_token < work.tokens.size()) {
            const OrderToken& token = work.tokens[next_token];
            if (!buffer.expect(token)) continue;
            if (token.route == Route::Displaced) under_way.push_back(next_token);
            holds_direct = token.route == Route::Direct;
            ++next_token;
        } else if (who < 7 && !under_way.empty()) {
            const std::size_t i = under_way.front();
            const uint32_t base = work.tokens[i].base;
            if (next_fine < work.counts[i]) {
                const Item pair[] = {{base, next_fine}, {base, next_fine + 1}};
                const std::size_t n = next_fine + 1 < work.counts[i] ? 2 : 1;
                next_fine += static_cast<uint32_t>(buffer.push({pair, n}));
            } else if (buffer.finish()) {
                under_way.erase(under_way.begin());
                next_fine = 0;
            }
        } else if (who == 7) {
            for (const Item& item : drained(buffer)) out.push_back(item);
        }
    }
    return out;
}

RC_GTEST_PROP(TriangleBufferProperty, KeepsTheOrderOfBaseTriangles, (uint32_t seed)) {
    std::mt19937 random(seed);
    const Work work = random_work(random, 1 + random() % 60);
    Buffer buffer(1 + random() % 20, 1 + random() % 6, 3 + random() % 20);
    RC_ASSERT(interleaved(work, random, buffer) == work.expected);
    RC_ASSERT(buffer.idle());
    const TriangleBufferCounters& c = buffer.counters();
    RC_ASSERT(c.items == work.tokens.size());
    RC_ASSERT(c.triangles == work.expected.size());
}

// The functional counters do not know in which order things arrived.
TEST(TriangleBuffer, CountersOfTheDataAreEqualForAllInterleavings) {
    std::mt19937 random(7);
    const Work work = random_work(random, 200);
    TriangleBufferCounters first;
    for (int i = 0; i < 20; ++i) {
        Buffer buffer(2 + random() % 64, 2 + random() % 16, 3 + random() % 64);
        ASSERT_EQ(interleaved(work, random, buffer), work.expected);
        const TriangleBufferCounters& c = buffer.counters();
        if (i == 0) first = c;
        EXPECT_EQ(c.items, first.items);
        EXPECT_EQ(c.triangles, first.triangles);
        EXPECT_EQ(c.direct, first.direct);
        EXPECT_EQ(c.empty, first.empty);
        EXPECT_EQ(c.switches, first.switches);
    }
    EXPECT_GT(first.direct, 20U);
    EXPECT_GT(first.empty, 10U);
    EXPECT_GT(first.switches, 20U);
}

TEST(TriangleBuffer, OneSourceHoldsTheLockUntilItsBaseTriangleIsComplete) {
    Buffer buffer;
    ASSERT_TRUE(buffer.expect(displaced(0)));
    ASSERT_TRUE(buffer.expect(direct(1)));
    ASSERT_TRUE(buffer.expect(displaced(2)));
    EXPECT_TRUE(buffer.locked_by(Route::Displaced));
    EXPECT_TRUE(buffer.push_direct({1, 0}));  // waits
    EXPECT_TRUE(push(buffer, {0, 0}));
    EXPECT_TRUE(drained(buffer) == std::vector<Item>({{0, 0}}));
    EXPECT_TRUE(push(buffer, {0, 1}));
    EXPECT_TRUE(buffer.finish());
    EXPECT_TRUE(buffer.locked_by(Route::Displaced));  // the direct one passed at once
    EXPECT_TRUE(push(buffer, {2, 0}));
    EXPECT_TRUE(buffer.finish());
    EXPECT_TRUE(drained(buffer) == std::vector<Item>({{0, 1}, {1, 0}, {2, 0}}));
    EXPECT_EQ(buffer.counters().waits, 1U);
    EXPECT_EQ(buffer.counters().refused, 0U);
    EXPECT_EQ(buffer.counters().switches, 2U);
    EXPECT_EQ(buffer.counters().deepest, 3U);
    EXPECT_EQ(buffer.counters().deepest_direct, 1U);
}

TEST(TriangleBuffer, RefusesWithoutTheLock) {
    Buffer buffer;
    EXPECT_FALSE(push(buffer, {0, 0}));  // nobody holds it
    EXPECT_FALSE(buffer.finish());
    ASSERT_TRUE(buffer.expect(direct(0)));
    EXPECT_FALSE(push(buffer, {1, 0}));
    EXPECT_FALSE(buffer.finish());
    EXPECT_EQ(buffer.counters().refused, 4U);
    EXPECT_EQ(buffer.counters().triangles, 0U);
}

TEST(TriangleBuffer, FullFifosRefuseAndLoseNothing) {
    Buffer buffer(3, 2);
    ASSERT_TRUE(buffer.expect(displaced(0)));
    ASSERT_TRUE(buffer.expect(direct(1)));
    EXPECT_FALSE(buffer.can_expect());
    EXPECT_FALSE(buffer.expect(displaced(2)));
    const Item items[] = {{0, 0}, {0, 1}, {0, 2}, {0, 3}};
    EXPECT_EQ(buffer.push({items, 4}), 3U);
    EXPECT_TRUE(buffer.full());
    EXPECT_EQ(buffer.push({items + 3, 1}), 0U);
    EXPECT_TRUE(buffer.push_direct({1, 0}));
    EXPECT_TRUE(buffer.finish());  // the direct one is next, and has no room yet
    EXPECT_TRUE(buffer.locked_by(Route::Direct));
    EXPECT_FALSE(buffer.idle());
    EXPECT_TRUE(drained(buffer) == std::vector<Item>({{0, 0}, {0, 1}, {0, 2}, {1, 0}}));
    EXPECT_TRUE(buffer.idle());
    EXPECT_EQ(buffer.counters().deepest, 3U);
}

TEST(TriangleBuffer, AClippedBaseTriangleIsCompleteWithoutATriangle) {
    Buffer buffer;
    for (uint32_t base = 0; base < 3; ++base) ASSERT_TRUE(buffer.expect(displaced(base)));
    EXPECT_TRUE(buffer.finish());
    EXPECT_TRUE(push(buffer, {1, 0}));
    EXPECT_TRUE(buffer.finish());
    EXPECT_TRUE(buffer.finish());
    EXPECT_EQ(buffer.counters().empty, 2U);
    EXPECT_EQ(drained(buffer).size(), 1U);
}

TEST(TriangleBuffer, ClearDropsADrawAndResetIsPowerOn) {
    Buffer buffer;
    ASSERT_TRUE(buffer.expect(direct(0)));
    ASSERT_TRUE(buffer.expect(displaced(1)));
    ASSERT_TRUE(buffer.push_direct({0, 0}));
    buffer.clear();
    EXPECT_TRUE(buffer.idle());
    EXPECT_TRUE(drained(buffer).empty());
    EXPECT_EQ(buffer.counters().items, 2U);
    // The lock of the new draw starts with the displacement unit again.
    ASSERT_TRUE(buffer.expect(displaced(0)));
    EXPECT_EQ(buffer.counters().switches, 2U);
    buffer.reset();
    buffer.vertices.clear();
    EXPECT_EQ(buffer.counters().items, 0U);
    EXPECT_TRUE(buffer.idle());
}

}  // namespace
}  // namespace repousse
