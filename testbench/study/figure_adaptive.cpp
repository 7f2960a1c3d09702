// The figures of Doggett and Hirche's results (section 4).

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "testbench/host/map/procedural_map.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/view/camera.h"
#include "testbench/reference/leaf_mesh.h"
#include "testbench/study/figure_panels.h"
#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
using host::Picture;

double error_percent(const SceneRun& run, const host::RenderMesh& surface) {
    std::vector<reference::LeafTriangle> leaves(surface.triangles.size());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3& p = surface.positions[surface.triangles[i][k]];
            leaves[i].corners[k].position = {p.x, p.y, p.z};
        }
    }
    const host::HeightMap& map = run.map(0);
    const host::Object& object = run.scene.objects[0];
    const bool centres = object.map.uv == host::UvSpan::Centres;
    const double dx = object.mesh.size.x / (centres ? map.width - 1 : map.width);
    const double dy = object.mesh.size.y / (centres ? map.height - 1 : map.height);
    const double inset = centres ? 0.0 : 0.5;
    const reference::SampleLattice lattice{map.width, map.height, inset * dx, dx, inset * dy, dy};
    const auto expected = [&](int x, int y) {
        return map.range_low + map.at(x, y) * map.world_per_lsb();
    };
    const double relief = map.range_high - map.range_low;
    return 100.0 * reference::height_error(leaves, lattice, expected).rms / relief;
}

std::string tests_of(const host::AdaptiveSettings& s) {
    const std::string normal =
        s.normal_threshold ? fmt::format("{:.2f}", *s.normal_threshold) : "-";
    const std::string height =
        s.height_threshold ? fmt::format("{:.0f} LSB", *s.height_threshold) : "-";
    return fmt::format("{} | {}", normal, height);
}

Result<Figure> figure_9(const FigureOptions& options) {
    constexpr host::Viewport kPanel{280, 300};
    auto run = SceneRun::open(options.scenes + "/head.toml");
    if (!run) return run.error();
    host::CameraSettings scene_camera = run->scene.camera;
    scene_camera.fov_deg = 47.0;
    host::CameraSettings face = scene_camera;  // the region around the nose, eyes and mouth
    face.eye = {-0.42, -1.75, 1.12};
    face.target = {0.0, -0.30, 0.98};
    face.fov_deg = 30.0;
    run->scene.viewport = kPanel;
    std::string table =
        "| panels | distance | base mesh height (px) | triangles | vertices | base triangles left "
        "whole |\n|---|---|---|---|---|---|\n";
    std::vector<Picture> above, below;
    const double distance = glm::length(scene_camera.eye - scene_camera.target);
    const double base_height = run->scene.objects[0].mesh.height;
    for (int i = 0; i < 3; ++i) {
        const double times = std::array{1.0, 2.5, 6.0}[static_cast<std::size_t>(i)];
        run->scene.camera = farther(scene_camera, times);
        options.progress(fmt::format("figure 9, distance {:.1f}", distance * times));
        const auto surface = run->run(0);
        if (!surface) return surface.error();
        const double focal = host::view_frame(run->scene.camera, kPanel).focal.x;
        table += fmt::format("| {}, {} | {:.2f} | {:.0f} | {} | {} | {} of {} |\n", "abc"[i],
                             "def"[i], distance * times, base_height * focal / (distance * times),
                             grouped(surface->triangles()), grouped(surface->vertices()),
                             grouped(surface->whole), grouped(surface->base_triangles));
        if (!options.draw) continue;
        above.push_back(shaded(run->scene, {surface->view}, run->scene.camera, kPanel));
        below.push_back(wireframe({surface->view}, face, kPanel));
    }
    Figure figure;
    figure.number = 9;
    const host::AdaptiveSettings& s = run->scene.objects[0].adaptive;
    figure.text =
        "## Doggett and Hirche, figure 9: a head at three distances\n\n" +
        paragraph(fmt::format(
            "A cylinder of {} triangles under a range map of {} x {} texels (paper: 1800, 512 x "
            "456), from {}. Thresholds are the same at all distances: {:.0f} LSB of mean height, "
            "{:.2f} of the normal, {:.0f} px of an edge. a to c: the picture; d to f: the same "
            "three meshes near the eyes, the nose and the mouth, all from one close camera.",
            grouped(run->mesh(0).triangles.size()), run->map(0).width, run->map(0).height,
            run->source(0), *s.height_threshold, *s.normal_threshold, *s.view_threshold_px)) +
        table +
        "\n![a to c](images/figure9_shaded.png)\n![d to f](images/figure9_wireframe.png)\n\n";
    if (options.draw) {
        figure.pictures = {{"figure9_shaded", panels({above})},
                           {"figure9_wireframe", panels({below}, kLineShades)}};
    }
    return figure;
}

Result<Figure> figure_10(const FigureOptions& options) {
    constexpr host::Viewport kPanel{310, 210};
    auto run = SceneRun::open(options.scenes + "/donut.toml");
    if (!run) return run.error();
    run->scene.camera.fov_deg = 37.0;
    run->scene.viewport = kPanel;
    host::AdaptiveSettings& s = run->scene.objects[0].adaptive;
    const double normal = *s.normal_threshold, height = *s.height_threshold;
    std::string table =
        "| tests | normal | height | triangles | vertices | rms error (% of the relief) |\n"
        "|---|---|---|---|---|---|\n";
    std::vector<Picture> row;
    for (const double times : {2.0, 1.0, 0.5}) {
        for (int i = 0; i < 3; ++i) {
            options.progress(fmt::format("figure 10, {}", "abc"[i]));
            s.normal_threshold.reset();
            s.height_threshold.reset();
            if (i != 1) s.normal_threshold = normal * times;
            if (i != 0) s.height_threshold = height * times;
            const auto surface = run->run(0);
            if (!surface) return surface.error();
            const char* name = std::array{"normal", "height", "both"}[static_cast<std::size_t>(i)];
            const std::string panel = times == 2.0 ? fmt::format("{}: ", "abc"[i]) : "";
            table += fmt::format("| {}{} | {} | {} | {} | {:.2f} |\n", panel, name, tests_of(s),
                                 grouped(surface->triangles()), grouped(surface->vertices()),
                                 error_percent(*run, surface->view));
            if (!options.draw || times != 2.0) continue;
            row.push_back(wireframe({surface->view}, run->scene.camera, kPanel));
        }
    }
    Figure figure;
    figure.number = 10;
    figure.text =
        "## Doggett and Hirche, figure 10: the normal test, the height test, and both\n\n" +
        paragraph(fmt::format(
            "The half donut on a plane of {} triangles, {} x {} texels. *Error* is that of the "
            "displaced triangles against the map at every texel. The panels have large "
            "thresholds: by itself, the normal test takes edges for flat whose ends and middle "
            "happen to look the same way (aliasing), and the height test those around which the "
            "mean heights agree; what one overlooks the other finds.",
            run->mesh(0).triangles.size(), run->map(0).width, run->map(0).height)) +
        table + "\n![a to c](images/figure10.png)\n\n";
    if (options.draw) figure.pictures = {{"figure10", panels({row}, kLineShades)}};
    return figure;
}

}  // namespace repousse::study
