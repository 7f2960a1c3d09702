// triangle_stack: order, bound and counters against a deque.

#include "datapath/units/triangle_stack.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>

#include "datapath/numbers/policy.h"

namespace repousse {
namespace {

using Stack = TriangleStack<Fixed>;

Child<Fixed> numbered(uint32_t n) {
    static const Vertex<Fixed> vertex;
    Child<Fixed> child;
    child.corners = {&vertex, &vertex, &vertex};
    child.path.base = n;
    return child;
}

uint32_t pop_number(Stack& stack) {
    Triangle<Fixed> triangle;
    stack.pop(triangle);
    return triangle.path.base;
}

// Any sequence of pushes (even numbers) and pops (odd numbers): the same order as a deque.
RC_GTEST_PROP(TriangleStackProperty, IsADeque, (const std::vector<uint8_t>& steps, bool fifo)) {
    Stack stack(fifo ? StackOrder::Fifo : StackOrder::Lifo, 15);
    std::deque<uint32_t> model;
    std::size_t peak = 0;
    for (uint32_t i = 0; i < steps.size(); ++i) {
        if (steps[i] % 2 == 0 && model.size() < stack.capacity()) {
            RC_ASSERT(stack.push(numbered(i)));
            model.push_back(i);
        } else if (!model.empty()) {
            const uint32_t expected = fifo ? model.front() : model.back();
            RC_ASSERT(pop_number(stack) == expected);
            if (fifo) model.pop_front();
            if (!fifo) model.pop_back();
        }
        peak = std::max(peak, model.size());
        RC_ASSERT(stack.size() == model.size());
        RC_ASSERT(stack.empty() == model.empty());
        RC_ASSERT(stack.peak() == peak);
    }
}

TEST(TriangleStack, DepthFirstHoldsNineACapAndOne) {
    for (const int cap : {0, 1, 7, 15}) {
        Stack stack(StackOrder::Lifo, cap);
        const auto places = std::size_t(9 * cap + 1);
        EXPECT_EQ(stack.capacity(), places);
        for (std::size_t i = 0; i < places; ++i) EXPECT_TRUE(stack.push(numbered(uint32_t(i))));
        EXPECT_FALSE(stack.push(numbered(99)));
        EXPECT_FALSE(stack.push(numbered(99)));  // refused, not overwritten
        EXPECT_EQ(stack.size(), places);
        EXPECT_EQ(stack.peak(), places);
        for (std::size_t i = places; i-- > 0;) EXPECT_EQ(pop_number(stack), i);
        EXPECT_TRUE(stack.empty());
        EXPECT_TRUE(stack.push(numbered(1)));
    }
}

TEST(TriangleStack, BreadthFirstGrowsAsNeededAndKeepsOrder) {
    Stack stack(StackOrder::Fifo, 0);
    uint32_t next = 0, expected = 0;
    for (int round = 0; round < 200; ++round) {
        for (int i = 0; i < 50; ++i) ASSERT_TRUE(stack.push(numbered(next++)));
        for (int i = 0; i < 35; ++i) ASSERT_EQ(pop_number(stack), expected++);
    }
    EXPECT_EQ(stack.size(), 200u * 15);
    EXPECT_EQ(stack.peak(), 200u * 15 + 35);
    while (!stack.empty()) ASSERT_EQ(pop_number(stack), expected++);
    EXPECT_EQ(expected, next);
}

TEST(TriangleStack, KeepsACopyOfWhatTheChildRefersTo) {
    std::array<Vertex<Fixed>, 3> corners;
    corners[1].uv = {-11, 12};
    corners[2].generation = 9;
    Child<Fixed> child;
    child.corners = {&corners[0], &corners[1], &corners[2]};
    child.path = Path{7, 0, {}}.child(2).child(3);
    child.unsplit_edges = 5;
    Stack stack(StackOrder::Lifo, 1);
    ASSERT_TRUE(stack.push(child));
    corners = {};  // the parent's batch is over
    Triangle<Fixed> back;
    stack.pop(back);
    EXPECT_EQ(back.path.base, 7u);
    EXPECT_EQ(back.path.depth, 2);
    EXPECT_EQ(back.path.digits, child.path.digits);
    EXPECT_EQ(back.unsplit_edges, 5);
    EXPECT_EQ(back.corners[1].uv, (Uv{-11, 12}));
    EXPECT_EQ(back.corners[2].generation, 9);
}

}  // namespace
}  // namespace repousse
