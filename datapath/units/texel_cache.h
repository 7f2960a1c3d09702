#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/profile.h"
#include "datapath/texel_port.h"
#include "datapath/transaction.h"
#include "datapath/units/texel_cache_desc.h"

namespace repousse {

/// Which line of a full set makes way.
enum class CacheReplacement : uint8_t {
    Oldest,       ///< the one that was fetched first: the ways in turn
    LeastRecent,  ///< the one whose last read is longest ago
};

/// The shape of a cache. A line is 2^line_bits consecutive words, from a multiple of that on; it
/// may lie in any way of one set, the one that the low bits of its number name.
struct CacheShape {
    int line_bits = 0;  ///< 0 to 5
    int set_bits = 0;   ///< 0 to 12
    int ways = 1;       ///< 1 to kMaxCacheWays
    CacheReplacement replacement = CacheReplacement::LeastRecent;

    /// Words in all.
    uint32_t words() const { return static_cast<uint32_t>(ways) << (line_bits + set_bits); }
};

/// The ways of a set are numbered by 3 bits.
inline constexpr int kMaxCacheWays = 8;

/// The shape that a profile gives to every texel cache.
CacheShape cache_shape(const Profile& profile);

/// A read as it enters the unit: the input ports of the description.
struct TexelCacheIn {
    bool invalidate = false;
    uint32_t address = 0;

    std::array<Word, 2> pack() const { return {invalidate, address}; }
    static TexelCacheIn unpack(const Word* w) { return {w[0] != 0, static_cast<uint32_t>(w[1])}; }
};
static_assert(ports_are(kTexelCacheDesc, PortKind::Input, {"invalidate", "address"}));

/// How the cache answers a read.
struct CacheAnswer {
    bool hit = false;
    uint8_t way = 0;       ///< that has the line now
    bool evicted = false;  ///< it had another line before
};

/// The answer with the word that was read, which the table gives.
struct TexelCacheOut {
    uint32_t data = 0;
    CacheAnswer answer;

    std::array<Word, 4> pack() const { return {data, answer.hit, answer.way, answer.evicted}; }
};
static_assert(ports_are(kTexelCacheDesc, PortKind::Output, {"data", "hit", "way", "evicted"}));

/// What a cache counted. Misses are also the lines fetched.
struct TexelCacheCounters {
    uint64_t hits = 0;
    uint64_t misses = 0;
    uint64_t evictions = 0;  ///< misses that replaced a line

    uint64_t reads() const { return hits + misses; }
};

/// The cache at the read port of a map-reading unit: blocking, in order, one a unit.
///
///  1. the line of a word is its address without the low line_bits bits; the set of a line is the
///     low set_bits bits of its number;
///  2. a read hits if a way of the set has the line;
///  3. otherwise the line is fetched into the way that is last in the set's order, and becomes
///     first in it. With LeastRecent a hit makes the line first, too;
///  4. an emptied set has its ways in such an order that way 0 is filled first, then 1, 2 ... so
///     a line is only ever replaced in a full set.
///
/// The answers are a function of the reads since the last invalidation, in their order: of no time,
/// and of nothing that other units do.
class TexelCache final : public TexelPort {
public:
    explicit TexelCache(const CacheShape& shape);

    /// Reads the word at `address`.
    CacheAnswer operator()(uint32_t address);

    /// One transaction of the unit, without its word.
    CacheAnswer operator()(const TexelCacheIn& in) {
        if (in.invalidate) invalidate();
        return (*this)(in.address);
    }

    void read(uint32_t address) override { (*this)(address); }

    /// Drops all lines: the tables may have changed. Counters stay.
    void invalidate();

    const CacheShape& shape() const { return shape_; }
    const TexelCacheCounters& counters() const { return counters_; }
    /// The state at power-on.
    void reset() { invalidate(), counters_ = {}; }

private:
    CacheShape shape_;
    uint32_t set_mask_;
    std::vector<uint32_t> lines_;   // by set and way: the line's number, or kNoLine
    std::vector<uint32_t> orders_;  // by set: the ways, 4 bits each, the next victim at the top
    TexelCacheCounters counters_;
};

}  // namespace repousse
