// The timing figures of the descriptions, read off the RTL: latency, interval, capacity, backward
// latency, and for the single pipelines every accept and departure cycle under random stalls.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "testbench/cosim/table_pool.h"
#include "testbench/tests/support/rtl_engine.h"
#include "testbench/tests/support/rtl_passage.h"

namespace repousse::cosim {
namespace {

/// A unit's engine with transactions that all take the same path: no skips, no seams.
class Probe {
public:
    explicit Probe(const std::string& unit)
        : model_(model_of(unit)), instance_(engine_of(*model_)) {
        scenario_.inputs = {};
        scenario_.config = model_->hard_cases().at(0).config;
        if (unit == "view_test") scenario_.config = {100};
        if (unit == "height_test") {
            scenario_.config = {16, 16, 0, 0, 0, 100};
            scenario_.table = prefix_sums(16, 16, 38, [](int x, int y) { return x * y; });
        }
        instance_.configure(scenario_.config, scenario_.table.get(), 1);
    }

    const UnitDesc& desc() const { return model_->desc(); }
    EngineInstance& instance() { return instance_; }

    /// Runs `count` transactions, offered and taken from the given cycles on (see pass()). Fills
    /// accept and depart.
    void run(std::size_t count, const std::vector<uint64_t>& offer,
             const std::vector<uint64_t>& ready, bool skip = false) {
        std::vector<int64_t> words = {skip, 0, 0, 1024, 512, 512, 256};
        words.resize(model_->inputs());
        Passage passage = pass(instance_, *model_, repeated(words, count), offer, ready);
        accept = std::move(passage.accept);
        depart = std::move(passage.depart);
    }

    /// Cycles between two transactions of these words, many of them in a row.
    uint64_t interval(const std::vector<int64_t>& words) {
        constexpr std::size_t kCount = 40;
        const auto at = pass(instance_, *model_, repeated(words, kCount)).accept;
        return at[kCount - 1] - at[kCount - 2];
    }

    std::vector<uint64_t> accept;
    std::vector<uint64_t> depart;

private:
    std::unique_ptr<UnitModel> model_;
    EngineInstance instance_;
    Scenario scenario_;
};

class RtlTiming : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Units, RtlTiming,
                         testing::Values("texcoord_test", "view_test", "normal_test", "height_test",
                                         "grid_transform", "view_clip", "perspective", "strip",
                                         "shade", "normalise", "footprint", "mid_vertex"),
                         [](const auto& unit) { return unit.param; });

TEST_P(RtlTiming, ReadyInCycleZero) {
    Probe probe(GetParam());
    probe.run(1, {}, {});
    EXPECT_EQ(probe.accept[0], 0U);
}

TEST_P(RtlTiming, Latency) {
    Probe probe(GetParam());
    for (int i = 0; i < 3; ++i) {
        probe.run(1, {7}, {});
        EXPECT_EQ(probe.accept[0], 7U);
        EXPECT_EQ(probe.depart[0] - probe.accept[0], uint64_t(probe.desc().latency));
    }
}

TEST_P(RtlTiming, Interval) {
    Probe probe(GetParam());
    probe.run(100, {}, {});
    for (std::size_t i = 50; i + 1 < 100; ++i) {
        EXPECT_EQ(probe.accept[i + 1] - probe.accept[i], uint64_t(probe.desc().interval)) << i;
        EXPECT_EQ(probe.depart[i + 1] - probe.depart[i], uint64_t(probe.desc().interval)) << i;
    }
}

TEST_P(RtlTiming, CapacityAndBackwardLatency) {
    // Nothing leaves before cycle 1000: the unit fills up. Then the next item gets in when there
    // is a place, `backward_latency` cycles after the first departure at the earliest.
    Probe probe(GetParam());
    const auto capacity = static_cast<std::size_t>(probe.desc().capacity);
    probe.run(capacity + 5, {}, std::vector<uint64_t>(capacity + 5, 1000));
    EXPECT_LT(probe.accept[capacity - 1], 1000U);
    EXPECT_EQ(probe.depart[0], 1000U);
    EXPECT_GE(probe.accept[capacity], 1000U + uint64_t(probe.desc().backward_latency));
}

TEST_P(RtlTiming, SkippedItemsPassOneACycle) {
    Probe probe(GetParam());
    probe.run(100, {}, {}, true);
    EXPECT_EQ(probe.accept[60] - probe.accept[50], 10U);
    EXPECT_LE(probe.depart[0] - probe.accept[0], uint64_t(probe.desc().latency));
}

/// A(i) = max(V(i), A(i-1)+1, D(i-C)+r), D(i) = max(A(i)+L, D(i-1)+1, R(i)): exact for a pipe.
TEST(RtlTimingOf, SinglePipelinesFollowTheirRecurrence) {
    for (const char* unit :
         {"texcoord_test", "view_test", "normal_test", "grid_transform", "view_clip", "perspective",
          "strip", "shade", "normalise", "mid_vertex"}) {
        Probe probe(unit);
        Random random(3);
        constexpr std::size_t kCount = 20000;
        std::vector<uint64_t> offer(kCount), ready(kCount);
        uint64_t v = 0, r = 0;
        for (std::size_t i = 0; i < kCount; ++i) {
            offer[i] = v += random.percent(60) ? 1 : 1 + random.below(8);
            ready[i] = r = std::max(r, v) + (random.percent(60) ? 0 : random.below(12));
        }
        probe.run(kCount, offer, ready);
        const auto latency = static_cast<uint64_t>(probe.desc().latency);
        const auto capacity = static_cast<std::size_t>(probe.desc().capacity);
        const auto backward = static_cast<uint64_t>(probe.desc().backward_latency);
        std::size_t wrong = 0;
        std::vector<uint64_t> a(kCount), d(kCount);
        for (std::size_t i = 0; i < kCount; ++i) {
            a[i] = offer[i];
            if (i > 0) a[i] = std::max(a[i], a[i - 1] + 1);
            if (i >= capacity) a[i] = std::max(a[i], d[i - capacity] + backward);
            d[i] = std::max(a[i] + latency, ready[i]);
            if (i > 0) d[i] = std::max(d[i], d[i - 1] + 1);
            wrong += probe.accept[i] != a[i] || probe.depart[i] != d[i];
        }
        EXPECT_EQ(wrong, 0U) << unit;
    }
}

TEST(RtlTimingOf, DisplaceTakesAsManyCyclesAsItReads) {
    Probe probe("displace");
    const UnitDesc& desc = probe.desc();
    const Table map{4, 4, std::vector<uint64_t>(25, 5)};
    for (const int64_t filter : {2, 0, 1}) {
        const auto reads = filter == 1 ? uint64_t(desc.interval) : 1;
        probe.instance().configure({4, 4, 0, filter, 0, 0, 1 << 23, 40, 0}, &map, 1);
        probe.run(1, {7}, {});
        EXPECT_EQ(probe.depart[0] - probe.accept[0], uint64_t(desc.latency - 4) + reads);
        probe.run(100, {}, {});
        EXPECT_EQ(probe.accept[61] - probe.accept[60], reads);
        EXPECT_EQ(probe.depart[61] - probe.depart[60], reads);
    }
    const auto capacity = static_cast<std::size_t>(desc.capacity);
    probe.run(capacity + 5, {}, std::vector<uint64_t>(capacity + 5, 1000));
    EXPECT_LT(probe.accept[capacity - 1], 1000U);
    EXPECT_GE(probe.accept[capacity], 1000U + uint64_t(desc.backward_latency));
}

TEST(RtlTimingOf, DisplaceReadsATexelUnderAFootprintOnce) {
    Probe probe("displace");
    const Table map{8, 8, std::vector<uint64_t>(81, 5)};
    const auto finer = [&](int64_t levels) {
        probe.instance().configure({8, 8, 0, 2, levels, 0, 1 << 23, 40, 0}, &map, 1);
    };
    const auto interval = [&](int64_t reach_x, int64_t reach_y) {
        return probe.interval({0, 0, 0, 0, 0, 0, 1024, 1024, reach_x, reach_y, 0, 0});
    };
    finer(0);
    EXPECT_EQ(interval(0, 0), 1U);
    EXPECT_EQ(interval(128, 0), 2U);
    EXPECT_EQ(interval(0, 128), 2U);
    EXPECT_EQ(interval(128, 128), 4U);
    EXPECT_EQ(interval(512, 512), 4U);
    finer(1);  // U is 4 texels; half a texel around it are two texels, one texel around it three
    EXPECT_EQ(interval(0, 0), 1U);
    EXPECT_EQ(interval(128, 0), 2U);
    EXPECT_EQ(interval(256, 128), 6U);
    EXPECT_EQ(interval(512, 512), 9U);
    finer(2);
    EXPECT_EQ(interval(128, 0), 2U);
    EXPECT_EQ(interval(512, 256), 15U);
    EXPECT_EQ(interval(512, 512), 25U);
}

TEST(RtlTimingOf, HeightTestTakesAsManyCyclesAsItReads) {
    // A periodic map: edges whose boxes cross a seam in one direction take 6 beats, in both 9.
    Probe probe("height_test");
    const auto table = prefix_sums(16, 16, 38, [](int x, int y) { return x * y; });
    probe.instance().configure({16, 16, 1, 0, 0, 100}, table.get(), 1);
    EXPECT_EQ(probe.interval({0, 1024, 1024, 2048, 2048, 1536, 1536}), 4U);
    EXPECT_EQ(probe.interval({0, 0, 1024, 2048, 1024, 1024, 1024}), 6U);
    EXPECT_EQ(probe.interval({0, 0, 0, 2048, 2048, 1024, 1024}), 9U);
}

}  // namespace
}  // namespace repousse::cosim
