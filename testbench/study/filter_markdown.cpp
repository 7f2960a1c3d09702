#include <algorithm>

#include <fmt/format.h>

#include "testbench/study/filter.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
namespace {

std::string introduction() {
    return "# Filter levels: what the variational filter wins\n\n" +
           paragraph(
               "Made by `repousse study filter -o docs/filter.md` (after `scenes/fetch.sh`); no "
               "figure in it is typed by hand. Times are not in it: the command prints them, and "
               "`make bench` measures them.") +
           paragraph(
               "A filter level replaces blocks of 2^k x 2^k texels by one vertex each. Gumhold and "
               "Huettner (section 4.2) start from the average of each block and lower the "
               "*difference volume*, which is what lies between the level's surface and the "
               "full-resolution map, by moving all vertices against its derivative until it "
               "converges: \"in most cases reduced to about 70% of the initial value\".") +
           "How it is meant here (`testbench/host/map/level_surface.h`, "
           "`variational_level.h`):\n\n" +
           "- The surface is bilinear between the vertices, as the device's smooth reads are; it "
           "has no diagonal\n  to choose, and mirrored maps have mirrored levels. A vertex stands "
           "at its block's centre, found by\n  a shift of the texel coordinate; outside the "
           "outermost vertices the surface is level.\n" +
           "- The volume is the sum of |surface - map| over the texel centres of the full "
           "resolution.\n" +
           "- The derivative is the paper's equation 12 with an epsilon of 1e-4 of the height "
           "range; a step that\n  does not lower the volume is taken back, then lambda halves from "
           "2^0 on, and epsilon with it.\n\n";
}

std::string method_of_bound() {
    return "## The proof where 70 % is out of reach\n\n" +
           paragraph(
               "The volume is convex in the heights: a sum of absolute values of linear functions, "
               "so its least value is a linear program, min |B z - f|. Each y with |y| <= 1 at "
               "every texel and B'y = 0 proves |B z - f| >= -y f for all heights z. The column "
               "*proven* is the best such y that a primal-dual iteration found "
               "(`testbench/study/volume_bound.h`), *found* the least volume it met on the way: "
               "the "
               "optimum lies between the two. No choice of epsilon, lambda or steps gets below "
               "*proven*; where it is above 70 %, so is every filter of this kind. For ETOPO5 the "
               "iteration ends as soon as 70 % is disproven.");
}

std::string bound_cells(const FilterLevelReport& level) {
    if (!level.bound) return " - | - |";
    return fmt::format(" {:.2f} % | {:.2f} % |",
                       // Rounded down: what is printed is proven too.
                       static_cast<int>(level.least_ratio * 10000) / 100.0,
                       100 * level.found_ratio);
}

std::string volume_table(const FilteredMap& map) {
    std::string text =
        "| level | vertices | average (LSB) | variational | steps | optimum: proven | found | box "
        "maximum |\n|---|---|---|---|---|---|---|---|\n";
    for (const FilterLevelReport& level : map.levels) {
        text +=
            fmt::format("| {} | {} x {} | {:.1f} | **{:.1f} %** | {} |{} {:.0f} % |\n", level.level,
                        level.width, level.height, level.start_lsb, 100 * level.ratio,
                        level.curve.size() - 1, bound_cells(level), 100 * level.maximum_ratio);
    }
    return text + "\n";
}

std::string curve_table(const FilteredMap& map) {
    std::string text =
        "| level | step 1 | 2 | 4 | 8 | 16 | 32 | last |\n|---|---|---|---|---|---|---|---|\n";
    for (const FilterLevelReport& level : map.levels) {
        text += fmt::format("| {} |", level.level);
        for (const std::size_t step : {1, 2, 4, 8, 16, 32}) {
            text += step < level.curve.size() ? fmt::format(" {:.1f} |", 100 * level.curve[step])
                                              : std::string(" |");
        }
        text += level.curve.empty() ? std::string(" |\n")
                                    : fmt::format(" {:.1f} |\n", 100 * level.curve.back());
    }
    return text + "\n";
}

std::string kept_table(const FilteredMap& map) {
    std::string text =
        "| level | peaks: unfiltered | average | variational | box maximum | skyline: unfiltered | "
        "average | variational | box maximum |\n|---|---|---|---|---|---|---|---|---|\n";
    const auto cells = [](const HeightsKept& kept) {
        return fmt::format(" {:.1f} | {:.1f} | {:.1f} | {:.1f} |", 100 * kept.unfiltered,
                           100 * kept.average, 100 * kept.variational, 100 * kept.maximum);
    };
    for (const FilterLevelReport& level : map.levels) {
        text += fmt::format("| {} |{}{}\n", level.level, cells(level.peaks), cells(level.skyline));
    }
    return text + "\n";
}

}  // namespace

std::string filter_markdown(const FilterReport& report, const std::string& figure) {
    std::string text = introduction();
    for (const std::string& file : report.missing) {
        text += paragraph("**Missing: `" + file + "`; `scenes/fetch.sh` gets it.**");
    }
    text += "## Volumes\n\n" +
            paragraph(
                "*Average* is the start's mean |surface - map| in height LSB (1/65535 of the map's "
                "range); the percentages are volumes over the start's. *Variational* is of the "
                "level as stored, rounded to 16 bits.");
    std::size_t reached = 0, disproven = 0, all = 0;
    for (const FilteredMap& map : report.maps) {
        text += fmt::format("### {} ({}, {} x {} texels)\n\n", map.name, map.source, map.width,
                            map.height) +
                volume_table(map);
        for (const FilterLevelReport& level : map.levels) {
            ++all;
            if (level.ratio <= FilterReport::kPromised) ++reached;
            if (level.bound && level.least_ratio > FilterReport::kPromised) ++disproven;
        }
    }
    text += paragraph(fmt::format(
        "Of {} levels, {} come to 70 % of the average's volume or below; of {} others it is proven "
        "that no level can; {} are open.",
        all, reached, disproven, all - reached - disproven));
    text += paragraph(
        "The averaged start wins little where a block is rough by itself: what is left there is "
        "detail that no level of this size can follow, and both surfaces miss it alike. The gain "
        "is large where the map is smooth at the level's scale and the average only blurs it.");
    text += method_of_bound();
    text += "## Curves\n\n![Volume over steps](" + figure + ")\n\n" +
            paragraph("Volume after a step, in per cent of the start's.");
    for (const FilteredMap& map : report.maps)
        text += "### " + map.name + "\n\n" + curve_table(map);
    text += "## Heights kept\n\n" +
            paragraph(
                "Per cent of the original height above h = 0. *Peaks*: the mean over blocks whose "
                "highest texel is above those of the eight blocks around; what a level keeps of it "
                "is the highest of its nine vertices there. *Skyline*: the highest of each column "
                "of blocks, seen along v. *Unfiltered* reads the texel at each block's centre, as "
                "a coarse grid reads a map without levels. The box maximum keeps all by "
                "construction, and pays with several times the average's volume; the "
                "variational level may overshoot a peak, so that the surface around it fits.");
    for (const FilteredMap& map : report.maps) text += "### " + map.name + "\n\n" + kept_table(map);
    while (text.size() > 1 && text[text.size() - 2] == '\n') text.pop_back();
    return text;
}

}  // namespace repousse::study
