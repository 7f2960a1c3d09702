#include <cmath>

#include <glm/geometric.hpp>

#include "testbench/host/files.h"
#include "testbench/host/scene/object_reader.h"
#include "testbench/host/scene/scene.h"
#include "testbench/host/scene/table_reader.h"

namespace repousse::host {
namespace {

constexpr double kWorldLimit = 1e6;
constexpr std::uint64_t kSceneLimitBytes = 1 << 20;

Viewport read_viewport(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "viewport", context);
    Viewport viewport;
    viewport.width_px = reader.integer("width_px", viewport.width_px, 1, 8192);
    viewport.height_px = reader.integer("height_px", viewport.height_px, 1, 8192);
    reader.finish();
    return viewport;
}

CameraSettings read_camera(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "camera", context);
    CameraSettings camera;
    reader.require("eye", "an array of 3 numbers, world units");
    reader.require("target", "an array of 3 numbers, world units");
    camera.eye = reader.vector3("eye", camera.eye, -kWorldLimit, kWorldLimit);
    camera.target = reader.vector3("target", camera.target, -kWorldLimit, kWorldLimit);
    camera.up = reader.vector3("up", camera.up, -kWorldLimit, kWorldLimit);
    camera.fov_deg = reader.number("fov_deg", camera.fov_deg, 1.0, 170.0);
    camera.near = reader.number("near", camera.near, 1e-6, kWorldLimit);
    camera.far = reader.number("far", camera.far, 1e-6, kWorldLimit);
    const glm::dvec3 forward = camera.target - camera.eye;
    const double across = glm::length(glm::cross(forward, camera.up));
    if (forward == glm::dvec3(0.0)) {
        reader.fail("target", "camera.target is the eye itself", "a point to look at");
    } else if (!(across > 1e-9 * glm::length(forward) * glm::length(camera.up))) {
        reader.fail("up", "camera.up is zero or runs along the viewing direction",
                    "a direction across it");
    }
    if (!(camera.near < camera.far)) {
        reader.fail("far", "camera.far is not beyond camera.near", "near below far");
    }
    reader.finish();
    return camera;
}

Light read_light(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "light", context);
    Light light;
    reader.require("direction", "an array of 3 numbers that points towards the light");
    light.direction = reader.vector3("direction", light.direction, -kWorldLimit, kWorldLimit);
    const double length = glm::length(light.direction);
    if (length > 0.0) {
        light.direction /= length;
    } else {
        reader.fail("direction", "light.direction has no length", "a vector towards the light");
    }
    light.colour = reader.vector3("colour", light.colour, 0.0, 16.0);
    reader.finish();
    return light;
}

ViewSettings read_view(const TomlValue& table, ReadContext& context) {
    TableReader reader(table, "view", context);
    ViewSettings view;
    view.wireframe = reader.boolean("wireframe", view.wireframe);
    view.shadows = reader.boolean("shadows", view.shadows);
    view.skirt = reader.boolean("skirt", view.skirt);
    view.tint = static_cast<Tint>(reader.choice("tint", {"plain", "relief"}, 0));
    view.shading = static_cast<Shading>(reader.choice("shading", {"smooth", "flat"}, 0));
    view.background = reader.vector3("background", view.background, 0.0, 1.0);
    view.horizon = reader.vector3("horizon", view.background, 0.0, 1.0);
    view.colour = reader.vector3("colour", view.colour, 0.0, 1.0);
    view.samples = reader.integer("samples", view.samples, 1, 4);
    reader.finish();
    return view;
}

/// Two lights that show relief: a warm key from the upper left, a weak cool fill from the right.
std::vector<Light> default_lights() {
    return {{glm::normalize(glm::dvec3(-0.6, 0.4, 0.7)), {1.0, 0.97, 0.92}},
            {glm::normalize(glm::dvec3(0.8, -0.3, 0.5)), {0.35, 0.38, 0.45}}};
}

void read_objects(TableReader& reader, Scene& scene, ReadContext& context) {
    reader.require("object", "at least one [[object]]");
    for (const TomlValue* table : reader.tables("object")) {
        Object object = read_object(*table, static_cast<int>(scene.objects.size()), context);
        for (const Object& other : scene.objects) {
            if (other.name != object.name) continue;
            context.fail(object.mark, "two objects are called \"" + object.name + "\"",
                         "a name of its own for each object");
        }
        scene.objects.push_back(std::move(object));
    }
}

}  // namespace

Result<Scene> parse_scene(const std::string& text, const std::string& name,
                          const std::string& folder) {
    Result<TomlValue> document = parse_toml(text, name);
    if (!document.ok()) return document.error();
    document->line = document->column = 1;
    ReadContext context{name, folder, {}, {}};
    TableReader reader(*document, "", context);
    Scene scene;
    scene.file = name;
    scene.title = reader.text("title", "");
    scene.profile = reader.text("profile", scene.profile);
    if (const TomlValue* table = reader.table("viewport")) {
        scene.viewport = read_viewport(*table, context);
    }
    reader.require("camera", "a table [camera]");
    if (const TomlValue* table = reader.table("camera"))
        scene.camera = read_camera(*table, context);
    for (const TomlValue* table : reader.tables("light")) {
        scene.lights.push_back(read_light(*table, context));
    }
    if (scene.lights.size() > 8) {
        reader.fail("light", "the scene has " + std::to_string(scene.lights.size()) + " lights",
                    "at most 8");
    }
    if (scene.lights.empty()) scene.lights = default_lights();
    if (const TomlValue* table = reader.table("view")) scene.view = read_view(*table, context);
    read_objects(reader, scene, context);
    reader.finish();
    if (context.error) return *context.error;
    scene.notes = context.notes;
    return scene;
}

Result<Scene> read_scene(const std::string& path) {
    Result<std::string> text = read_file(path, kSceneLimitBytes);
    if (!text.ok()) return text.error();
    return parse_scene(*text, path, folder_of(path));
}

}  // namespace repousse::host
