#pragma once

#include "datapath/texel_port.h"
#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kTexelCachePorts[] = {
    {PortKind::Input, "invalidate", "", 1, true, "drop all lines before this read"},
    {PortKind::Input, "address", "", kTexelAddressBits, true, "number of the word in its table"},
    {PortKind::Output, "data", "height", 0, true, "the word"},
    {PortKind::Output, "hit", "", 1, true, "its line was there"},
    {PortKind::Output, "way", "", 3, true, "where the line is in its set"},
    {PortKind::Output, "evicted", "", 1, true, "a miss that replaced another line"},
};

inline constexpr std::string_view kTexelCacheKeys[] = {
    "height", "cache_line_bits", "cache_set_bits", "cache_ways", "cache_replacement"};

/// The figures are those of hits. A miss holds the unit until its line is there; the sheet has the
/// recurrence.
inline constexpr UnitDesc kTexelCacheDesc = {
    "texel_cache",
    "no paper's: at the map reads of Gumhold and Huettner 1999, figure 3, and of Doggett and "
    "Hirche 2000, figure 8",
    kTexelCachePorts,
    kTexelCacheKeys,
    1,  // latency
    1,  // interval
    1,  // capacity
    0,  // backward latency
};

}  // namespace repousse
