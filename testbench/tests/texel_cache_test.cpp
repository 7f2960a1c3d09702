// texel_cache against lists of lines, written from the definition, and its hard cases by name.

#include "datapath/units/texel_cache.h"

#include <gtest/gtest.h>

#include <list>
#include <optional>
#include <vector>

#include "testbench/cosim/random.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

using cosim::Random;

constexpr uint32_t kLastAddress = (uint32_t{1} << kTexelAddressBits) - 1;

CacheShape shape(int line_bits, int set_bits, int ways,
                 CacheReplacement replacement = CacheReplacement::LeastRecent) {
    return {line_bits, set_bits, ways, replacement};
}

/// A set is a list of at most `ways` lines, the next one to go in front. A line keeps the number of
/// its way; free ways are given out from 0 on.
class ListCache {
public:
    explicit ListCache(const CacheShape& shape)
        : shape_(shape), sets_(std::size_t{1} << shape.set_bits) {}

    CacheAnswer read(uint32_t address) {
        const uint32_t line = address / (1U << shape_.line_bits);
        std::list<Entry>& set = sets_[line % sets_.size()];
        for (auto entry = set.begin(); entry != set.end(); ++entry) {
            if (entry->line != line) continue;
            const uint8_t way = entry->way;
            if (shape_.replacement == CacheReplacement::LeastRecent) {
                set.splice(set.end(), set, entry);
            }
            return {true, way, false};
        }
        const bool full = set.size() == static_cast<std::size_t>(shape_.ways);
        const auto way = full ? set.front().way : static_cast<uint8_t>(set.size());
        if (full) set.pop_front();
        set.push_back({line, way});
        return {false, way, full};
    }

    void invalidate() {
        for (std::list<Entry>& set : sets_) set.clear();
    }

private:
    struct Entry {
        uint32_t line;
        uint8_t way;
    };
    CacheShape shape_;
    std::vector<std::list<Entry>> sets_;
};

void expect_equal(const CacheAnswer& a, const CacheAnswer& b, uint64_t read) {
    ASSERT_EQ(a.hit, b.hit) << "read " << read;
    ASSERT_EQ(a.way, b.way) << "read " << read;
    ASSERT_EQ(a.evicted, b.evicted) << "read " << read;
}

/// Addresses with the habits of map reads: steps, returns, rows of a map, and jumps.
uint32_t next_address(Random& random, uint32_t address) {
    const uint32_t kind = random.below(100);
    if (kind < 50) return (address + random.below(4)) & kLastAddress;
    if (kind < 75) return (address + 403 - 806 * random.below(2)) & kLastAddress;
    if (kind < 95) return random.below(4096);
    return static_cast<uint32_t>(random.of_any_length(kTexelAddressBits));
}

class TexelCacheShapes : public testing::TestWithParam<CacheReplacement> {};

INSTANTIATE_TEST_SUITE_P(Replacements, TexelCacheShapes,
                         testing::Values(CacheReplacement::Oldest, CacheReplacement::LeastRecent),
                         [](const auto& r) {
                             return r.param == CacheReplacement::Oldest ? "Oldest" : "LeastRecent";
                         });

TEST_P(TexelCacheShapes, AnswersAsListsOfLinesDo) {
    for (const int line_bits : {0, 1, 3, 5}) {
        for (const int set_bits : {0, 1, 4, 7, 12}) {
            for (int ways = 1; ways <= kMaxCacheWays; ++ways) {
                const CacheShape s = shape(line_bits, set_bits, ways, GetParam());
                TexelCache cache(s);
                ListCache lists(s);
                Random random(7, s.words());
                TexelCacheCounters counted;
                uint32_t address = 0;
                for (uint64_t i = 0; i < 10'000; ++i) {
                    address = next_address(random, address);
                    const bool invalidate = random.below(3000) == 0;
                    if (invalidate) lists.invalidate();
                    const CacheAnswer expected = lists.read(address);
                    expect_equal(cache(TexelCacheIn{invalidate, address}), expected, i);
                    ++(expected.hit ? counted.hits : counted.misses);
                    counted.evictions += expected.evicted;
                }
                EXPECT_EQ(cache.counters().hits, counted.hits);
                EXPECT_EQ(cache.counters().misses, counted.misses);
                EXPECT_EQ(cache.counters().evictions, counted.evictions);
                EXPECT_EQ(cache.counters().reads(), 10'000U);
            }
        }
    }
}

TEST_P(TexelCacheShapes, EverySequenceOfReadsOfATinyCache) {
    // Two lines of a set of two, and of a set of three: 5 lines, sequences of 8.
    for (const int ways : {2, 3}) {
        const CacheShape s = shape(0, 0, ways, GetParam());
        TexelCache cache(s);
        ListCache lists(s);
        for (uint32_t sequence = 0; sequence < 390'625; ++sequence) {
            cache.invalidate();
            lists.invalidate();
            for (uint32_t i = 0, digits = sequence; i < 8; ++i, digits /= 5) {
                expect_equal(cache(digits % 5), lists.read(digits % 5), sequence);
            }
        }
    }
}

TEST_P(TexelCacheShapes, SameLineTwice) {
    TexelCache cache(shape(3, 2, 2, GetParam()));
    EXPECT_FALSE(cache(8).hit);
    for (uint32_t word = 8; word < 16; ++word) EXPECT_TRUE(cache(word).hit) << word;
    EXPECT_FALSE(cache(7).hit);
    EXPECT_FALSE(cache(16).hit);
    EXPECT_EQ(cache.counters().misses, 3U);
}

TEST_P(TexelCacheShapes, OneLineMoreThanWaysInTurnNeverHits) {
    for (int ways = 1; ways <= kMaxCacheWays; ++ways) {
        TexelCache cache(shape(2, 3, ways, GetParam()));
        const uint32_t stride = 4 << 3;
        for (int round = 0; round < 3; ++round) {
            for (int line = 0; line <= ways; ++line) {
                EXPECT_FALSE(cache(static_cast<uint32_t>(line) * stride).hit);
            }
        }
        EXPECT_EQ(cache.counters().evictions, 3U * (static_cast<uint32_t>(ways) + 1) - ways);
        // As many lines as ways stay.
        cache.reset();
        for (int round = 0; round < 3; ++round) {
            for (int line = 0; line < ways; ++line) {
                EXPECT_EQ(cache(static_cast<uint32_t>(line) * stride).hit, round > 0);
            }
        }
        EXPECT_EQ(cache.counters().evictions, 0U);
    }
}

TEST_P(TexelCacheShapes, ResetBetweenFrames) {
    TexelCache cache(shape(1, 2, 2, GetParam()));
    const auto frame = [&cache] {
        std::vector<uint8_t> ways;
        for (const uint32_t address : {0U, 8U, 16U, 0U, 2U, 8U}) ways.push_back(cache(address).way);
        return ways;
    };
    const std::vector<uint8_t> first = frame();
    const TexelCacheCounters counted = cache.counters();
    cache.invalidate();
    EXPECT_EQ(frame(), first);  // nothing of the frame before is left, not even the order
    EXPECT_EQ(cache.counters().hits, 2 * counted.hits);
    EXPECT_EQ(cache.counters().misses, 2 * counted.misses);
    cache.reset();
    EXPECT_EQ(cache.counters().reads(), 0U);
    EXPECT_EQ(frame(), first);
}

TEST_P(TexelCacheShapes, LastAddress) {
    for (const int line_bits : {0, 5}) {
        TexelCache cache(shape(line_bits, 12, 8, GetParam()));
        const uint32_t line = 1U << line_bits;
        EXPECT_FALSE(cache(kLastAddress).hit);
        EXPECT_TRUE(cache(kLastAddress - (line - 1)).hit);
        EXPECT_FALSE(cache(kLastAddress - line).hit);
        EXPECT_FALSE(cache(0).hit);
        EXPECT_TRUE(cache(kLastAddress).hit);
    }
}

TEST_P(TexelCacheShapes, LineOfOneWord) {
    TexelCache cache(shape(0, 0, 1, GetParam()));  // one word in all
    for (const uint32_t address : {0U, 1U, 0U, kLastAddress}) EXPECT_FALSE(cache(address).hit);
    EXPECT_TRUE(cache(kLastAddress).hit);
    EXPECT_EQ(cache.counters().evictions, 3U);
}

TEST(TexelCache, AHitSavesALineFromTheLeastRecentRule) {
    for (const CacheReplacement r : {CacheReplacement::Oldest, CacheReplacement::LeastRecent}) {
        TexelCache cache(shape(0, 0, 2, r));
        for (const uint32_t address : {0U, 1U, 0U, 2U}) cache(address);
        EXPECT_EQ(cache(0).hit, r == CacheReplacement::LeastRecent);
    }
}

TEST(TexelCache, MoreWaysOfTheLeastRecentRuleNeverMissMore) {
    // Inclusion: with one set, what a smaller cache has, a larger one has.
    Random random(5);
    std::vector<TexelCache> caches;
    for (int ways = 1; ways <= kMaxCacheWays; ++ways) caches.emplace_back(shape(1, 0, ways));
    for (int i = 0; i < 100'000; ++i) {
        const uint32_t address = random.below(24);
        bool hit = false;
        for (TexelCache& cache : caches) {
            const bool larger = cache(address).hit;
            EXPECT_LE(hit, larger);
            hit = larger;
        }
    }
}

TEST(TexelCache, TheProfileGivesItsShape) {
    const CacheShape s = cache_shape(*shipped_profile("default"));
    EXPECT_EQ(s.line_bits, 3);
    EXPECT_EQ(s.set_bits, 6);
    EXPECT_EQ(s.ways, 4);
    EXPECT_EQ(s.replacement, CacheReplacement::LeastRecent);
    EXPECT_EQ(s.words(), 2048U);
    EXPECT_EQ(cache_shape(*shipped_profile("narrow")).replacement, CacheReplacement::Oldest);
}

}  // namespace
}  // namespace repousse
