#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "testbench/study/cache.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
namespace {

constexpr auto kLru = CacheReplacement::LeastRecent;
constexpr auto kOldest = CacheReplacement::Oldest;

std::string introduction() {
    return "# Texel caches: hits, and reads a triangle\n\n" +
           paragraph(
               "Made by `repousse study cache -o docs/cache.md` (after `scenes/fetch.sh`); no "
               "figure in it is typed by hand. Each scene runs once through the bare units, "
               "bit-accurate; what the units read is recorded, and the record goes through all "
               "caches ([texel_cache](units/texel_cache.md)).") +
           paragraph(
               "Hits depend on the order of the reads, so the order is part of the architecture. "
               "Adaptive tessellation: one context, depth first; of a base triangle first the "
               "corners, then of every triangle the edges 12, 23, 31, as far as a unit works on "
               "them. Sweep-line remeshing: the vertices as the sweep line makes them, base "
               "triangle by base triangle. Within a vertex the texels come row by row; the "
               "summed-area table's entries come corner by corner, of each the boxes around U1, "
               "U2, U12. Each unit has a cache of its own, and each object begins with empty ones. "
               "How a simulation cuts its work into batches makes no difference "
               "(`cache_study_test`).");
}

std::string mode_of(const CacheScene& scene) {
    return !scene.adaptive ? "sweep" : scene.eager ? "eager" : "skipping";
}

/// The beginning of a row: scene, mode and unit.
std::string head_of(const CacheScene& scene, const CacheUnit& unit) {
    return fmt::format("| {} | {} | `{}` |", scene.scene, mode_of(scene), unit.unit);
}

std::string sources(const CacheReport& report) {
    std::string text = "Maps:";
    for (const CacheScene& scene : report.scenes) {
        if (scene.eager) continue;
        text += fmt::format(" {} reads {};", scene.scene, scene.source);
    }
    text.back() = '.';
    return paragraph(text);
}

std::string reads_table(const CacheReport& report) {
    std::string text =
        "## Reads, and the shipped caches\n\n" +
        paragraph(
            "`default`: 2,048 words, 4 ways of lines of 8, least recently used. `narrow`: 256 "
            "words, 2 ways of lines of 4, oldest. *Fetched* are words that come from memory for "
            "the cache of `default`: a whole line a miss. *Knee*: the fewest words, in 4 ways of "
            "lines of 8, that hit within one per cent of the reads as often as 64 K words.") +
        "| scene | tests | unit | triangles | reads | a triangle | hits, `default` | fetched a "
        "triangle | hits, `narrow` | knee, words |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const CacheScene& scene : report.scenes) {
        for (const CacheUnit& unit : scene.units) {
            text += head_of(scene, unit) +
                    fmt::format(" {} | {} | {:.2f} | {:.2f} % | {:.2f} | {:.2f} % | {} |\n",
                                scene.triangles, unit.reads, scene.per_triangle(unit.reads),
                                unit.shipped[0].hit_rate(),
                                scene.per_triangle(unit.shipped[0].fetched()),
                                unit.shipped[1].hit_rate(), unit.knee());
        }
    }
    return text + "\n";
}

/// A table of hit rates with a column a cache, for each unit of each scene that skips. No ways: one
/// set of all lines.
struct Column {
    std::string name;
    int size_bits, line_bits, ways;
    CacheReplacement replacement;
};

std::string cell(const CacheUnit& unit, const Column& c) {
    if (c.ways == 0) {
        return fmt::format(" {:.1f} |", unit.one_set[static_cast<std::size_t>(c.size_bits)]);
    }
    const CacheResult* result = unit.at(c.size_bits, c.line_bits, c.ways, c.replacement);
    return result == nullptr ? std::string(" |") : fmt::format(" {:.1f} |", result->hit_rate());
}

std::string table(const CacheReport& report, const std::vector<Column>& columns) {
    std::string text = "| scene | tests | unit |";
    std::string rule = "\n|---|---|---|";
    for (const Column& column : columns) {
        text += ' ' + column.name + " |";
        rule += "---|";
    }
    text += rule + '\n';
    for (const CacheScene& scene : report.scenes) {
        if (scene.eager) continue;
        for (const CacheUnit& unit : scene.units) {
            text += head_of(scene, unit);
            for (const Column& column : columns) text += cell(unit, column);
            text += '\n';
        }
    }
    return text + "\n";
}

std::string size_name(int bits) {
    return bits < 10 ? std::to_string(1 << bits) : fmt::format("{} K", 1 << (bits - 10));
}

std::string size_table(const CacheReport& report) {
    std::vector<Column> columns;
    for (const int bits : {5, 6, 7, 8, 9, 10, 11, 12, 14, 16}) {
        columns.push_back({size_name(bits), bits, 3, 4, kLru});
    }
    return "## Size\n\n" +
           paragraph("Hits, per cent, over words; 4 ways of lines of 8, least recently used.") +
           table(report, columns);
}

std::string line_table(const CacheReport& report) {
    std::vector<Column> columns;
    for (const int size : {8, 11}) {
        for (const int line : CacheReport::kLineBits) {
            columns.push_back(
                {fmt::format("{}: {}", size_name(size), 1 << line), size, line, 4, kLru});
        }
    }
    return "## Lines\n\n" +
           paragraph(
               "Hits, per cent, with lines of 1, 4, 8 and 16 words, in 256 words and in 2 K; 4 "
               "ways, least recently used.") +
           table(report, columns);
}

std::string ways_table(const CacheReport& report) {
    std::vector<Column> columns;
    for (const int size : {8, 11}) {
        const std::string words = size_name(size);
        columns.push_back({words + ": 1 way", size, 3, 1, kLru});
        columns.push_back({"2, oldest", size, 3, 2, kOldest});
        columns.push_back({"2, least recent", size, 3, 2, kLru});
        columns.push_back({"4, oldest", size, 3, 4, kOldest});
        columns.push_back({"4, least recent", size, 3, 4, kLru});
        columns.push_back({"all", size, 3, 0, kLru});
    }
    return "## Ways and replacement\n\n" +
           paragraph(
               "Hits, per cent, in 256 words and in 2 K; lines of 8. *All*: one set, the least "
               "recently used of all lines is replaced; no such cache is built, it shows what "
               "conflicts cost.") +
           table(report, columns);
}

/// A unit of a scene, for the prose; an empty one if the report is of other scenes.
struct Cited {
    double reads = 0, fetched = 0;  ///< a triangle; fetched by the cache of `default`
    CacheUnit unit;

    double hits(int size_bits, int line_bits = 3) const {
        const CacheResult* result = unit.at(size_bits, line_bits, 4, kLru);
        return result == nullptr ? 0 : result->hit_rate();
    }
};

Cited cite(const CacheReport& report, const std::string& scene, bool eager,
           const std::string& name) {
    for (const CacheScene& s : report.scenes) {
        if (s.scene != scene || s.eager != eager) continue;
        for (const CacheUnit& u : s.units) {
            if (u.unit != name) continue;
            return {s.per_triangle(u.reads), s.per_triangle(u.shipped[0].fetched()), u};
        }
    }
    return {};
}

/// The largest difference that the replacement makes in the last table.
double most_by_replacement(const CacheReport& report) {
    double most = 0;
    for (const CacheScene& scene : report.scenes) {
        for (const CacheUnit& unit : scene.units) {
            for (const int size : {8, 11}) {
                for (const int ways : {2, 4}) {
                    const CacheResult* oldest = unit.at(size, 3, ways, kOldest);
                    const CacheResult* recent = unit.at(size, 3, ways, kLru);
                    if (oldest == nullptr || recent == nullptr) continue;
                    most = std::max(most, std::abs(oldest->hit_rate() - recent->hit_rate()));
                }
            }
        }
    }
    return most;
}

std::string findings(const CacheReport& report) {
    const Cited head_sweep = cite(report, "head_sweep", false, "displace");
    const Cited head_sweep_bump = cite(report, "head_sweep", false, "bump");
    const Cited terrain = cite(report, "terrain_sweep", false, "displace");
    const Cited jacksboro = cite(report, "jacksboro", false, "displace");
    const Cited jacksboro_tests = cite(report, "jacksboro", false, "height_test");
    const Cited jacksboro_eager = cite(report, "jacksboro", true, "height_test");
    const Cited head = cite(report, "head", false, "displace");
    const Cited head_tests = cite(report, "head", false, "height_test");
    const Cited head_eager = cite(report, "head", true, "height_test");
    return "## What it shows\n\n" +
           paragraph(fmt::format(
               "Sweep-line remeshing reads {:.2f} texels a triangle for `displace`: four a vertex, "
               "and two triangles a vertex. What neighbours along the sweep line share, a few "
               "lines hold: 32 words hit {:.1f} % in head_sweep and {:.1f} % in terrain_sweep. "
               "What they share with the sweep line before needs more, {} and {} words, which are "
               "the knees; in terrain_sweep half of that leaves {:.1f} % and a quarter {:.1f} %. "
               "Beyond the knee little is left to win ({:.1f} and {:.1f} % in 64 K words). `bump` "
               "reads one texel a vertex and seldom the same one again: in 2 K words lines of 1, "
               "4, 8 and 16 words hit {:.1f}, {:.1f}, {:.1f} and {:.1f} %; the length of the line "
               "decides, not the size.",
               head_sweep.reads, head_sweep.hits(5), terrain.hits(5), head_sweep.unit.knee(),
               terrain.unit.knee(), terrain.hits(10), terrain.hits(9), head_sweep.hits(16),
               terrain.hits(16), head_sweep_bump.hits(11, 0), head_sweep_bump.hits(11, 2),
               head_sweep_bump.hits(11, 3), head_sweep_bump.hits(11, 4))) +
           paragraph(fmt::format(
               "Adaptive tessellation displaces a new vertex once for each of the two triangles at "
               "its edge: {:.2f} reads a triangle in jacksboro. Depth first the reads stay close, "
               "and {} words are the knee of its `displace`. In head the knee is {} words, because "
               "of conflicts: a row of its map has 512 texels, so texels above each other share "
               "few sets. 2 K words hit {:.1f} % there, as one set they would hit {:.1f} %; rows "
               "whose length is no power of two (jacksboro: 403 texels) show no such loss. Which "
               "line is replaced makes {:.1f} per cent of the reads at most (last table). Eager "
               "tests read {:.1f} times as much for `height_test` in jacksboro and {:.1f} times in "
               "head; the cache of "
               "`default` keeps most of that from memory: {:.2f} words fetched a triangle become "
               "{:.2f}, and {:.2f} become {:.2f}.",
               jacksboro.reads, jacksboro.unit.knee(), head.unit.knee(), head.hits(11),
               head.unit.one_set[11], most_by_replacement(report),
               jacksboro_eager.reads / jacksboro_tests.reads, head_eager.reads / head_tests.reads,
               jacksboro_tests.fetched, jacksboro_eager.fetched, head_tests.fetched,
               head_eager.fetched));
}

}  // namespace

std::string cache_markdown(const CacheReport& report, const std::string& figure) {
    return introduction() + sources(report) + "![Hit rate over the size of the cache](" + figure +
           ")\n\n" + findings(report) + reads_table(report) + size_table(report) +
           line_table(report) + ways_table(report);
}

}  // namespace repousse::study
