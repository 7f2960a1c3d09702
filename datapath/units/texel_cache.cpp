#include "datapath/units/texel_cache.h"

#include <algorithm>

namespace repousse {
namespace {

/// No line: those there are have fewer than kTexelAddressBits bits.
constexpr uint32_t kNoLine = ~uint32_t{0};

/// An order is a list of ways, 4 bits each: the first in the low bits. 8 ways fill the word.
constexpr int kPlaceBits = 4;

uint32_t way_at(uint32_t order, int place) { return order >> (kPlaceBits * place) & 15; }

/// Makes the way at a place the first one; those before it move up.
uint32_t to_front(uint32_t order, int place) {
    const uint32_t before = (uint32_t{1} << (kPlaceBits * place)) - 1;
    const uint32_t behind = ~uint32_t{15} << (kPlaceBits * place);
    return (order & behind) | (order & before) << kPlaceBits | way_at(order, place);
}

/// The last way first, way 0 at the top: it is the first to be filled.
uint32_t first_order(int ways) {
    uint32_t order = 0;
    for (int way = 0; way < ways; ++way) order = order << kPlaceBits | static_cast<uint32_t>(way);
    return order;
}

}  // namespace

CacheShape cache_shape(const Profile& profile) {
    return {profile.cache_line_bits, profile.cache_set_bits, profile.cache_ways,
            static_cast<CacheReplacement>(profile.cache_replacement)};
}

TexelCache::TexelCache(const CacheShape& shape)
    : shape_(shape),
      set_mask_((uint32_t{1} << shape.set_bits) - 1),
      lines_(static_cast<std::size_t>(shape.ways) << shape.set_bits, kNoLine),
      orders_(std::size_t{1} << shape.set_bits, first_order(shape.ways)) {}

CacheAnswer TexelCache::operator()(uint32_t address) {
    const uint32_t line = address >> shape_.line_bits;
    const uint32_t set = line & set_mask_;
    uint32_t* const lines = &lines_[set * static_cast<std::size_t>(shape_.ways)];
    uint32_t& order = orders_[set];
    for (int place = 0; place < shape_.ways; ++place) {
        const uint32_t way = way_at(order, place);
        if (lines[way] != line) continue;
        if (shape_.replacement == CacheReplacement::LeastRecent) order = to_front(order, place);
        ++counters_.hits;
        return {true, static_cast<uint8_t>(way), false};
    }
    const uint32_t victim = way_at(order, shape_.ways - 1);
    order = to_front(order, shape_.ways - 1);
    const bool evicted = lines[victim] != kNoLine;
    lines[victim] = line;
    ++counters_.misses;
    counters_.evictions += evicted;
    return {false, static_cast<uint8_t>(victim), evicted};
}

void TexelCache::invalidate() {
    std::fill(lines_.begin(), lines_.end(), kNoLine);
    std::fill(orders_.begin(), orders_.end(), first_order(shape_.ways));
}

}  // namespace repousse
