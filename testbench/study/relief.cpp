#include "testbench/study/relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "testbench/host/map/filter_levels.h"
#include "testbench/host/view/camera.h"

namespace repousse::study {
namespace {

using host::HeightFilter;
using host::LevelFilter;

constexpr std::size_t kPeaks = 10;
// Coarse grid units without anything higher around a peak: a vertex of the coarse grid reads
// texels up to two units away, lines to the next vertex are one more, and a peak may move by one.
constexpr int kApart = 4;

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
    scene->viewport = kReliefViewport;
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

}  // namespace

const std::array<ReliefVariant, kReliefVariants> kReliefWays = {{
    {"grid of 1 px, unfiltered", 1, HeightFilter::Bilinear, std::nullopt},
    {"20 px, unfiltered", kCoarse_px, HeightFilter::Bilinear, std::nullopt},
    {"20 px, average levels, their mean", kCoarse_px, HeightFilter::Average, LevelFilter::Average},
    {"20 px, variational levels, their mean", kCoarse_px, HeightFilter::Average,
     LevelFilter::Variational},
    {"20 px, variational levels, their maximum (paper)", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::Variational, 0},
    {"20 px, variational levels one finer, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::Variational, 1},
    {"20 px, variational levels two finer, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::Variational, 2},
    {"20 px, box maximum levels, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::BoxMaximum, 0},
    {"20 px, box maximum levels one finer, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::BoxMaximum, 1},
    {"20 px, box maximum levels two finer, their maximum", kCoarse_px, HeightFilter::Maximum,
     LevelFilter::BoxMaximum, 2},
}};

Result<Relief> make_relief(const std::string& scene_file, double height,
                           const FigureOptions& options) {
    auto run = open_relief(scene_file, height);
    if (!run) return run.error();
    Relief relief{std::move(*run), {}, {}, 0, 0, 0};
    host::Object& object = relief.run.scene.objects[0];
    const host::CameraSettings& camera = relief.run.scene.camera;
    const host::HeightMap& map = relief.run.map(0);
    const auto view = host::view_projection(camera, kReliefViewport);
    const glm::dvec2 texel = object.mesh.size / glm::dvec2(map.width - 1, map.height - 1);
    const double unit = kCoarse_px * glm::distance(camera.eye, camera.target) /
                        host::view_frame(camera, kReliefViewport).focal.x;
    relief.unit_texels = static_cast<int>(std::ceil(unit / texel.x));
    relief.skyline = skyline(surface_of(map, texel), view, kReliefViewport);
    // Heights on the silhouette are above the far edge of the plane without relief.
    host::RenderMesh base;
    base.positions = relief.run.mesh(0).positions;
    base.triangles = relief.run.mesh(0).triangles;
    const auto edge = skyline(base, view, kReliefViewport);
    const std::vector<double> ground(edge.size(), *std::max_element(edge.begin(), edge.end()));
    const auto on_silhouette = peaks_of(relief.skyline, ground, kApart * kCoarse_px, kPeaks);
    const auto on_map = peaks_of(map, kApart * relief.unit_texels, kPeaks);
    relief.silhouette_peaks = on_silhouette.size();
    relief.relief_peaks = on_map.size();
    for (const ReliefVariant& variant : kReliefWays) {
        options.progress(fmt::format("figure 19, {}: {}", relief.run.scene.title, variant.name));
        object.sweep.coarseness_px = variant.coarseness_px;
        object.map.filter = variant.filter;
        object.map.levels = variant.levels;
        object.map.finer_levels = variant.finer;
        auto surface = relief.run.run(0);
        if (!surface) return surface.error();
        ReliefRow row{std::move(*surface), {}, {}};
        row.silhouette = kept(on_silhouette, skyline(row.surface.view, view, kReliefViewport),
                              ground, kCoarse_px);
        row.relief = kept(on_map, row.surface.view, texel, map, relief.unit_texels);
        relief.rows.push_back(std::move(row));
    }
    return relief;
}

}  // namespace repousse::study
