// Figure 11 of Doggett and Hirche: elevations, and displacement maps on other bodies.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "testbench/host/map/procedural_map.h"
#include "testbench/study/figure_panels.h"
#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
namespace {

using host::Picture;

/// Elevations under thresholds that fall from row to row; pictures of the first map.
Status add_terrains(const FigureOptions& options, Figure& figure) {
    constexpr host::Viewport kPanel{310, 176};
    std::string table =
        "| map | normal | height | triangles | vertices | base triangles left whole | rms error (% "
        "of the relief) |\n|---|---|---|---|---|---|---|\n";
    std::string sources;
    std::vector<Picture> above, below;
    for (const char* name : {"volcano", "jacksboro", "etopo5"}) {
        auto run = SceneRun::open(options.scenes + "/" + name + ".toml");
        if (!run) return run.error();
        sources += fmt::format("{}{} from {}", sources.empty() ? "" : ", ", run->scene.title,
                               run->source(0));
        run->scene.viewport = kPanel;
        host::AdaptiveSettings& s = run->scene.objects[0].adaptive;
        s.view_threshold_px.reset();
        const double normal = *s.normal_threshold, height = *s.height_threshold;
        for (const double times : {8.0, 4.0, 2.0, 1.0}) {
            options.progress(fmt::format("figure 11, {}, thresholds x {:.0f}", name, times));
            s.normal_threshold = std::min(2.0, normal * times);
            s.height_threshold = height * times;
            const auto surface = run->run(0);
            if (!surface) return surface.error();
            const bool is_shown = std::string(name) == "volcano" && times != 1.0;
            table +=
                fmt::format("| {} | {} | {} | {} | {} of {} | {:.2f} |\n", run->scene.title,
                            tests_of(s), grouped(surface->triangles()),
                            grouped(surface->vertices()), grouped(surface->whole),
                            grouped(surface->base_triangles), error_percent(*run, surface->view));
            if (!options.draw || !is_shown) continue;
            above.push_back(shaded(run->scene, {surface->view}, run->scene.camera, kPanel));
            below.push_back(wireframe({surface->view}, run->scene.camera, kPanel));
        }
    }
    figure.text +=
        paragraph(fmt::format(
            "In the place of Crater Lake: {}. From left to right the thresholds of the table's "
            "first three rows. What is level stays as coarse as the base mesh: *left whole* "
            "counts its triangles that no test split. The view test is off.",
            sources)) +
        table + "\n![Maunga Whau, shaded and wireframe](images/figure11_terrain.png)\n\n";
    if (options.draw) figure.pictures.push_back({"figure11_terrain", panels({above, below})});
    return done();
}

/// The half donut on a ball, and on a plane with finer detail added to it.
Status add_donuts(const FigureOptions& options, Figure& figure) {
    constexpr host::Viewport kPanel{310, 250};
    auto scene = host::read_scene(options.scenes + "/donut.toml");
    if (!scene) return scene.error();
    auto plane = SceneRun::load(*scene);
    if (!plane) return plane.error();
    host::MeshSource& mesh = scene->objects[0].mesh;
    mesh.kind = host::MeshKind::Icosphere;
    mesh.radius = 0.5;
    scene->objects[0].map.wrap = true;
    scene->camera.eye = {-2.20, -0.55, 0.80};
    scene->camera.target = {0.0, 0.0, 0.0};
    scene->camera.fov_deg = 32.0;
    auto ball = SceneRun::load(std::move(*scene));
    if (!ball) return ball.error();
    // A second displacement, added in the map: a sixth of the donut's height.
    host::FbmSettings detail;
    detail.seed = 4;
    detail.cells_x = detail.cells_y = 10;
    detail.octaves = 2;
    host::HeightMap& map = plane->map(0);
    const host::HeightMap bumps = host::make_fbm_map(map.width, map.height, detail);
    for (std::size_t i = 0; i < map.texels.size(); ++i) {
        map.texels[i] = static_cast<std::uint16_t>((6 * map.texels[i] + bumps.texels[i]) / 7);
    }
    plane->scene.camera.fov_deg = 37.0;
    std::string table =
        "| panels | surface | base triangles | triangles | vertices |\n"
        "|---|---|---|---|---|\n";
    std::vector<Picture> row;
    for (SceneRun* run : {&*ball, &*plane}) {
        const bool is_ball = run == &*ball;
        options.progress(is_ball ? "figure 11, ball" : "figure 11, detail");
        run->scene.viewport = kPanel;
        const auto surface = run->run(0);
        if (!surface) return surface.error();
        table +=
            fmt::format("| {} | {} | {} | {} | {} |\n", is_ball ? "left" : "right",
                        is_ball ? "ball" : "plane, detail added", grouped(surface->base_triangles),
                        grouped(surface->triangles()), grouped(surface->vertices()));
        if (!options.draw) continue;
        row.push_back(shaded(run->scene, {surface->view}, run->scene.camera, kPanel));
        row.push_back(wireframe({surface->view}, run->scene.camera, kPanel));
    }
    figure.text +=
        paragraph(
            "In the place of the teapot: the half donut on a ball of icosahedral triangles, whose "
            "texture seam lies behind it. The paper's third panel displaces a displaced mesh once "
            "more, which neither its hardware nor this one does; here the second displacement is "
            "added to the first in the map.") +
        table + "\n![ball and plane](images/figure11_donut.png)\n\n";
    if (options.draw) figure.pictures.push_back({"figure11_donut", panels({row})});
    return done();
}

}  // namespace

Result<Figure> figure_11(const FigureOptions& options) {
    Figure figure;
    figure.number = 11;
    figure.text =
        "## Doggett and Hirche, figure 11: elevations, and the half donut on another body\n\n";
    if (const Status s = add_terrains(options, figure); !s) return s.error();
    if (const Status s = add_donuts(options, figure); !s) return s.error();
    return figure;
}

}  // namespace repousse::study
