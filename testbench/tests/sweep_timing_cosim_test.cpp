// Cycles per fine triangle of the sweep line, read off the RTL in its steady state: base triangles
// offered at once, beats taken at once.

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/sweep_pace.h"

namespace repousse::cosim {
namespace {

/// The RTL of one build. Timing does not depend on vertex data: one component is enough.
class Sweeper {
public:
    explicit Sweeper(int column_depth)
        : model_(model_with(column_depth)), unit_(engine_of(*model_)) {
        unit_.configure({0}, nullptr, 1);
    }

    FlatRun run(int size, int count) { return run_flat(unit_, *model_, size, count); }

private:
    static std::unique_ptr<UnitModel> model_with(int column_depth) {
        Profile profile = *shipped_profile("default");
        profile.column_depth = column_depth;
        profile.components = 1;
        return make_unit_model("sweep_line", profile);
    }

    std::unique_ptr<UnitModel> model_;
    EngineInstance unit_;
};

struct Row {
    int size, count;
    double bound;  // cycles per fine triangle; 9: none
};

TEST(SweepTiming, TwoLanes) {
    Sweeper sweeper(256);
    std::printf("two lanes, cycles per fine triangle\n  px  steps  cycles  bound\n");
    for (const Row& row : {Row{8, 20000, 0.70},
                           {16, 10000, 0.62},
                           {32, 5000, 9},
                           {64, 2000, 0.56},
                           {128, 600, 9},
                           {256, 200, 0.52}}) {
        const FlatRun run = sweeper.run(row.size, row.count);
        std::printf("%4d  %.3f   %.3f   %.2f\n", row.size, run.beats(), run.cycles(), row.bound);
        EXPECT_LE(run.cycles(), row.bound) << row.size;
        EXPECT_GE(run.cycles(), run.beats()) << row.size;
    }
}

// One addition a cycle.
TEST(SweepTiming, OneLane) {
    Sweeper sweeper(0);
    std::printf("one lane, cycles per fine triangle\n  px  additions  cycles  bound\n");
    for (const Row& row : {Row{8, 5000, 9},
                           {16, 3000, 9},
                           {32, 1500, 9},
                           {64, 700, 1.15},
                           {128, 250, 9},
                           {256, 80, 9}}) {
        const FlatRun run = sweeper.run(row.size, row.count);
        const double additions = run.each(run.counters.additions);
        std::printf("%4d    %.3f    %.3f   %.2f\n", row.size, additions, run.cycles(), row.bound);
        EXPECT_LE(run.cycles(), row.bound) << row.size;
        EXPECT_GE(run.cycles(), additions) << row.size;
    }
}

}  // namespace
}  // namespace repousse::cosim
