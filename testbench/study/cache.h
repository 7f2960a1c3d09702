#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/units/texel_cache.h"
#include "testbench/study/read_trace.h"

namespace repousse::study {

/// What one cache made of a unit's reads.
struct CacheResult {
    CacheShape shape;
    TexelCacheCounters counters;

    /// Per cent.
    double hit_rate() const;
    /// Words fetched from memory: a line a miss.
    uint64_t fetched() const { return counters.misses << shape.line_bits; }
};

/// The sizes of the caches: 16 words to 64 K words.
inline constexpr int kLeastCacheBits = 4, kMostCacheBits = 16;

/// One unit of one scene, in front of many caches.
struct CacheUnit {
    std::string unit;
    uint64_t reads = 0;
    std::vector<CacheResult> shipped;  ///< the shapes of `default` and of `narrow`
    std::vector<CacheResult> results;  ///< of cache_shapes(); eager: of those that knee() asks for
    /// Per cent of hits in one set of all lines, least recently used, lines of 8 words, by the
    /// logarithm of the words; 0 where it was not asked for.
    std::array<double, kMostCacheBits + 1> one_set{};

    /// The result of one of cache_shapes(), by what shape_of() asks for; null: there is none.
    const CacheResult* at(int size_bits, int line_bits, int ways,
                          CacheReplacement replacement) const;
    /// The fewest words, in 4 ways of lines of 8 with the least recently used one replaced, that
    /// hit within one per cent of the reads as often as the most.
    uint32_t knee() const;
};

/// One scene in one of its modes.
struct CacheScene {
    std::string scene;
    bool adaptive = false;
    bool eager = false;
    std::string source;  ///< of its map
    uint64_t triangles = 0;
    std::vector<CacheUnit> units;

    double per_triangle(uint64_t count) const {
        return static_cast<double>(count) / static_cast<double>(triangles);
    }
};

struct CacheReport {
    static constexpr std::array kLineBits = {0, 2, 3, 4};
    std::vector<CacheScene> scenes;
};

/// Caches of 16 to 64 K words, with lines of 1, 4, 8 and 16 words, 1, 2 and 4 ways and both
/// replacements: as many of these as have a set.
std::vector<CacheShape> cache_shapes();

/// The shape with 2^size_bits words; none if they are fewer than a set's.
std::optional<CacheShape> shape_of(int size_bits, int line_bits, int ways,
                                   CacheReplacement replacement);

/// A unit's reads through a cache that is empty when an object begins.
TexelCacheCounters through_cache(const CacheShape& shape, const UnitReads& reads);

/// Hits, per cent, of one set with room for 2^size_bits words in lines of 8, where the least
/// recently used line is replaced: what is lost against it is lost to conflicts.
double one_set_hit_rate(int size_bits, const UnitReads& reads);

/// A scene's reads through all the caches.
CacheScene study_caches(const SceneReads& reads);

/// The scenes jacksboro, head and donut (skipping and eager), head_sweep and terrain_sweep from
/// `folder`. About a minute; the same inputs give the same report. Errors: those of the scenes.
Result<CacheReport> cache_study(const std::string& folder,
                                const std::function<void(const std::string&)>& progress);

/// The report as docs/cache.md, whose figure stands in `figure`.
std::string cache_markdown(const CacheReport& report, const std::string& figure);

/// Hit rates over the size of the cache as an SVG picture.
std::string cache_figure(const CacheReport& report);

}  // namespace repousse::study
