#include "testbench/study/cache.h"

#include <cmath>
#include <list>
#include <unordered_map>

#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

bool same(const CacheShape& a, const CacheShape& b) {
    return a.line_bits == b.line_bits && a.set_bits == b.set_bits && a.ways == b.ways &&
           a.replacement == b.replacement;
}

}  // namespace

double CacheResult::hit_rate() const {
    return 100.0 * static_cast<double>(counters.hits) / static_cast<double>(counters.reads());
}

const CacheResult* CacheUnit::at(int size_bits, int line_bits, int ways,
                                 CacheReplacement replacement) const {
    const auto shape = shape_of(size_bits, line_bits, ways, replacement);
    for (const CacheResult& result : results) {
        if (shape && same(result.shape, *shape)) return &result;
    }
    return nullptr;
}

uint32_t CacheUnit::knee() const {
    const auto hit_rate = [this](int size_bits) {
        const CacheResult* result = at(size_bits, 3, 4, CacheReplacement::LeastRecent);
        return result == nullptr ? 0 : result->hit_rate();
    };
    int bits = kMostCacheBits;
    while (bits > kLeastCacheBits && hit_rate(bits - 1) >= hit_rate(kMostCacheBits) - 1) --bits;
    return uint32_t{1} << bits;
}

std::optional<CacheShape> shape_of(int size_bits, int line_bits, int ways,
                                   CacheReplacement replacement) {
    const int way_bits = static_cast<int>(std::lround(std::log2(ways)));
    const int set_bits = size_bits - line_bits - way_bits;
    if (set_bits < 0) return std::nullopt;
    return CacheShape{line_bits, set_bits, ways, replacement};
}

std::vector<CacheShape> cache_shapes() {
    std::vector<CacheShape> shapes;
    for (int size = kLeastCacheBits; size <= kMostCacheBits; ++size) {
        for (const int line : CacheReport::kLineBits) {
            for (const int ways : {1, 2, 4}) {
                for (const CacheReplacement replacement :
                     {CacheReplacement::Oldest, CacheReplacement::LeastRecent}) {
                    const auto shape = shape_of(size, line, ways, replacement);
                    if (shape) shapes.push_back(*shape);
                }
            }
        }
    }
    return shapes;
}

TexelCacheCounters through_cache(const CacheShape& shape, const UnitReads& reads) {
    TexelCache cache(shape);
    for (const std::vector<uint32_t>& object : reads.objects) {
        cache.invalidate();
        for (const uint32_t address : object) cache(address);
    }
    return cache.counters();
}

double one_set_hit_rate(int size_bits, const UnitReads& reads) {
    const std::size_t most = std::size_t{1} << (size_bits - 3);
    uint64_t hits = 0;
    for (const std::vector<uint32_t>& object : reads.objects) {
        std::list<uint32_t> lines;  // the one that was read last stands in front
        std::unordered_map<uint32_t, std::list<uint32_t>::iterator> places;
        for (const uint32_t address : object) {
            const uint32_t line = address >> 3;
            const auto found = places.find(line);
            if (found != places.end()) {
                lines.splice(lines.begin(), lines, found->second);
                ++hits;
                continue;
            }
            if (lines.size() == most) {
                places.erase(lines.back());
                lines.pop_back();
            }
            lines.push_front(line);
            places[line] = lines.begin();
        }
    }
    return 100.0 * static_cast<double>(hits) / static_cast<double>(reads.count());
}

CacheScene study_caches(const SceneReads& reads) {
    CacheScene scene{reads.scene, reads.adaptive, reads.eager, reads.source, reads.triangles, {}};
    for (const UnitReads& of_unit : reads.units) {
        CacheUnit unit;
        unit.unit = of_unit.unit;
        unit.reads = of_unit.count();
        for (const char* profile : {"default", "narrow"}) {
            const CacheShape shape = cache_shape(*shipped_profile(profile));
            unit.shipped.push_back({shape, through_cache(shape, of_unit)});
        }
        for (const CacheShape& shape : cache_shapes()) {
            const bool for_knee = shape.line_bits == 3 && shape.ways == 4 &&
                                  shape.replacement == CacheReplacement::LeastRecent;
            if (reads.eager && !for_knee) continue;
            // With one way there is nothing to choose.
            const bool known = shape.ways == 1 && !unit.results.empty() &&
                               shape.replacement == CacheReplacement::LeastRecent;
            unit.results.push_back(
                {shape, known ? unit.results.back().counters : through_cache(shape, of_unit)});
        }
        for (const std::size_t bits : {8U, 11U}) {
            if (!reads.eager)
                unit.one_set[bits] = one_set_hit_rate(static_cast<int>(bits), of_unit);
        }
        scene.units.push_back(std::move(unit));
    }
    return scene;
}

Result<CacheReport> cache_study(const std::string& folder,
                                const std::function<void(const std::string&)>& progress) {
    struct Run {
        const char* scene;
        bool eager;
    };
    CacheReport report;
    for (const Run& run : {Run{"jacksboro", false}, Run{"jacksboro", true}, Run{"head", false},
                           Run{"head", true}, Run{"donut", false}, Run{"donut", true},
                           Run{"head_sweep", false}, Run{"terrain_sweep", false}}) {
        progress(run.scene);
        const auto reads = scene_reads(folder + "/" + run.scene + ".toml", run.eager);
        if (!reads) return reads.error();
        report.scenes.push_back(study_caches(*reads));
    }
    return report;
}

}  // namespace repousse::study
