// The Verilog top of figure 8 against the tests as the adaptive pipeline composes them: hard cases,
// random edges, every edge of a tiny profile, the edges of real scenes with the decisions taken
// there, its pace, and tops that are wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "datapath/pipelines/tessellation_tests.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/tested_edges.h"
#include "testbench/host/draw.h"
#include "testbench/host/scene/assets.h"
#include "testbench/tests/support/mutant.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

std::unique_ptr<UnitModel> top_of(const char* profile = "default") {
    return model_of("tessellation_tests", profile);
}

TEST(TessellationTestsRtl, HardCasesAndRandomOnesInVerilator) {
    for (const char* profile : {"default", "narrow"}) {
        const auto model = top_of(profile);
        const Outcome outcome = run_verilator(*model, 200'000);
        EXPECT_GE(outcome.cases, 200'000U);
        EXPECT_EQ(outcome.mismatches, 0U) << profile << ": " << outcome.first_mismatch;
    }
}

TEST(TessellationTestsRtl, EveryEdgeOfATinyProfile) {
    const auto model = top_of();
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome = run_exhaustive(*tiny, engine_of(*tiny), effort(0), {});
    EXPECT_EQ(outcome.cases, uint64_t{1} << (7 + 17));
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
}

TEST(TessellationTestsRtl, HardCasesAndRandomOnesInIcarus) {
    const auto model = top_of();
    expect_equal_in_icarus(*model, 1'000);
}

/// Half of the random transactions and more must reach the last test, or it is hardly tried.
TEST(TessellationTestsRtl, RandomEdgesUseEveryTest) {
    const auto model = top_of();
    Random random(4);
    uint64_t edges = 0, split = 0, ct = 0, vt = 0, nt = 0, sht = 0;
    for (int i = 0; i < 40; ++i) {
        const Scenario s = model->random(random, 1000);
        std::vector<int64_t> out;
        model->evaluate(s, out);
        for (std::size_t at = 0; at < out.size(); at += model->outputs()) {
            ++edges;
            split += out[at] != 0, ct += out[at + 1] == 0, vt += out[at + 2] == 0;
            nt += out[at + 3] != 0, sht += out[at + 4] != 0;
        }
    }
    EXPECT_GT(split, edges / 5);
    EXPECT_LT(split, edges * 4 / 5);
    for (const uint64_t decided : {ct, vt, nt, sht}) EXPECT_GT(decided, edges / 20);
}

/// An adaptive object of a shipped scene, without the files' fallbacks being any matter.
class SceneDraw {
public:
    SceneDraw(const Profile& profile, const std::string& name) : profile_(profile) {
        scene_ = *host::read_scene("scenes/" + name + ".toml");
        mesh_ = *host::load_mesh(scene_.objects[0]);
        map_ = *host::load_map(scene_.objects[0], {});
    }

    AdaptiveDraw<Fixed> draw(bool eager, double thresholds) const {
        host::DrawInputs inputs = host::draw_inputs(scene_, scene_.objects[0], mesh_, map_);
        inputs.settings.eager = eager;
        if (inputs.settings.height_threshold) *inputs.settings.height_threshold *= thresholds;
        return *host::make_draw<Fixed>(profile_, inputs);
    }

private:
    Profile profile_;
    host::Scene scene_;
    host::Mesh mesh_;
    host::HeightMap map_;
};

TEST(TessellationTestsRtl, DecidesAsTheRunsOfRealScenesDid) {
    const auto model = top_of();
    const Engine engine = engine_of(*model);
    uint64_t edges = 0;
    for (const char* name : {"jacksboro_small", "donut_small", "head_small"}) {
        const SceneDraw scene(model->profile(), name);
        TestedEdges tested(model->profile());
        for (const bool eager : {false, true}) {
            for (const double thresholds : {0.25, 1.0}) {
                const auto draw = scene.draw(eager, thresholds);
                const auto recording = [&](const auto& take) { tested.run(draw, take); };
                const Outcome outcome =
                    run_recorded(*model, engine, name, recording, effort(0), {});
                EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch;
                edges += outcome.cases;
            }
        }
        std::printf("%s: %llu edges, %llu of them distinct\n", name,
                    static_cast<unsigned long long>(tested.edges()),
                    static_cast<unsigned long long>(tested.distinct()));
    }
    EXPECT_GE(edges, 100'000U);
}

/// The judge of random edges is that of the runs: one edge at a time as in batches.
TEST(TessellationTestsRtl, TheModelDecidesAsTheRunsDid) {
    const auto model = top_of();
    const SceneDraw scene(model->profile(), "head_small");
    TestedEdges tested(model->profile());
    std::vector<int64_t> outputs;
    std::size_t portions = 0;
    for (const bool eager : {false, true}) {
        tested.run(scene.draw(eager, 1.0), [&](const Recorded& recorded) {
            model->evaluate(recorded.scenario, outputs);
            EXPECT_EQ(outputs, recorded.outputs);
            ++portions;
        });
    }
    EXPECT_GE(portions, 4U);
}

/// Edges of one kind, offered at once and taken from cycle `ready` on.
class Pace {
public:
    Pace() : model_(top_of()), unit_(engine_of(*model_)) {
        table_ = prefix_sums(16, 16, 38, [](int x, int y) { return uint64_t(x * y); });
        registers_.use_view_test = registers_.use_normal_test = registers_.use_height_test = true;
        registers_.height_test.width = registers_.height_test.height = 16;
        registers_.height_test.threshold = 100;
        // Long in texels and on the screen, and flat: every test works on it.
        in_.u1 = {0, 0}, in_.u2 = {1024, 512}, in_.u12 = {512, 256};
        in_.p2.x = 100;
    }

    AdaptiveRegisters<Fixed>& registers() { return registers_; }
    TessellationTestsIn& in() { return in_; }
    const UnitDesc& desc() const { return model_->desc(); }

    void run(std::size_t count, uint64_t ready = 0) {
        const auto config = pack_registers(registers_);
        unit_.configure({config.begin(), config.end()}, table_.get(), 1);
        Scenario s;
        for (std::size_t i = 0; i < count; ++i) s.add(in_);
        Passage passage = pass(unit_, *model_, s.inputs, {}, std::vector<uint64_t>(count, ready));
        accept = std::move(passage.accept);
        depart = std::move(passage.depart);
    }

    uint64_t latency() {
        run(1);
        return depart[0] - accept[0];
    }
    uint64_t interval() {
        run(100);
        return (depart[90] - depart[50]) / 40;
    }
    /// Edges that get in while none may leave.
    std::size_t capacity() {
        run(60, 1000);
        return static_cast<std::size_t>(
            std::count_if(accept.begin(), accept.end(), [](uint64_t t) { return t < 1000; }));
    }

    std::vector<uint64_t> accept, depart;

private:
    std::unique_ptr<UnitModel> model_;
    EngineInstance unit_;
    std::shared_ptr<const Table> table_;
    AdaptiveRegisters<Fixed> registers_;
    TessellationTestsIn in_;
};

TEST(TessellationTestsRtl, LatencyIntervalAndCapacity) {
    Pace pace;
    const UnitDesc& desc = pace.desc();
    EXPECT_EQ(pace.latency(), uint64_t(desc.latency));
    EXPECT_EQ(pace.interval(), uint64_t(desc.interval));
    EXPECT_EQ(pace.capacity(), std::size_t(desc.capacity));
    EXPECT_GE(pace.accept[std::size_t(desc.capacity)], 1000U + unsigned(desc.backward_latency));

    // Whatever decides it, an edge that reads nothing takes one cycle.
    const TessellationTestsIn whole = pace.in();
    for (int skipped = 0; skipped < 5; ++skipped) {
        pace.in() = whole;
        if (skipped == 0) pace.in().eligible = false;
        if (skipped == 1) pace.in().u2 = pace.in().u12 = {0, 0};
        if (skipped == 2) pace.in().p2.x = 0;
        if (skipped == 3) pace.in().vertices[2].normal.x = 1;
        if (skipped == 3) pace.in().vertices[2].displaced_normal.x = 1;
        if (skipped == 4) pace.registers().use_height_test = false;
        EXPECT_EQ(pace.latency(), 14U) << skipped;
        EXPECT_EQ(pace.interval(), 1U) << skipped;
        EXPECT_EQ(pace.capacity(), 21U) << skipped;
        if (skipped == 4) continue;
        pace.registers().eager = true;
        EXPECT_EQ(pace.latency(), uint64_t(desc.latency)) << skipped;
        EXPECT_EQ(pace.interval(), uint64_t(desc.interval)) << skipped;
        pace.registers().eager = false;
    }
}

/// What skipping saves: cycles an edge over whole runs, nothing stalled.
TEST(TessellationTestsRtl, CyclesPerEdgeOfRealScenes) {
    const auto model = top_of();
    EngineInstance unit(engine_of(*model));
    std::printf("cycles per edge:\n");
    for (const char* name : {"jacksboro_small", "donut_small", "head_small"}) {
        const SceneDraw scene(model->profile(), name);
        double each[2] = {};
        for (const bool eager : {false, true}) {
            uint64_t edges = 0, cycles = 0;
            TestedEdges tested(model->profile());
            tested.run(scene.draw(eager, 1.0), [&](const Recorded& recorded) {
                const Scenario& s = recorded.scenario;
                unit.configure(s.config, s.table.get(), 1);
                const auto [out, accept, depart] = pass(unit, *model, s.inputs);
                EXPECT_EQ(out, recorded.outputs);
                edges += accept.size() - 1;
                cycles += depart.back() - depart.front();
            });
            each[eager] = double(cycles) / double(edges);
        }
        std::printf("  %-16s %.3f in series, %.3f eager\n", name, each[0], each[1]);
        EXPECT_GE(each[1], 4.0);
        EXPECT_LT(each[0], each[1] / 2);
    }
}

TEST(TessellationTestsRtl, WrongOnesAreFound) {
    const auto model = top_of();
    const char* const top = "tops/tessellation_tests.sv";
    for (const Mutation& m :
         {Mutation{"skips what is undecided", "tessellation_tests", top, "~ct_open & ~eager",
                   "ct_open & ~eager"},
          Mutation{"counts a skipped View Test as a no", "tessellation_tests", top,
                   "vt_says | vt_skipped, vt_u", "vt_says, vt_u"},
          Mutation{"forgets that an edge is not eligible", "tessellation_tests", top,
                   "out_eligible & ct & vt", "(out_eligible | nt) & ct & vt"},
          Mutation{"looks at heights although the normals have decided", "tessellation_tests", top,
                   "nt_vt & ~nt_says", "nt_vt"},
          Mutation{"sends an edge before its heights are known", "tessellation_tests",
                   "common/rp_beside.sv", "word & done_valid", "word"},
          Mutation{"ends of the edge swapped for the midpoint", "tessellation_tests", top,
                   "at1_x, at1_y, at2_x, at2_y, at12_x, at12_y} = nt_u",
                   "at12_x, at12_y, at2_x, at2_y, at1_x, at1_y} = nt_u"}}) {
        const Mutant mutant(m);
        const Outcome outcome = run_verilator(*model, 20'000, mutant.root());
        EXPECT_GT(outcome.mismatches, 0U) << m.name;
    }
}

}  // namespace
}  // namespace repousse::cosim
