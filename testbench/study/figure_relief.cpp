// Figure 19 of Gumhold and Huettner: what a coarse grid leaves of a relief, with filter levels and
// without.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/view/camera.h"
#include "testbench/study/figure_panels.h"
#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"
#include "testbench/study/skyline.h"

namespace repousse::study {
namespace {

using host::HeightFilter;
using host::LevelFilter;
using host::Picture;

constexpr host::Viewport kViewport{1260, 264};
constexpr int kCoarse_px = 20;
constexpr std::size_t kPeaks = 10;
// Coarse grid units without anything higher around a peak: a vertex of the coarse grid reads
// texels up to two units away, lines to the next vertex are one more, and a peak may move by one.
constexpr int kApart = 4;
constexpr int kReduced = 3;  // pixels of the run to a pixel of the document's picture

/// A way to make the surface.
struct Variant {
    const char* name;
    double coarseness_px;
    HeightFilter filter;
    std::optional<LevelFilter> levels;
};

enum : std::size_t { kFine, kUnfiltered, kAverage, kMean, kPaper, kBest, kVariantCount };
constexpr std::array<Variant, kVariantCount> kVariants = {{
    {"grid of 1 px, unfiltered", 1, HeightFilter::Bilinear, std::nullopt},
    {"20 px, unfiltered", kCoarse_px, HeightFilter::Bilinear, std::nullopt},
    {"20 px, average levels, their mean", kCoarse_px, HeightFilter::Average, LevelFilter::Average},
    {"20 px, variational levels, their mean", kCoarse_px, HeightFilter::Average,
     LevelFilter::Variational},
    {"20 px, variational levels, their maximum (paper)", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::Variational},
    {"20 px, box maximum levels, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::BoxMaximum},
}};

/// A relief on eight base triangles, seen from low in the south through a long lens, so that near
/// and far mountains are of one scale and a mountain that moves back does not rise.
Result<SceneRun> open_relief(const std::string& scene_file, double height) {
    auto scene = host::read_scene(scene_file);
    if (!scene) return scene.error();
    host::Object& object = scene->objects[0];
    object.method = host::Method::Sweep;
    object.bump = false;
    object.mesh.columns = object.mesh.rows = 2;
    object.map.range = {0.0, height};
    const double middle = 0.5 * object.mesh.size.y;
    scene->viewport = kViewport;
    scene->camera.eye = {0.5, middle - 3.3, 0.195};
    scene->camera.target = {0.5, middle, 0.05};
    scene->camera.fov_deg = 4.4;
    scene->view.skirt = scene->view.shadows = false;
    scene->view.shading = host::Shading::Flat;
    scene->view.background = scene->view.horizon = {1.0, 1.0, 1.0};
    return SceneRun::load(std::move(*scene));
}

/// The map itself as a surface: a vertex a texel.
host::RenderMesh surface_of(const host::HeightMap& map, glm::dvec2 texel) {
    host::RenderMesh mesh;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            mesh.positions.emplace_back(x * texel.x, y * texel.y,
                                        map.range_low + map.at(x, y) * map.world_per_lsb());
            if (x == 0 || y == 0) continue;
            const auto d = static_cast<std::uint32_t>(mesh.positions.size() - 1);
            const std::uint32_t c = d - 1, b = d - static_cast<std::uint32_t>(map.width);
            mesh.triangles.push_back({b - 1, b, c});
            mesh.triangles.push_back({b, d, c});
        }
    }
    return mesh;
}

/// What became of a relief's peaks in one surface.
struct ReliefRow {
    RunSurface surface;
    PeaksKept silhouette, relief;
};

struct Relief {
    SceneRun run;
    std::vector<double> skyline;  ///< of the map itself
    std::vector<ReliefRow> rows;  ///< by variant
    std::size_t silhouette_peaks = 0, relief_peaks = 0;
    int unit_texels = 0;  ///< a coarse grid unit in the middle of the relief
};

Result<Relief> make_relief(const std::string& scene_file, double height,
                           const FigureOptions& options) {
    auto run = open_relief(scene_file, height);
    if (!run) return run.error();
    Relief relief{std::move(*run), {}, {}, 0, 0, 0};
    host::Object& object = relief.run.scene.objects[0];
    const host::CameraSettings& camera = relief.run.scene.camera;
    const host::HeightMap& map = relief.run.map(0);
    const auto view = host::view_projection(camera, kViewport);
    const glm::dvec2 texel = object.mesh.size / glm::dvec2(map.width - 1, map.height - 1);
    const double unit = kCoarse_px * glm::distance(camera.eye, camera.target) /
                        host::view_frame(camera, kViewport).focal.x;
    relief.unit_texels = static_cast<int>(std::ceil(unit / texel.x));
    relief.skyline = skyline(surface_of(map, texel), view, kViewport);
    // Heights on the silhouette are above the far edge of the plane without relief.
    host::RenderMesh base;
    base.positions = relief.run.mesh(0).positions;
    base.triangles = relief.run.mesh(0).triangles;
    const auto edge = skyline(base, view, kViewport);
    const std::vector<double> ground(edge.size(), *std::max_element(edge.begin(), edge.end()));
    const auto on_silhouette = peaks_of(relief.skyline, ground, kApart * kCoarse_px, kPeaks);
    const auto on_map = peaks_of(map, kApart * relief.unit_texels, kPeaks);
    relief.silhouette_peaks = on_silhouette.size();
    relief.relief_peaks = on_map.size();
    for (const Variant& variant : kVariants) {
        options.progress(fmt::format("figure 19, {}: {}", relief.run.scene.title, variant.name));
        object.sweep.coarseness_px = variant.coarseness_px;
        object.map.filter = variant.filter;
        object.map.levels = variant.levels;
        auto surface = relief.run.run(0);
        if (!surface) return surface.error();
        ReliefRow row{std::move(*surface), {}, {}};
        row.silhouette =
            kept(on_silhouette, skyline(row.surface.view, view, kViewport), ground, kCoarse_px);
        row.relief = kept(on_map, row.surface.view, texel, map, relief.unit_texels);
        relief.rows.push_back(std::move(row));
    }
    return relief;
}

std::string cells(const PeaksKept& kept) {
    return fmt::format(" {:.1f} % | {:.1f} % | {:.1f} % | {:.1f} % |", 100 * kept.mean,
                       100 * kept.least, 100 * kept.most, 100 * kept.lost);
}

std::string table(const Relief& relief) {
    std::string text =
        "| surface | triangles | relief peaks kept: mean | least | most | lost | silhouette peaks "
        "kept: mean | least | most | lost |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < kVariantCount; ++i) {
        const ReliefRow& row = relief.rows[i];
        text +=
            fmt::format("| {} | {} |{}{}\n", kVariants[i].name, grouped(row.surface.triangles()),
                        cells(row.relief), cells(row.silhouette));
    }
    return text + "\n";
}

/// What `filtered` loses of what `unfiltered` loses.
double lost_percent(const PeaksKept& filtered, const PeaksKept& unfiltered) {
    return unfiltered.lost > 0.0 ? 100.0 * filtered.lost / unfiltered.lost : 0.0;
}

std::string verdict(const Relief& relief) {
    const ReliefRow& best = relief.rows[kBest];
    const ReliefRow& paper = relief.rows[kPaper];
    const ReliefRow& plain = relief.rows[kUnfiltered];
    const double silhouette_lost = lost_percent(paper.silhouette, plain.silhouette);
    std::string text =
        paragraph(fmt::format(
            "{}, {} x {} texels; 20 px are {} of them. {} relief peaks, {} on the silhouette.",
            relief.run.source(0), relief.run.map(0).width, relief.run.map(0).height,
            relief.unit_texels, relief.relief_peaks, relief.silhouette_peaks)) +
        table(relief) +
        paragraph(fmt::format(
            "Box maximum levels keep {:.1f} % of the relief's peaks and {:.1f} % of the "
            "silhouette's. Of what the unfiltered grid loses of them, the paper's way loses "
            "{:.1f} % on the relief and {:.1f} % on the silhouette.",
            100 * best.relief.mean, 100 * best.silhouette.mean,
            lost_percent(paper.relief, plain.relief), silhouette_lost));
    if (silhouette_lost <= 50.0) return text;
    return text +
           paragraph(
               "Half of the loss was the aim; these levels miss it. Peaks of a texel or two are "
               "narrower than a level's texels and hold so little volume that the variational "
               "filter, which minimises volume and not the loss of peaks, leaves its surface "
               "below them; [filter.md](filter.md) finds the same on levels 3 to 5 of ETOPO5. "
               "The box maximum has no such limit.");
}

Picture picture(const Relief& relief, std::size_t variant) {
    const host::Scene& scene = relief.run.scene;
    Picture panel = shaded(scene, {relief.rows[variant].surface.view}, scene.camera, kViewport);
    if (variant != kFine) draw_skyline(panel, relief.skyline, {0.8, 0.02, 0.02});
    return reduced(panel, kReduced);
}

std::string explanation() {
    return paragraph(
               "Elevations on eight base triangles, remeshed to a grid of one pixel and to grids "
               "of twenty. The filter levels are chosen by the footprint unit; a vertex takes the "
               "mean or the maximum of the level's texels under its footprint, as the table says. "
               "The paper's way is variational levels and the maximum.") +
           paragraph(
               "*Relief peaks* are the ten highest texels that nothing within four coarse grid "
               "units exceeds; a surface keeps the height, above the map's lowest, of its highest "
               "vertex within one grid unit. *Silhouette peaks* are the same on the silhouette of "
               "the map itself (a vertex a texel): the ten highest columns of pixels, in pixels "
               "above the far edge of the plane without relief; fewer where the silhouette has "
               "fewer. More than 100 % is a mountain that a level has raised, or a maximum widened "
               "towards a lower one; *lost* is the mean of what is missing, in which one peak "
               "does not make good for another. A silhouette has few peaks: its figures are those "
               "of this one view.");
}

}  // namespace

Result<Figure> figure_19(const FigureOptions& options) {
    Figure figure;
    figure.number = 19;
    figure.text =
        "## Gumhold and Huettner, figure 19: a relief on a grid of 20 pixels\n\n" + explanation();
    std::vector<std::vector<Picture>> rows, more;
    for (const auto& [name, height] : {std::pair{"jacksboro", 0.15}, std::pair{"etopo5", 0.10}}) {
        const auto relief = make_relief(options.scenes + "/" + name + ".toml", height, options);
        if (!relief) return relief.error();
        figure.text += "### " + relief->run.scene.title + "\n\n" + verdict(*relief);
        if (!options.draw) continue;
        const auto pictures = [&](std::initializer_list<std::size_t> variants) {
            std::vector<Picture> row;
            for (const std::size_t i : variants) row.push_back(picture(*relief, i));
            return row;
        };
        rows.push_back(pictures({kFine, kPaper, kUnfiltered}));
        more.push_back(pictures({kAverage, kMean, kBest}));
    }
    figure.text +=
        "### Pictures\n\n" +
        paragraph(
            "The first map above the second one. Left the grid of one pixel; in the middle "
            "20 px with the paper's filter; right 20 px unfiltered. The red line is the "
            "silhouette of the map itself.") +
        "![fine, filtered, unfiltered](images/figure19.png)\n\n" +
        paragraph(
            "The other filters: average levels, the mean of variational levels, and box "
            "maximum.") +
        "![average, variational mean, box maximum](images/figure19_filters.png)\n\n";
    if (options.draw) {
        figure.pictures = {{"figure19", panels(rows)}, {"figure19_filters", panels(more)}};
    }
    return figure;
}

}  // namespace repousse::study
