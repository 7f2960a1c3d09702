// The reads of the map-reading units: heard at their ports in architectural order, however a run is
// cut into batches; and docs/cache.md says what they make of the caches.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "testbench/host/draw.h"
#include "testbench/host/files.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/study/cache.h"
#include "testbench/study/scene_run.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

/// A scene with its first object's draw, for as long as the scene lives.
struct Loaded {
    explicit Loaded(const std::string& scene)
        : run(*SceneRun::open("scenes/" + scene + ".toml")),
          profile(*shipped_profile(run.scene.profile)),
          inputs(host::draw_inputs(run.scene, run.scene.objects[0], run.mesh(0), run.map(0))) {}

    SceneRun run;
    Profile profile;
    host::DrawInputs inputs;
};

struct Traces {
    ReadTrace displace, bump, height_test;

    TexelPorts ports() { return {&displace, &bump, &height_test}; }
    void begin(const Path& path) {
        for (ReadTrace* trace : {&displace, &bump, &height_test}) trace->begin(path);
    }
};

struct Mode {
    const char* name;
    StackOrder order;
    bool eager;
};

class AdaptiveReads : public testing::TestWithParam<Mode> {};

INSTANTIATE_TEST_SUITE_P(Modes, AdaptiveReads,
                         testing::Values(Mode{"Lifo", StackOrder::Lifo, false},
                                         Mode{"LifoEager", StackOrder::Lifo, true},
                                         Mode{"Fifo", StackOrder::Fifo, false},
                                         Mode{"FifoEager", StackOrder::Fifo, true}),
                         [](const auto& mode) { return mode.param.name; });

TEST_P(AdaptiveReads, AreTheSameForEveryNumberOfContexts) {
    Loaded scene("donut");
    auto draw = *host::make_draw<Fixed>(scene.profile, scene.inputs);
    draw.registers.order = GetParam().order;
    draw.registers.eager = GetParam().eager;
    Traces one;  // triangle by triangle, in the order of the stack
    AdaptivePipeline<Fixed> pipeline(scene.profile, draw);
    pipeline.attach(one.ports());
    ASSERT_TRUE(pipeline.run([](Span<const OutputTriangle<Fixed>>) {}, 1));
    const AdaptiveCounters counters = pipeline.counters();
    EXPECT_EQ(one.displace.addresses().size(), counters.displace.reads);
    EXPECT_EQ(one.bump.addresses().size(), counters.bump->reads);
    EXPECT_EQ(one.height_test.addresses().size(), counters.height_test_reads);
    EXPECT_GT(counters.height_test_reads, 10'000U);

    for (const int contexts : {2, 7, 32}) {
        Traces many;
        AdaptivePipeline<Fixed> batched(scene.profile, draw);
        batched.attach(many.ports(), [&](const Path& path) { many.begin(path); });
        ASSERT_TRUE(batched.run([](Span<const OutputTriangle<Fixed>>) {}, contexts));
        const StackOrder order = draw.registers.order;
        EXPECT_NE(many.displace.addresses(), one.displace.addresses()) << contexts;
        EXPECT_EQ(many.displace.in_order(order), one.displace.addresses()) << contexts;
        EXPECT_EQ(many.bump.in_order(order), one.bump.addresses()) << contexts;
        EXPECT_EQ(many.height_test.in_order(order), one.height_test.addresses()) << contexts;
    }
}

TEST(TexelPorts, APortChangesNoTriangle) {
    Loaded scene("donut_small");
    const auto draw = *host::make_draw<Fixed>(scene.profile, scene.inputs);
    const auto output = [&](bool listen) {
        Traces traces;
        AdaptivePipeline<Fixed> pipeline(scene.profile, draw);
        if (listen) {
            pipeline.attach(traces.ports(), [&](const Path& path) { traces.begin(path); });
        }
        std::vector<int32_t> words;
        EXPECT_TRUE(pipeline.run([&](Span<const OutputTriangle<Fixed>> triangles) {
            for (const OutputTriangle<Fixed>& triangle : triangles) {
                for (const OutputVertex<Fixed>& v : triangle.corners) {
                    for (const int32_t w : {v.uv.x, v.uv.y, v.displaced.x, v.displaced.y,
                                            v.displaced.z, v.displaced_normal.x}) {
                        words.push_back(w);
                    }
                }
            }
        }));
        return words;
    };
    EXPECT_EQ(output(true), output(false));
}

TEST(SweepReads, ComeVertexByVertex) {
    // The vertices as they come out, read again one by one.
    Loaded scene("terrain_sweep");
    const auto draw = *host::make_sweep_draw<Fixed>(scene.profile, scene.inputs);
    Traces heard;
    std::vector<Uv> places;
    SweepPipeline<Fixed> pipeline(scene.profile, draw);
    pipeline.attach(heard.ports());
    ASSERT_TRUE(
        pipeline.run([&](Span<const SweepOutputVertex<Fixed>> vertices, Span<const FineTriangle>) {
            for (const SweepOutputVertex<Fixed>& vertex : vertices) places.push_back(vertex.uv);
        }));
    ReadTrace alone;
    Displace<Fixed> displace(scene.profile);
    displace.configure(draw.view());
    displace.attach(&alone);
    for (const Uv& uv : places) displace.displacement(uv);
    EXPECT_GT(places.size(), 5'000U);
    EXPECT_EQ(heard.displace.addresses(), alone.addresses());
    EXPECT_EQ(pipeline.counters().displace.reads, alone.addresses().size());
}

TEST(CacheStudy, SizesAreWhatTheySay) {
    for (const CacheShape& shape : cache_shapes()) {
        EXPECT_GE(shape.words(), 1U << kLeastCacheBits);
        EXPECT_LE(shape.words(), 1U << kMostCacheBits);
    }
    EXPECT_FALSE(shape_of(4, 4, 4, CacheReplacement::Oldest));
}

TEST(CacheStudy, OneSetOfEightLinesIsACacheOfEightWays) {
    const auto reads = scene_reads("scenes/donut_small.toml", false);
    ASSERT_TRUE(reads) << reads.error().message();
    for (const UnitReads& unit : reads->units) {
        const TexelCacheCounters counted =
            through_cache({3, 0, 8, CacheReplacement::LeastRecent}, unit);
        EXPECT_EQ(counted.reads(), unit.count());
        EXPECT_DOUBLE_EQ(one_set_hit_rate(6, unit), 100.0 * static_cast<double>(counted.hits) /
                                                        static_cast<double>(counted.reads()));
    }
}

/// Every row about the scene in the report stands in the document.
void expect_rows(const std::string& document, const std::string& scene, bool eager) {
    const auto reads = scene_reads("scenes/" + scene + ".toml", eager);
    ASSERT_TRUE(reads) << reads.error().message();
    CacheReport report;
    report.scenes = {study_caches(*reads)};
    const std::string text = cache_markdown(report, "f.svg");
    std::size_t rows = 0;
    for (std::size_t at = text.find("\n| " + scene + " | "); at != std::string::npos;
         at = text.find("\n| " + scene + " | ", at + 1)) {
        const std::string row = text.substr(at, text.find('\n', at + 1) + 1 - at);
        EXPECT_NE(document.find(row), std::string::npos) << row;
        ++rows;
    }
    EXPECT_EQ(rows, report.scenes[0].units.size() * (eager ? 1 : 4));
}

TEST(CacheDocument, IsNotStale) {
    const auto text = host::read_file("docs/cache.md");
    ASSERT_TRUE(text) << text.error().message();
    EXPECT_EQ(text->find("in the place of"), std::string::npos) << "made without the inputs";
    expect_rows(*text, "donut", false);
    expect_rows(*text, "donut", true);
    if (!host::is_file("inputs/jacksboro_fault_dem.npz")) {
        GTEST_SKIP() << "the elevation file is absent: scenes/fetch.sh";
    }
    expect_rows(*text, "terrain_sweep", false);
}

TEST(CacheDocument, ItsFigureIsThere) {
    const auto figure = host::read_file("docs/images/cache.svg");
    ASSERT_TRUE(figure) << figure.error().message();
    // Four line lengths in 12 panels, and 5 caches in 3.
    std::size_t curves = 0;
    for (std::size_t at = 0; (at = figure->find("<polyline", at)) != std::string::npos; ++at) {
        ++curves;
    }
    EXPECT_EQ(curves, 4U * 12 + 5U * 3);
}

}  // namespace
}  // namespace repousse::study
