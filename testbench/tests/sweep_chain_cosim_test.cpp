// The Verilog top of sweep line, perspective and strip against the datapaths of the three, and its
// pace: hard cases and random base triangles, every bit of every vertex of every fine triangle.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "datapath/sweep_line_ports.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/cosim/vector_file.h"
#include "testbench/tests/support/sweep_run.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<UnitModel> chain() {
    return make_unit_model("sweep_chain", *shipped_profile("default"));
}

Engine engine_of(const UnitModel& model, const fs::path& root = source_folder()) {
    const auto path = build_engine(model.desc(), model.profile(), root);
    if (!path) throw std::runtime_error(path.error().message());
    auto engine = Engine::open(*path, model.desc(), model.profile());
    if (!engine) throw std::runtime_error(engine.error().message());
    return *engine;
}

Effort effort(uint64_t vectors) {
    Effort e;
    e.vectors = vectors;
    e.stalled_percent = 50;  // of the batches; those run under random gaps and stalls
    return e;
}

TEST(SweepChainRtl, HardCasesAndRandomOnesInVerilator) {
    const auto model = chain();
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(4'000), {});
    EXPECT_GE(outcome.cases, 4'000U);
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, WithAColumnFifoOfThreeAndWithoutTangents) {
    const auto model = chain();
    const auto tiny = model->with(model->tiny_profile());
    const Outcome outcome =
        run_random(*tiny, engine_of(*tiny), tiny->hard_cases(), effort(4'000), {});
    EXPECT_EQ(outcome.mismatches, 0U) << outcome.first_mismatch.substr(0, 600);
}

TEST(SweepChainRtl, NarrowProfile) {
    const auto model = make_unit_model("sweep_chain", *shipped_profile("narrow"));
    const Outcome outcome =
        run_random(*model, engine_of(*model), model->hard_cases(), effort(3'000), {});
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

// Base triangles offered at once, beats taken at once.
class Pace {
public:
    Pace() : profile_(*shipped_profile("default")), model_(chain()), unit_(engine_of(*model_)) {
        unit_.configure({0, 1}, nullptr, 1);
    }

    struct Figures {
        double cycles = 0, vertices = 0, steps = 0;  // per fine triangle
    };

    /// Flat triangles with corners uniform in a square of `size`.
    Figures measure(int size, int count) {
        std::mt19937_64 random(5);
        TriangleSetup setup({AdderKind::Exact, 0, profile_.components});
        SweepLine counter({profile_.column_depth, {}});
        std::vector<int64_t> in;
        uint64_t beats = 0;
        for (int n = 0; n < count; ++n) {
            test::GridTriangle t{};
            for (auto& p : t) {
                for (std::size_t axis = 0; axis < 2; ++axis)
                    p[axis] = int(random() % unsigned(size + 1));
            }
            SweepLineIn item;
            setup(test::corners_of(t), item.triangle);
            counter.run(item.triangle, [&](const SweepStep&) { ++beats; });
            const std::vector<Word> words = item.pack(profile_);
            in.insert(in.end(), words.begin(), words.end());
        }
        std::vector<int64_t> out(beats * model_->outputs());
        std::vector<uint64_t> accept(static_cast<std::size_t>(count)), depart(beats);
        uint64_t sent = 0;
        RepousseBatch batch = plain_batch(uint64_t(count), in.data(), out.data());
        batch.capacity = beats;
        batch.beats = &sent;
        batch.accept = accept.data();
        batch.depart = depart.data();
        EXPECT_EQ(unit_.run(batch), kRepousseDone);
        EXPECT_EQ(sent, beats);
        latency = depart.front() - accept.front();
        const auto each = [&](uint64_t n) {
            return double(n) / double(counter.counters().triangles);
        };
        return {each(depart.back() - depart.front() + 1), each(counter.counters().displaced),
                each(beats)};
    }

    const UnitDesc& desc() const { return model_->desc(); }
    uint64_t latency = 0;

private:
    Profile profile_;
    std::unique_ptr<UnitModel> model_;
    EngineInstance unit_;
};

TEST(SweepChainRtl, CyclesPerFineTriangle) {
    Pace pace;
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
        const Pace::Figures f = pace.measure(row.size, row.count);
        std::printf("%4d  %.3f     %.3f   %.3f   %.2f\n", row.size, f.steps, f.vertices, f.cycles,
                    row.bound);
        EXPECT_LE(f.cycles, row.bound) << row.size;
        EXPECT_GE(f.cycles, f.vertices - 0.01) << "one vertex a cycle goes through perspective";
    }
}

TEST(SweepChainRtl, Latency) {
    Pace pace;
    for (int i = 0; i < 2; ++i) {
        pace.measure(16, 1);
        EXPECT_EQ(pace.latency, uint64_t(pace.desc().latency));
    }
}

/// A copy of rtl/ in which one text is replaced by another.
class Mutant {
public:
    Mutant(const std::string& file, const std::string& from, const std::string& to) {
        std::string pattern = (fs::temp_directory_path() / "repousse-mutant-XXXXXX").string();
        root_ = mkdtemp(pattern.data());
        fs::copy(source_folder() / "rtl", root_ / "rtl", fs::copy_options::recursive);
        std::stringstream text;
        text << std::ifstream(root_ / "rtl" / file).rdbuf();
        std::string changed = text.str();
        const std::size_t at = changed.find(from);
        if (at == std::string::npos) throw std::runtime_error(from + " is not in " + file);
        changed.replace(at, from.size(), to);
        std::ofstream(root_ / "rtl" / file) << changed;
    }
    ~Mutant() { fs::remove_all(root_); }
    Mutant(const Mutant&) = delete;
    Mutant& operator=(const Mutant&) = delete;
    const fs::path& root() const { return root_; }

private:
    fs::path root_;
};

TEST(SweepChainRtl, WrongOnesAreFound) {
    struct Mutation {
        const char *what, *file, *from, *to;
    };
    const auto model = chain();
    const auto tiny = model->with(model->tiny_profile());
    for (const Mutation& m : {Mutation{"overfills the queue of vertices", "common/rp_scatter.sv",
                                       "CW'(D - N)", "CW'(D - N + 2)"},
                              Mutation{"does not wait for the last vertex", "common/rp_gather.sv",
                                       "count >= CW'(out_n)", "count + 1'b1 >= CW'(out_n)"},
                              Mutation{"keeps what a dropped triangle left", "tops/sweep_chain.sv",
                                       "ends & (count == 3'd0)", "1'b0"}}) {
        const Mutant mutant(m.file, m.from, m.to);
        const Outcome outcome = run_random(*tiny, engine_of(*tiny, mutant.root()),
                                           tiny->hard_cases(), effort(3'000), {});
        EXPECT_GT(outcome.mismatches, 0U) << m.what;
    }
}

}  // namespace
}  // namespace repousse::cosim
