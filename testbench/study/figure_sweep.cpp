// The figures of Gumhold and Huettner's results (section 5).

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "testbench/host/view/camera.h"
#include "testbench/study/figure_panels.h"
#include "testbench/study/figure_papers.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
namespace {

using host::Picture;

}  // namespace

Result<Figure> figure_18(const FigureOptions& options) {
    constexpr host::Viewport kWhole{852, 426}, kPanel{280, 280};
    auto run = SceneRun::open(options.scenes + "/head_sweep.toml");
    if (!run) return run.error();
    run->scene.viewport = kWhole;
    const host::CameraSettings& camera = run->scene.camera;
    const host::ViewFrame frame = host::view_frame(camera, kWhole);
    std::string table =
        "| panels | distance | base mesh height (px) | grid unit (1 px) | grid units on the base "
        "mesh | triangles | vertices |\n|---|---|---|---|---|---|---|\n";
    std::vector<host::RenderMesh> heads;
    std::vector<Picture> close;
    for (std::size_t i = 0; i < run->scene.objects.size(); ++i) {
        const host::Object& object = run->scene.objects[i];
        options.progress(fmt::format("figure 18, {}", object.name));
        const auto surface = run->run(i);
        if (!surface) return surface.error();
        const glm::dvec3 middle =
            object.mesh.translation + glm::dvec3(0.0, 0.0, 0.5 * object.mesh.height);
        const double distance = glm::dot(middle - frame.eye, frame.forward);
        const double unit = distance / frame.focal.x * object.sweep.coarseness_px;
        table += fmt::format("| {}, {} | {:.2f} | {:.0f} | {:.5f} | {:.0f} x {:.0f} | {} | {} |\n",
                             "abc"[i], "def"[i], distance, object.mesh.height / unit, unit,
                             2.0 * object.mesh.radius / unit, object.mesh.height / unit,
                             grouped(surface->triangles()), grouped(surface->vertices()));
        heads.push_back(surface->view);
        if (!options.draw) continue;
        // Before the face, which a turn of 90 degrees has look to -y: an eye and the nose's root.
        const double turn = glm::radians(object.mesh.turn_deg - 90.0);
        const glm::dvec3 front(std::sin(turn), -std::cos(turn), 0.0);
        host::CameraSettings face = camera;
        face.target = middle + 0.3 * front + 0.06 * glm::cross(front, camera.up);
        face.target.z += 0.17;
        face.eye = face.target + 1.5 * front;
        face.fov_deg = 13.0;
        close.push_back(wireframe({surface->view}, face, kPanel));
    }
    Figure figure;
    figure.number = 18;
    figure.text =
        "## Gumhold and Huettner, figure 18: a head remeshed at three distances\n\n" +
        paragraph(fmt::format(
            "A cylinder of {} triangles (paper: 32) under a range map of {} x {} texels from {}, "
            "remeshed to grid units of one pixel in a picture of {} x {} pixels. A head twice as "
            "far has half as many grid units along each side and about a quarter of the triangles, "
            "with no filter of any kind. a to c: the picture; d to f: the same three meshes around "
            "the root of the nose, all from as near.",
            run->mesh(0).triangles.size(), run->map(0).width, run->map(0).height, run->source(0),
            kWhole.width_px, kWhole.height_px)) +
        table +
        "\n![a to c](images/figure18_shaded.png)\n![d to f](images/figure18_wireframe.png)\n\n";
    if (options.draw) {
        figure.pictures = {
            {"figure18_shaded", panels({{shaded(run->scene, heads, camera, kWhole)}})},
            {"figure18_wireframe", panels({close}, kLineShades)}};
    }
    return figure;
}

}  // namespace repousse::study
