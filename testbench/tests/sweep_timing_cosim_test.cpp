// Cycles per fine triangle of the sweep line, read off the RTL in its steady state: base triangles
// offered at once, beats taken at once.

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <stdexcept>
#include <vector>

#include "datapath/sweep_line_ports.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/tests/support/sweep_run.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

/// The RTL of one build. Timing does not depend on vertex data: one component is enough.
class Sweeper {
public:
    explicit Sweeper(int column_depth) : profile_(*shipped_profile("default")) {
        profile_.column_depth = column_depth;
        profile_.components = 1;
        model_ = make_unit_model("sweep_line", profile_);
        const auto path = build_engine(model_->desc(), profile_, source_folder());
        if (!path) throw std::runtime_error(path.error().message());
        auto engine = Engine::open(*path, model_->desc(), profile_);
        if (!engine) throw std::runtime_error(engine.error().message());
        instance_ = std::make_unique<EngineInstance>(*engine);
        instance_->configure({0}, nullptr, 1);
    }

    struct Figures {
        double cycles = 0, steps = 0, additions = 0;  // per fine triangle
        uint64_t triangles = 0;
    };

    /// `count` flat triangles with corners uniform in a square of `size`, as the counts of the
    /// datapath's test have them.
    Figures measure(int size, int count) {
        std::mt19937_64 random(5);
        TriangleSetup setup({AdderKind::Exact, 0, 1});
        SweepLine counter({profile_.column_depth, {}});
        Scenario scenario{"flat", {0}, nullptr, {}};
        uint64_t beats = 0;
        for (int n = 0; n < count; ++n) {
            test::GridTriangle t{};
            for (auto& p : t) {
                for (std::size_t axis = 0; axis < 2; ++axis)
                    p[axis] = int(random() % unsigned(size + 1));
            }
            SweepLineIn in;
            setup(test::corners_of(t), in.triangle);
            counter.run(in.triangle, [&](const SweepStep&) { ++beats; });
            const std::vector<Word> words = in.pack(profile_);
            scenario.inputs.insert(scenario.inputs.end(), words.begin(), words.end());
        }
        std::vector<int64_t> out(beats * model_->outputs());
        RepousseBatch batch = plain_batch(uint64_t(count), scenario.inputs.data(), out.data());
        uint64_t sent = 0;
        std::vector<uint64_t> depart(beats);
        batch.capacity = beats;
        batch.beats = &sent;
        batch.depart = depart.data();
        EXPECT_EQ(instance_->run(batch), kRepousseDone);
        EXPECT_EQ(sent, beats);
        const auto triangles = counter.counters().triangles;
        const auto each = [&](uint64_t n) { return double(n) / double(triangles); };
        return {each(depart.back() - depart.front() + 1), each(beats),
                each(counter.counters().additions), triangles};
    }

private:
    Profile profile_;
    std::unique_ptr<UnitModel> model_;
    std::unique_ptr<EngineInstance> instance_;
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
        const Sweeper::Figures f = sweeper.measure(row.size, row.count);
        std::printf("%4d  %.3f   %.3f   %.2f\n", row.size, f.steps, f.cycles, row.bound);
        EXPECT_LE(f.cycles, row.bound) << row.size;
        EXPECT_GE(f.cycles, f.steps) << row.size;
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
        const Sweeper::Figures f = sweeper.measure(row.size, row.count);
        std::printf("%4d    %.3f    %.3f   %.2f\n", row.size, f.additions, f.cycles, row.bound);
        EXPECT_LE(f.cycles, row.bound) << row.size;
        EXPECT_GE(f.cycles, f.additions) << row.size;
    }
}

}  // namespace
}  // namespace repousse::cosim
