// Figure 19 of Gumhold and Huettner: what a coarse grid leaves of a relief, with filter levels and
// without, and what levels finer than the footprint cost and give.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "testbench/study/figure_panels.h"
#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"
#include "testbench/study/relief.h"

namespace repousse::study {
namespace {

using host::Picture;

constexpr int kReduced = 3;         // pixels of the run to a pixel of the document's picture
constexpr double kMostLost = 50.0;  // per cent of what the unfiltered grid loses: the aim
constexpr double kMostMoved = 2.0;  // per cent of a peak's height: the aim for the best filter

int most_reads(int finer) {
    const int places = (1 << finer) + 1;
    return places * places;
}

std::string cells(const PeaksKept& kept) {
    return fmt::format(" {:.1f} % | {:.1f} % | {:.1f} % | {:.1f} % |", 100 * kept.mean,
                       100 * kept.least, 100 * kept.most, 100 * kept.lost);
}

std::string table(const Relief& relief) {
    std::string text =
        "| surface | triangles | reads a vertex | relief peaks kept: mean | least | most | lost | "
        "silhouette peaks kept: mean | least | most | lost "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < kReliefVariants; ++i) {
        const ReliefRow& row = relief.rows[i];
        text += fmt::format("| {} | {} | {:.2f} |{}{}\n", kReliefWays[i].name,
                            grouped(row.surface.triangles()), row.reads(), cells(row.relief),
                            cells(row.silhouette));
    }
    return text + "\n";
}

/// A figure of the relief and of its silhouette, in per cent.
struct Pair {
    double relief = 0.0, silhouette = 0.0;

    double worse() const { return std::max(relief, silhouette); }
};

/// What variational levels that much finer lose of what the unfiltered grid loses.
Pair lost_percent(const Relief& relief, std::size_t finer) {
    const ReliefRow& filtered = relief.rows[kVariational + finer];
    const ReliefRow& unfiltered = relief.rows[kUnfiltered];
    const auto part = [](const PeaksKept& a, const PeaksKept& b) {
        return b.lost > 0.0 ? 100.0 * a.lost / b.lost : 0.0;
    };
    return {part(filtered.relief, unfiltered.relief),
            part(filtered.silhouette, unfiltered.silhouette)};
}

/// How far box maxima that much finer move the single peak that they move most.
Pair moved_percent(const Relief& relief, std::size_t finer) {
    const ReliefRow& row = relief.rows[kBox + finer];
    const auto most = [](const PeaksKept& k) {
        return 100.0 * std::max(std::fabs(k.least - 1.0), std::fabs(k.most - 1.0));
    };
    return {most(row.relief), most(row.silhouette)};
}

std::string section(const Relief& relief) {
    std::string text =
        "### " + relief.run.scene.title + "\n\n" +
        paragraph(fmt::format(
            "{}, {} x {} texels; 20 px are {} of them. {} relief peaks, {} on the silhouette.",
            relief.run.source(0), relief.run.map(0).width, relief.run.map(0).height,
            relief.unit_texels, relief.relief_peaks, relief.silhouette_peaks)) +
        table(relief) +
        "| levels finer | reads a vertex, at most | mean | variational levels lose, of the "
        "unfiltered grid's loss: relief | silhouette | box maxima move a single peak by at most: "
        "relief | silhouette |\n|---|---|---|---|---|---|---|\n";
    for (std::size_t finer = 0; finer <= kMostFiner; ++finer) {
        const Pair lost = lost_percent(relief, finer), moved = moved_percent(relief, finer);
        text += fmt::format("| {} | {} | {:.2f} | {:.1f} % | {:.1f} % | {:.1f} % | {:.1f} % |\n",
                            finer, most_reads(static_cast<int>(finer)),
                            relief.rows[kVariational + finer].reads(), lost.relief, lost.silhouette,
                            moved.relief, moved.silhouette);
    }
    return text + "\n";
}

/// The worst of all maps, of their reliefs and silhouettes.
template <class Percent>
double worst(const std::vector<Relief>& reliefs, std::size_t finer, Percent&& percent) {
    double most = 0.0;
    for (const Relief& relief : reliefs) most = std::max(most, percent(relief, finer).worse());
    return most;
}

/// "with `finer` = N": the least that keeps a limit on all maps.
template <class Percent>
std::optional<std::size_t> least_finer(const std::vector<Relief>& reliefs, double limit,
                                       Percent&& percent) {
    for (std::size_t finer = 0; finer <= kMostFiner; ++finer) {
        if (worst(reliefs, finer, percent) <= limit) return finer;
    }
    return std::nullopt;
}

std::string reads_of(const std::vector<Relief>& reliefs, std::size_t finer) {
    double least = 1e9, most = 0.0;
    for (const Relief& relief : reliefs) {
        least = std::min(least, relief.rows[kVariational + finer].reads());
        most = std::max(most, relief.rows[kVariational + finer].reads());
    }
    return fmt::format("{:.1f} to {:.1f} reads a vertex, at most {}", least, most,
                       most_reads(static_cast<int>(finer)));
}

std::string verdict(const std::vector<Relief>& reliefs) {
    const auto met = least_finer(reliefs, kMostLost, lost_percent);
    const auto kept = least_finer(reliefs, kMostMoved, moved_percent);
    std::string text =
        "### What finer levels cost and give\n\n" +
        paragraph(fmt::format(
            "The paper's way, where a vertex reads two by two texels (`finer` = 0; {}), loses at "
            "worst {:.1f} % of what the unfiltered grid loses, over both maps, reliefs and "
            "silhouettes. {}",
            reads_of(reliefs, 0), worst(reliefs, 0, lost_percent),
            met ? fmt::format("At most half was the aim: it is met everywhere with `finer` = {} "
                              "({}), which loses at worst {:.1f} %.",
                              *met, reads_of(reliefs, *met), worst(reliefs, *met, lost_percent))
                : std::string("At most half was the aim, which no `finer` meets everywhere.")));
    if (!met || *met > 0) {
        text += paragraph(
            "Peaks of a texel or two are narrower than a level's texels and hold so little volume "
            "that the variational filter, which minimises volume and not the loss of peaks, leaves "
            "its surface below them; [filter.md](filter.md) finds the same on levels 3 to 5 of "
            "ETOPO5. Texels of finer levels are narrower, and more of them are read.");
    }
    return text +
           paragraph(kept
                         ? fmt::format("Of the shipped filters the box maximum keeps heights best: "
                                       "every single peak to within {:.0f} % with `finer` = {}, at "
                                       "worst {:.1f} % off; with `finer` = {} at worst {:.1f} %.",
                                       kMostMoved, *kept, worst(reliefs, *kept, moved_percent),
                                       kMostFiner, worst(reliefs, kMostFiner, moved_percent))
                         : fmt::format("The box maximum keeps no `finer`'s single peaks to within "
                                       "{:.0f} %: at best they are {:.1f} % off.",
                                       kMostMoved, worst(reliefs, kMostFiner, moved_percent)));
}

Picture picture(const Relief& relief, std::size_t variant) {
    const host::Scene& scene = relief.run.scene;
    Picture panel =
        shaded(scene, {relief.rows[variant].surface.view}, scene.camera, kReliefViewport);
    if (variant != kFine) draw_skyline(panel, relief.skyline, {0.8, 0.02, 0.02});
    return reduced(panel, kReduced);
}

std::string explanation() {
    return paragraph(
               "Elevations on eight base triangles, remeshed to a grid of one pixel and to grids "
               "of twenty. The filter levels are chosen by the footprint unit; a vertex takes the "
               "mean or the maximum of the level's texels under its footprint, as the table says. "
               "The paper's way is variational levels and the maximum, of a level so coarse that "
               "two by two texels lie under a footprint. With the register `finer` it is one or "
               "two levels finer than that, and up to 3 x 3 or 5 x 5 texels are read "
               "([footprint](units/footprint.md)).") +
           paragraph(
               "*Relief peaks* are the ten highest texels that nothing within four coarse grid "
               "units exceeds; a surface keeps the height, above the map's lowest, of its highest "
               "vertex within one grid unit. *Silhouette peaks* are the same on the silhouette of "
               "the map itself (a vertex a texel): the ten highest columns of pixels, in pixels "
               "above the far edge of the plane without relief; fewer where the silhouette has "
               "fewer. More than 100 % is a mountain that a level has raised, or a maximum widened "
               "towards a lower one; *lost* is the mean of what is missing, in which one peak "
               "does not make good for another. A silhouette has few peaks: its figures are those "
               "of this one view. *Reads a vertex* are texels, on average.");
}

/// A row of pictures, one a map.
std::vector<Picture> pictures(const Relief& relief, std::initializer_list<std::size_t> variants) {
    std::vector<Picture> row;
    for (const std::size_t i : variants) row.push_back(picture(relief, i));
    return row;
}

}  // namespace

Result<Figure> figure_19(const FigureOptions& options) {
    Figure figure;
    figure.number = 19;
    figure.text =
        "## Gumhold and Huettner, figure 19: a relief on a grid of 20 pixels\n\n" + explanation();
    std::vector<Relief> reliefs;
    for (const auto& [name, height] : {std::pair{"jacksboro", 0.15}, std::pair{"etopo5", 0.10}}) {
        auto relief = make_relief(options.scenes + "/" + name + ".toml", height, options);
        if (!relief) return relief.error();
        reliefs.push_back(std::move(*relief));
        figure.text += section(reliefs.back());
    }
    figure.text += verdict(reliefs);
    figure.text +=
        "### Pictures\n\n" +
        paragraph(
            "The first map above the second one. Left the grid of one pixel; in the middle "
            "20 px with the paper's filter; right 20 px unfiltered. The red line is the "
            "silhouette of the map itself.") +
        "![fine, filtered, unfiltered](images/figure19.png)\n\n" +
        paragraph(
            "The other filters: average levels, variational levels two finer and their maximum, "
            "and box maximum.") +
        "![average, variational two finer, box maximum](images/figure19_filters.png)\n\n";
    if (!options.draw) return figure;
    std::vector<std::vector<Picture>> rows, more;
    for (const Relief& relief : reliefs) {
        rows.push_back(pictures(relief, {kFine, kVariational, kUnfiltered}));
        more.push_back(pictures(relief, {kAverage, kVariational + 2, kBox}));
    }
    figure.pictures = {{"figure19", panels(rows)}, {"figure19_filters", panels(more)}};
    return figure;
}

}  // namespace repousse::study
