// Batches of the sweep line and of the stripping unit against their single steps: the same
// commands, vertices, triangles and counters.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "datapath/strip_ports.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using test::TriangleKind;

/// How both are built.
struct Setting {
    const char* name;
    AdderKind adder;
    int guard_bits;
    int column_depth;
    bool SweepRepairs::*off;  // null: all repairs
};

constexpr Setting kSettings[] = {
    {"TwoLanes", AdderKind::Exact, 0, 256, nullptr},
    {"ShortFifo", AdderKind::Exact, 0, 8, nullptr},
    {"OneLane", AdderKind::Exact, 0, 0, nullptr},
    {"Canonical", AdderKind::Canonical, 8, 256, nullptr},
    {"PlainWithoutGuardBits", AdderKind::Plain, 0, 256, nullptr},
    {"PlainWithGuardBits", AdderKind::Plain, 13, 64, nullptr},
    {"WithoutClimb", AdderKind::Exact, 0, 256, &SweepRepairs::climb},
    {"WithoutDragBelow", AdderKind::Exact, 0, 256, &SweepRepairs::drag_below},
    {"WithoutLastColumn", AdderKind::Exact, 0, 256, &SweepRepairs::last_column},
    {"WithoutOtherEdge", AdderKind::Exact, 0, 256, &SweepRepairs::other_edge},
    {"WithoutRightStall", AdderKind::Exact, 0, 256, &SweepRepairs::right_stall},
};

SweepLineOptions options_of(const Setting& setting) {
    SweepLineOptions options;
    options.column_depth = setting.column_depth;
    if (setting.off != nullptr) options.repairs.*setting.off = false;
    return options;
}

/// What a triangle gives, step by step: all of it as numbers.
struct Record {
    std::vector<int32_t> steps;
    std::vector<int32_t> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
};

void add(const StripStep& step, std::size_t vertices, std::vector<int32_t>& to) {
    to.insert(to.end(), {step.init, step.init && step.flip, step.count, int32_t(vertices)});
    for (std::size_t i = 0; i < step.count; ++i) to.push_back(int32_t(pack(step.commands[i])));
}

void add(const VertexName& name, std::vector<int32_t>& to) {
    to.insert(to.end(), {int32_t(name.kind), name.part, name.a, name.b});
}

class SweepBatches : public testing::TestWithParam<Setting> {
protected:
    void single(const SweepTriangle& triangle, Record& record) {
        uint32_t number = 0;
        StripTriangles<uint32_t> made;
        steps_.run(triangle, [&](const SweepStep& step) {
            add(step.strip, step.vertex_count, record.steps);
            std::array<uint32_t, 4> numbers{};
            for (std::size_t i = 0; i < step.vertex_count; ++i) {
                numbers[i] = number++;
                add(step.vertices[i].name, record.vertices);
                for (const int32_t x : step.vertices[i].data) record.vertices.push_back(x);
            }
            step_strip_(step.strip, {numbers.data(), step.vertex_count}, made);
            record.triangles.insert(record.triangles.end(), made.triangles.begin(),
                                    made.triangles.begin() + made.count);
        });
    }

    // With room for a random number of runs each time.
    void batched(const SweepTriangle& triangle, Record& record) {
        uint32_t number = 0;
        std::array<SweepRun, kBatchRuns> runs;
        batches_.load(triangle);
        while (batches_.busy()) {
            vertices_.size = 0;
            const std::size_t room = 1 + random_() % runs.size();
            const std::size_t count = batches_.fill({runs.data(), room}, vertices_);
            for (std::size_t r = 0; r < count; ++r) {
                longest_ = std::max(longest_, runs[r].times);
                for (uint32_t i = 0; i < runs[r].times; ++i) {
                    add(runs[r].strip, runs[r].vertex_count, record.steps);
                }
            }
            for (std::size_t i = 0; i < vertices_.size; ++i) {
                add(vertices_.names[i], record.vertices);
                for (const auto& column : vertices_.data) record.vertices.push_back(column[i]);
            }
            batch_strip_.run(
                {runs.data(), count}, [&number] { return number++; }, record.triangles);
        }
    }

    const Setting setting_ = GetParam();
    std::mt19937_64 random_{5};
    SweepLine steps_{options_of(setting_)}, batches_{options_of(setting_)};
    Strip<uint32_t> step_strip_, batch_strip_;
    SweptVertices<int32_t> vertices_;
    uint32_t longest_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Settings, SweepBatches, testing::ValuesIn(kSettings),
                         [](const auto& setting) { return std::string(setting.param.name); });

TEST_P(SweepBatches, HoldWhatSingleStepsGive) {
    TriangleSetup setup({setting_.adder, setting_.guard_bits, kSweepComponents});
    SweepTriangle triangle;
    for (int n = 0; n < 700; ++n) {
        const bool large = n % 50 == 0;
        setup(test::with_data(large ? test::random_triangle(TriangleKind::Large, random_)
                                    : test::mixed_triangle(n, random_),
                              random_, 24),
              triangle);
        Record one, many;
        single(triangle, one);
        batched(triangle, many);
        ASSERT_EQ(one.steps, many.steps) << n;
        ASSERT_EQ(one.vertices, many.vertices) << n;
        ASSERT_EQ(one.triangles, many.triangles) << n;
        if (!steps_.runaway()) continue;
        step_strip_.flush();
        batch_strip_.flush();
    }
    const auto numbers = [](const SweepLineCounters& c) {
        return std::vector<uint64_t>{
            c.items,    c.columns, c.steps,    c.quads,     c.ears, c.triangles,        c.additions,
            c.commands, c.swaps,   c.vertices, c.displaced, c.kept, c.highest_register, c.runaways};
    };
    EXPECT_EQ(numbers(steps_.counters()), numbers(batches_.counters()));
    const auto strip_numbers = [](const StripCounters& c) {
        return std::vector<uint64_t>{c.steps,    c.commands,  c.strips,   c.swaps,
                                     c.vertices, c.triangles, c.bad_refs, c.deepest};
    };
    EXPECT_EQ(strip_numbers(step_strip_.counters()), strip_numbers(batch_strip_.counters()));
    // Without a column FIFO nothing is taken from it.
    EXPECT_EQ(longest_ > 1, setting_.column_depth != 0) << longest_;
}

}  // namespace
}  // namespace repousse
