#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "testbench/cosim/engine.h"
#include "testbench/cosim/random.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// What came out of a unit, and when: cycles since the items were sent.
struct Passage {
    std::vector<int64_t> out;      ///< beats
    std::vector<uint64_t> accept;  ///< an item's cycle
    std::vector<uint64_t> depart;  ///< a beat's cycle
};

/// Sends items through a unit. They are offered from the cycles `offer` on and their beats taken
/// from the cycles `ready` on, both counted from the call (empty: at once). `beats` is how many
/// they make (0: one each).
inline Passage pass(EngineInstance& unit, const UnitModel& model, const std::vector<int64_t>& in,
                    std::vector<uint64_t> offer = {}, std::vector<uint64_t> ready = {},
                    std::size_t beats = 0) {
    const std::size_t items = in.size() / model.inputs();
    if (beats == 0) beats = items;
    Passage passage;
    passage.out.resize(beats * model.outputs());
    passage.accept.resize(items);
    passage.depart.resize(beats);
    const uint64_t start = unit.cycle();
    for (auto* cycles : {&offer, &ready}) {
        for (uint64_t& t : *cycles) t += start;
    }
    uint64_t sent = 0;
    RepousseBatch batch = plain_batch(items, in.data(), passage.out.data());
    batch.capacity = beats;
    batch.beats = &sent;
    batch.offer = offer.empty() ? nullptr : offer.data();
    batch.ready = ready.empty() ? nullptr : ready.data();
    batch.accept = passage.accept.data();
    batch.depart = passage.depart.data();
    EXPECT_EQ(unit.run(batch), kRepousseDone);
    EXPECT_EQ(sent, beats);
    for (auto* cycles : {&passage.accept, &passage.depart}) {
        for (uint64_t& t : *cycles) t -= start;
    }
    return passage;
}

/// The same item `count` times.
inline std::vector<int64_t> repeated(const std::vector<int64_t>& item, std::size_t count) {
    std::vector<int64_t> items;
    items.reserve(count * item.size());
    for (std::size_t i = 0; i < count; ++i) items.insert(items.end(), item.begin(), item.end());
    return items;
}

/// Ascending cycles: mostly one after the other, else `least` to `least + spread - 1` later.
inline std::vector<uint64_t> random_cycles(Random& random, std::size_t count, uint32_t least,
                                           uint32_t spread) {
    std::vector<uint64_t> cycles(count);
    uint64_t last = 0;
    for (uint64_t& t : cycles) t = last += random.percent(60) ? 1 : least + random.below(spread);
    return cycles;
}

}  // namespace repousse::cosim
