#include "testbench/cosim/strip_cases.h"

#include <algorithm>

#include "datapath/units/triangle_setup.h"

namespace repousse::cosim {

StripSteps::StripSteps(const Profile& profile, std::vector<Scenario>& cases, uint32_t first_vertex)
    : cases_(cases), sweep_({profile.column_depth, {}}), next_vertex_(first_vertex) {}

void StripSteps::step(const StripStep& step) {
    StripIn in;
    in.flush = flush_;
    in.step = step;
    std::size_t news = 0;
    for (std::size_t i = 0; i < step.count; ++i) {
        if (step.commands[i].op == StripOp::New) in.vertices[news++] = next_vertex_++;
    }
    cases_.back().add(in);
    flush_ = false;
}

void StripSteps::step(std::initializer_list<StripCommand> commands, bool init, bool flip) {
    StripStep s;
    s.init = init;
    s.flip = flip;
    for (const StripCommand& command : commands) s.commands[s.count++] = command;
    step(s);
}

bool StripSteps::sweep(const GridCorners& grid, std::size_t limit) {
    std::array<SweepCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].id = static_cast<uint32_t>(i);
        corners[i].slot = grid[i];
    }
    TriangleSetup setup;
    SweepTriangle triangle;
    setup(corners, triangle);
    sweep_.load(triangle);
    SweepStep step;
    for (std::size_t i = 0; i < limit; ++i) {
        if (!sweep_.step(step)) return true;
        this->step(step.strip);
    }
    sweep_.abort();
    return false;
}

namespace {

constexpr StripCommand fresh(uint8_t place, StripKeep keep = StripKeep::No) {
    return {StripOp::New, place, keep};
}
constexpr StripCommand ref(uint8_t place) { return {StripOp::Ref, place, StripKeep::No}; }
constexpr StripCommand recall(StripOp op, uint8_t place, StripKeep keep = StripKeep::No) {
    return {op, place, keep};
}

void fill_fifo(const Profile& profile, StripSteps& to, StripOp op, StripKeep keep,
               uint8_t at_once) {
    // More than it holds, then more than it has; then at the brim, taking and keeping.
    const std::size_t most = static_cast<std::size_t>(profile.column_depth);
    const auto steps = [&](const StripCommand& command) {
        for (std::size_t i = 0; i <= most; i += at_once) {
            StripStep step;
            step.init = at_once > 2;
            step.count = at_once;
            for (uint8_t k = 0; k < at_once; ++k) {
                step.commands[k] = command;
                step.commands[k].place = static_cast<uint8_t>((i + k) % 4);
            }
            to.step(step);
        }
    };
    to.step({fresh(0), fresh(1)}, true);
    steps(fresh(0, keep));
    steps(recall(op, 0));
    if (at_once == 1) return;
    steps(fresh(0, keep));
    for (int i = 0; i < 8; ++i) to.step({recall(op, 0), fresh(1, keep), fresh(2, keep)}, true);
    for (int i = 0; i < 8; ++i) to.step({recall(op, 0, keep), recall(op, 1)}, true);
}

void by_hand(StripSteps& to) {
    to.begin("quads");
    to.step({fresh(0), fresh(2), fresh(0), fresh(1)}, true);
    for (int i = 0; i < 3; ++i) to.step({fresh(0), fresh(1)});
    to.begin("winding");
    to.step({fresh(0), fresh(2), fresh(0), fresh(1)}, true, true);
    to.step({fresh(0), fresh(1)});
    to.step({fresh(0), fresh(2), fresh(0)}, true, false);
    to.step({fresh(1)});

    to.begin("two_steps_on_the_left");  // a swap between them
    to.step({fresh(0), fresh(2), fresh(0)}, true);
    to.step({ref(2), fresh(0)});
    to.step({ref(2), fresh(0), fresh(1)});
    to.begin("two_steps_on_the_right");
    to.step({fresh(2), fresh(0), fresh(2)}, true, true);
    to.step({ref(0), fresh(2)});
    to.step({ref(0), fresh(2)});
    to.begin("two_swaps_in_a_step");
    to.step({fresh(0), fresh(1), ref(0), ref(1)}, true);
    to.step({ref(0), ref(1), fresh(2), fresh(3)});

    to.begin("ears_by_hand");  // e0 bl e1, bl e2, bl br
    to.step({fresh(2), fresh(1)}, true);
    to.step({fresh(3), ref(2), fresh(0)}, true);
    to.step({ref(2), fresh(3)});
    to.step({ref(2), ref(1)});

    to.begin("registers_outlive_their_strip");
    to.step({fresh(0), fresh(2), fresh(0), fresh(3)}, true);
    to.step({ref(2), fresh(1), ref(3)}, true);
    to.begin("a_register_set_twice_in_a_step");
    to.step({fresh(1), fresh(1), ref(1), fresh(1)}, true);
    to.step({ref(1), fresh(0), ref(0), ref(1)});

    to.begin("flush_in_the_middle");
    to.step({fresh(0), fresh(1, StripKeep::Column), fresh(2, StripKeep::Split)}, true);
    to.step({fresh(0, StripKeep::Column), fresh(1)});
    to.flush();
    to.step({fresh(3)});  // the strip before it is over: no triangle for two vertices
    to.step({fresh(1)});
    to.step({fresh(2)});
    to.step({ref(0), recall(StripOp::Column, 0), recall(StripOp::Split, 0)});  // all bad
    to.step({fresh(0, StripKeep::Column)});
    to.flush();  // and a step in the same cycle that uses what it keeps itself
    to.step({fresh(0, StripKeep::Column), recall(StripOp::Column, 1), fresh(2), ref(0)}, true);

    to.begin("bad_ref");
    to.step({ref(1)}, true);
    to.step({fresh(0), ref(3), fresh(1), fresh(2)});
    to.step({recall(StripOp::Column, 0), recall(StripOp::Split, 3), ref(3)});
    to.begin("third_triangle");
    to.step({fresh(0), fresh(1)}, true);
    to.step({fresh(2), fresh(3), fresh(0), fresh(1)});
    to.step({ref(2), fresh(3)});
    to.begin("nothing_to_do");
    to.step({}, true, true);
    to.step({fresh(0), fresh(1)});
    to.step({});
    to.step({fresh(2)});
}

}  // namespace

std::vector<Scenario> strip_cases(const Profile& profile) {
    std::vector<Scenario> cases;
    StripSteps to(profile, cases, 1);
    by_hand(to);
    to.begin("column_fifo_full");
    fill_fifo(profile, to, StripOp::Column, StripKeep::Column, 1);
    fill_fifo(profile, to, StripOp::Column, StripKeep::Column, 4);
    to.begin("split_fifo_full");
    fill_fifo(profile, to, StripOp::Split, StripKeep::Split, 3);
    to.begin("kept_in_the_same_step");
    to.step({fresh(0, StripKeep::Column), recall(StripOp::Column, 1), fresh(2, StripKeep::Split),
             recall(StripOp::Split, 3)},
            true);
    to.step({fresh(0, StripKeep::Column), fresh(1, StripKeep::Column),
             recall(StripOp::Column, 2, StripKeep::Split), recall(StripOp::Split, 0)});
    to.step({recall(StripOp::Column, 0, StripKeep::Column), recall(StripOp::Column, 1),
             recall(StripOp::Column, 2)});

    to.begin("single");
    to.sweep({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}});
    to.begin("roof");
    to.sweep({{{0, 0, 0}, {13, 2, 1}, {5, 9, 0}}});
    to.begin("increasing");
    to.sweep({{{0, 0, 0}, {12, 9, 0}, {7, 8, 2}}});
    to.begin("decreasing");
    to.sweep({{{0, 0, 0}, {12, -9, 0}, {6, -1, 1}}});
    to.begin("ears");  // repair R8
    to.sweep({{{3, 4, 2}, {0, 0, 6}, {1, 3, 2}}});
    to.sweep({{{4, 7, 8}, {8, 8, 5}, {3, 3, 11}}});
    to.sweep({{{13, 7, 6}, {6, 16, 15}, {12, 13, 15}}});
    to.begin("sweep_dropped_in_the_middle");
    to.sweep({{{0, 0, 0}, {9, 8, 0}, {0, 12, 0}}}, 25);
    to.flush();
    to.sweep({{{0, 0, 0}, {9, 8, 0}, {0, 12, 0}}});
    to.begin("columns_taller_than_the_fifo");
    const int32_t tall = 10 + std::min(profile.column_depth, kStripFifoDepth);
    to.sweep({{{0, 0, 0}, {0, tall, 0}, {3, tall / 2, 0}}});
    to.sweep({{{0, 0, 0}, {tall, 0, 0}, {tall - 1, tall, 0}}}, 3 * std::size_t(tall) / 2);
    return cases;
}

}  // namespace repousse::cosim
