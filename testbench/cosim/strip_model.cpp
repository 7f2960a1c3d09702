#include "datapath/units/strip.h"

#include <algorithm>

#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Slot = std::array<int32_t, 3>;

/// Steps for the unit, written down as a scenario; new vertices are numbered as they come.
class StepWriter {
public:
    StepWriter(std::vector<Scenario>& cases, uint32_t first_vertex)
        : cases_(cases), next_vertex_(first_vertex) {}

    /// Each scenario begins with a flush: it does not depend on the one before.
    void begin(const char* name) {
        cases_.push_back({name, {}, nullptr, {}});
        flush_ = true;
    }
    void flush() { flush_ = true; }

    void step(const StripStep& step) {
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
    void step(std::initializer_list<StripCommand> commands, bool init = false, bool flip = false) {
        StripStep s;
        s.init = init;
        s.flip = flip;
        for (const StripCommand& command : commands) s.commands[s.count++] = command;
        step(s);
    }

private:
    std::vector<Scenario>& cases_;
    uint32_t next_vertex_;
    bool flush_ = true;
};

constexpr StripCommand fresh(uint8_t place, StripKeep keep = StripKeep::No) {
    return {StripOp::New, place, keep};
}
constexpr StripCommand ref(uint8_t place) { return {StripOp::Ref, place, StripKeep::No}; }
constexpr StripCommand recall(StripOp op, uint8_t place, StripKeep keep = StripKeep::No) {
    return {op, place, keep};
}

class StripModel : public UnitModel {
public:
    explicit StripModel(const Profile& profile)
        : UnitModel(profile, kStripDesc),
          unit_(depth(profile)),
          sweep_({profile.column_depth, {}}) {}

    const UnitDesc& desc() const override { return kStripDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;

    /// The unit has a memory: there is no end of what could be tried.
    Scenario exhaustive(uint64_t) const override { return {}; }

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            const StripIn in = StripIn::unpack(&scenario.inputs[i]);
            if (in.flush) unit_.flush();
            const uint64_t bad_before = unit_.counters().bad_refs;
            StripOut out;
            unit_(in.step, {in.vertices.data(), in.vertices.size()}, out.made);
            out.bad_ref = unit_.counters().bad_refs != bad_before;
            for (const Word word : out.pack()) outputs.push_back(word);
        }
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_strip_model(profile);
    }

    /// FIFOs of three: full and empty all the time.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.column_depth = 3;
        return tiny;
    }

private:
    static std::size_t depth(const Profile& profile) {
        return static_cast<std::size_t>(profile.column_depth);
    }

    /// What the sweep line sends for a base triangle; at most `limit` steps of it.
    bool sweep(const std::array<Slot, 3>& slots, StepWriter& to,
               std::size_t limit = ~std::size_t{0}) const;
    void by_hand(StepWriter& to) const;
    void fill_fifo(StepWriter& to, StripOp op, StripKeep keep, uint8_t at_once) const;
    StripStep random_step(Random& random, bool orderly) const;

    Strip<uint32_t> unit_;
    mutable SweepLine sweep_;
};

bool StripModel::sweep(const std::array<Slot, 3>& slots, StepWriter& to, std::size_t limit) const {
    std::array<SweepCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].id = static_cast<uint32_t>(i);
        corners[i].slot = slots[i];
    }
    TriangleSetup setup;
    SweepTriangle triangle;
    setup(corners, triangle);
    sweep_.load(triangle);
    SweepStep step;
    for (std::size_t i = 0; i < limit; ++i) {
        if (!sweep_.step(step)) return true;
        to.step(step.strip);
    }
    sweep_.abort();
    return false;
}

void StripModel::fill_fifo(StepWriter& to, StripOp op, StripKeep keep, uint8_t at_once) const {
    // More than it holds, then more than it has; then at the brim, taking and keeping.
    const std::size_t most = depth(profile());
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

void StripModel::by_hand(StepWriter& to) const {
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

std::vector<Scenario> StripModel::hard_cases() const {
    std::vector<Scenario> cases;
    StepWriter to(cases, 1);
    by_hand(to);
    to.begin("column_fifo_full");
    fill_fifo(to, StripOp::Column, StripKeep::Column, 1);
    fill_fifo(to, StripOp::Column, StripKeep::Column, 4);
    to.begin("split_fifo_full");
    fill_fifo(to, StripOp::Split, StripKeep::Split, 3);
    to.begin("kept_in_the_same_step");
    to.step({fresh(0, StripKeep::Column), recall(StripOp::Column, 1), fresh(2, StripKeep::Split),
             recall(StripOp::Split, 3)},
            true);
    to.step({fresh(0, StripKeep::Column), fresh(1, StripKeep::Column),
             recall(StripOp::Column, 2, StripKeep::Split), recall(StripOp::Split, 0)});
    to.step({recall(StripOp::Column, 0, StripKeep::Column), recall(StripOp::Column, 1),
             recall(StripOp::Column, 2)});

    to.begin("single");
    sweep({{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}}}, to);
    to.begin("roof");
    sweep({{{0, 0, 0}, {13, 2, 1}, {5, 9, 0}}}, to);
    to.begin("increasing");
    sweep({{{0, 0, 0}, {12, 9, 0}, {7, 8, 2}}}, to);
    to.begin("decreasing");
    sweep({{{0, 0, 0}, {12, -9, 0}, {6, -1, 1}}}, to);
    to.begin("ears");  // repair R8
    sweep({{{3, 4, 2}, {0, 0, 6}, {1, 3, 2}}}, to);
    sweep({{{4, 7, 8}, {8, 8, 5}, {3, 3, 11}}}, to);
    sweep({{{13, 7, 6}, {6, 16, 15}, {12, 13, 15}}}, to);
    to.begin("sweep_dropped_in_the_middle");
    sweep({{{0, 0, 0}, {9, 8, 0}, {0, 12, 0}}}, to, 25);
    to.flush();
    sweep({{{0, 0, 0}, {9, 8, 0}, {0, 12, 0}}}, to);
    to.begin("columns_taller_than_the_fifo");
    const int32_t tall = 10 + std::min(profile().column_depth, kStripFifoDepth);
    sweep({{{0, 0, 0}, {0, tall, 0}, {3, tall / 2, 0}}}, to);
    sweep({{{0, 0, 0}, {tall, 0, 0}, {tall - 1, tall, 0}}}, to, 3 * std::size_t(tall) / 2);
    return cases;
}

StripStep StripModel::random_step(Random& random, bool orderly) const {
    StripStep s;
    s.init = random.percent(15);
    s.flip = random.percent(50);
    s.count = static_cast<uint8_t>(random.below(5));
    for (StripCommand& command : s.commands) {
        command.op = static_cast<StripOp>(random.below(4));
        if (orderly && random.percent(60)) command.op = StripOp::New;
        command.place = static_cast<uint8_t>(random.below(4));
        command.keep = static_cast<StripKeep>(random.below(4));
        if (orderly && random.percent(50)) command.keep = StripKeep::No;
    }
    return s;
}

Scenario StripModel::random(Random& random, std::size_t count) const {
    std::vector<Scenario> cases;
    StepWriter to(cases, static_cast<uint32_t>(random.next()));
    to.begin("random");
    const bool swept = random.percent(50);
    const bool orderly = random.percent(50);
    const auto written = [&] { return cases.back().inputs.size() / inputs(); };
    while (written() < count) {
        if (!swept) {
            if (random.percent(1)) to.flush();
            to.step(random_step(random, orderly));
            continue;
        }
        const uint32_t size = 2 + random.below(random.percent(20) ? 60 : 14);
        std::array<Slot, 3> slots;
        for (Slot& slot : slots) {
            for (int32_t& x : slot) x = static_cast<int32_t>(random.below(size));
        }
        const std::size_t left = count - written();
        const std::size_t limit = random.percent(5) ? random.below(20) : left;
        if (!sweep(slots, to, std::min(limit, left))) to.flush();
    }
    return cases.back();
}

}  // namespace

std::unique_ptr<UnitModel> make_strip_model(const Profile& profile) {
    return std::make_unique<StripModel>(profile);
}

}  // namespace repousse::cosim
