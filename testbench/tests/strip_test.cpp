// strip: registers, winding, swaps, the FIFOs, and what it says of a bad command.

#include "datapath/units/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace repousse {
namespace {

using Triangle = std::array<uint32_t, 3>;

StripCommand ref(uint8_t place) { return {StripOp::Ref, place, StripKeep::No}; }
StripCommand set(uint8_t place, StripKeep keep = StripKeep::No) {
    return {StripOp::New, place, keep};
}
StripCommand recall(StripOp op, uint8_t place) { return {op, place, StripKeep::No}; }

// A strip unit that numbers its new vertices 10, 11, ... in the order in which they arrive.
struct Fixture {
    Strip<uint32_t> unit{4};
    uint32_t next = 10;
    std::vector<Triangle> made;

    void step(const std::vector<StripCommand>& commands, bool init = false, bool flip = false) {
        StripStep step;
        step.init = init;
        step.flip = flip;
        std::vector<uint32_t> vertices;
        for (const StripCommand& command : commands) {
            step.commands[step.count++] = command;
            if (command.op == StripOp::New) vertices.push_back(next++);
        }
        StripTriangles<uint32_t> out;
        unit(step, vertices, out);
        made.assign(out.triangles.begin(), out.triangles.begin() + out.count);
    }
};

// init, two setrefs, two more: the first quad of a column in one step.
TEST(Strip, AWholeStepMakesAQuad) {
    Fixture f;
    f.step({set(0), set(2), set(0), set(1)}, true);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{10, 11, 12}, {11, 13, 12}}));
    f.step({set(0), set(1)});
    EXPECT_EQ(f.made, (std::vector<Triangle>{{12, 13, 14}, {13, 15, 14}}));
    EXPECT_EQ(f.unit.counters().commands, 7u);
    EXPECT_EQ(f.unit.counters().strips, 1u);
    EXPECT_EQ(f.unit.counters().vertices, 6u);
}

TEST(Strip, TheWindingFlagSwapsTheLastTwoVertices) {
    Fixture f;
    f.step({set(0), set(2), set(0), set(1)}, true, true);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{10, 12, 11}, {11, 12, 13}}));
}

// Two steps on the left: the right vertex comes once more between them, and the second triangle has
// the right vertex and the winding of the first.
TEST(Strip, ASwapTurnsTheStripAndMakesNoTriangle) {
    Fixture f;
    f.step({set(0), set(2), set(0)}, true);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{10, 11, 12}}));
    f.step({ref(2), set(0)});
    EXPECT_EQ(f.made, (std::vector<Triangle>{{12, 11, 13}}));
    EXPECT_EQ(f.unit.counters().swaps, 1u);
}

TEST(Strip, RegistersOutliveTheirStrip) {
    Fixture f;
    f.step({set(0), set(2), set(0), set(3)}, true);
    f.step({ref(2), set(1), ref(3)}, true);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{11, 14, 13}}));
}

TEST(Strip, FifosReturnWhatWasKeptInOrder) {
    Fixture f;
    for (int round = 0; round < 5; ++round) {
        f.unit.reset();
        f.next = 10;
        f.step({set(0), set(1, StripKeep::Column), set(2, StripKeep::Split),
                set(1, StripKeep::Column)},
               true);
        f.step({recall(StripOp::Column, 0), recall(StripOp::Column, 1), recall(StripOp::Split, 2)},
               true);
        EXPECT_EQ(f.made, (std::vector<Triangle>{{11, 13, 12}}));
        EXPECT_EQ(f.unit.counters().deepest, 2u);
        EXPECT_FALSE(f.unit.bad_ref());
    }
}

TEST(Strip, ABadReferenceIsReportedAndMakesNothing) {
    Fixture f;
    f.step({ref(1)}, true);
    EXPECT_TRUE(f.unit.bad_ref());
    f.unit.reset();
    f.step({recall(StripOp::Column, 0)}, true);
    EXPECT_EQ(f.unit.counters().bad_refs, 1u);
    f.unit.reset();
    for (int i = 0; i < 5; ++i) f.step({set(0, StripKeep::Split)});
    EXPECT_EQ(f.unit.counters().bad_refs, 1u) << "the FIFO holds four";
}

TEST(Strip, AStepMakesTwoTrianglesAtMost) {
    Fixture f;
    f.step({set(0), set(1)}, true);
    f.step({set(2), set(3), set(0), set(1)});
    EXPECT_EQ(f.made, (std::vector<Triangle>{{10, 11, 12}, {11, 13, 12}}));
    EXPECT_EQ(f.unit.counters().bad_refs, 2u);
    f.step({set(2)});
    EXPECT_EQ(f.made, (std::vector<Triangle>{{14, 15, 16}})) << "the strip goes on";
}

TEST(Strip, WithoutFifosNothingIsKept) {
    Strip<uint32_t> unit(0);
    StripTriangles<uint32_t> out;
    const uint32_t vertex = 7;
    StripStep step;
    step.count = 2;
    step.commands[0] = set(0, StripKeep::Column);
    step.commands[1] = recall(StripOp::Column, 1);
    unit(step, {&vertex, 1}, out);
    EXPECT_EQ(unit.counters().bad_refs, 2u);
    EXPECT_EQ(unit.counters().vertices, 1u);
}

// The FIFO holds four: one more is not kept, but it is in its register and in the strip.
TEST(Strip, AFullFifoLosesOnlyWhatIsKept) {
    Fixture f;
    for (int i = 0; i < 5; ++i) f.step({set(uint8_t(i % 2), StripKeep::Column)}, i == 0);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{12, 13, 14}}));
    EXPECT_EQ(f.unit.counters().bad_refs, 1u);
    for (uint32_t i = 0; i < 4; ++i) f.step({recall(StripOp::Column, uint8_t(i % 2))}, i == 0);
    EXPECT_EQ(f.made, (std::vector<Triangle>{{11, 13, 12}}));
    EXPECT_EQ(f.unit.counters().deepest, 4u);
}

TEST(Strip, FlushForgetsEverything) {
    Fixture f;
    f.step({set(0, StripKeep::Column), set(1)}, true);
    f.unit.flush();
    f.step({set(2)});
    EXPECT_TRUE(f.made.empty()) << "the strip before the flush is over";
    f.step({ref(0)});
    EXPECT_EQ(f.unit.counters().bad_refs, 1u);
    f.step({recall(StripOp::Column, 0)});
    EXPECT_EQ(f.unit.counters().bad_refs, 2u);
    EXPECT_EQ(f.unit.counters().vertices, 3u) << "counters stay until reset";
}

}  // namespace
}  // namespace repousse
