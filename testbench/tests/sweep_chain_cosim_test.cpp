// The Verilog top of sweep line, perspective and strip against the datapaths of the three, and its
// pace: hard cases and random base triangles, every bit of every vertex of every fine triangle.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "testbench/cosim/vector_file.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/sweep_pace.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<UnitModel> chain() { return model_of("sweep_chain"); }

TEST(SweepChainRtl, HardCasesAndRandomOnesInVerilator) {
    const auto model = chain();
    const Outcome outcome = run_verilator(*model, 4'000);
    EXPECT_GE(outcome.cases, 4'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, WithAColumnFifoOfThreeAndWithoutTangents) {
    const auto model = chain();
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_verilator(*tiny, 4'000);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, NarrowProfile) {
    const auto model = model_of("sweep_chain", "narrow");
    const Outcome outcome = run_verilator(*model, 3'000);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, HardCasesAndRandomOnesInIcarus) {
    const auto model = chain();
    const auto outcome = run_icarus(*model, source_folder(), model->hard_cases(), 8, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, 30U);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, CommittedVectorsAreTheHardCases) {
    const auto model = chain();
    const fs::path path = source_folder() / "vectors/sweep_chain/hard.vec";
    const auto recorded = read_vectors(path, *model);
    ASSERT_TRUE(recorded.ok()) << recorded.error().message();
    std::vector<int64_t> inputs, expected;
    for (const Recorded& r : *recorded) {
        std::vector<int64_t> outputs;
        model->evaluate(r.scenario, outputs);
        EXPECT_EQ(outputs, r.outputs) << path << ':' << r.first_line;
        inputs.insert(inputs.end(), r.scenario.inputs.begin(), r.scenario.inputs.end());
    }
    for (const Scenario& s : model->hard_cases()) {
        expected.insert(expected.end(), s.inputs.begin(), s.inputs.end());
    }
    EXPECT_EQ(inputs, expected) << "run: repousse vectors generate";
    EXPECT_LE(fs::file_size(path) + fs::file_size(beats_path(path)), 200'000U);
}

EngineInstance instance_of(const UnitModel& model) {
    EngineInstance unit(engine_of(model));
    unit.configure({0, 1}, nullptr, 1);
    return unit;
}

TEST(SweepChainRtl, CyclesPerFineTriangle) {
    const auto model = chain();
    EngineInstance unit = instance_of(*model);
    struct Row {
        int size, count;
        double bound;  // 9: none
    };
    std::printf("per fine triangle:\n  px  steps  vertices  cycles  bound\n");
    for (const Row& row : {Row{8, 2000, 9},
                           {16, 800, 9},
                           {32, 300, 9},
                           {64, 150, 0.60},
                           {128, 40, 9},
                           {256, 12, 9}}) {
        const FlatRun run = run_flat(unit, *model, row.size, row.count);
        const double vertices = run.each(run.counters.displaced);
        std::printf("%4d  %.3f     %.3f   %.3f   %.2f\n", row.size, run.beats(), vertices,
                    run.cycles(), row.bound);
        EXPECT_LE(run.cycles(), row.bound) << row.size;
        EXPECT_GE(run.cycles(), vertices - 0.01) << "one vertex a cycle goes through perspective";
    }
}

TEST(SweepChainRtl, Latency) {
    const auto model = chain();
    EngineInstance unit = instance_of(*model);
    for (int i = 0; i < 2; ++i) {
        const Passage passage = run_flat(unit, *model, 16, 1).passage;
        EXPECT_EQ(passage.depart.front() - passage.accept.front(), uint64_t(model->desc().latency));
    }
}

TEST(SweepChainRtl, WrongOnesAreFound) {
    const auto model = chain();
    const auto tiny = model->with(model->tiny_profile());
    for (const Mutation& m :
         {Mutation{"overfills the queue of vertices", "sweep_chain", "common/rp_scatter.sv",
                   "CW'(D - N)", "CW'(D - N + 2)"},
          Mutation{"does not wait for the last vertex", "sweep_chain", "common/rp_gather.sv",
                   "count >= CW'(out_n)", "count + 1'b1 >= CW'(out_n)"},
          Mutation{"keeps what a dropped triangle left", "sweep_chain", "tops/sweep_chain.sv",
                   "ends & (count == 3'd0)", "1'b0"}}) {
        const Mutant mutant(m);
        const Outcome outcome = run_verilator(*tiny, 3'000, mutant.root());
        EXPECT_GT(outcome.mismatches, 0U) << m.name;
    }
}

}  // namespace
}  // namespace repousse::cosim
