// Scene files that are refused: every refusal names file, line and column, and every key that it
// offers is in the documentation.
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "testbench/host/scene/assets.h"
#include "testbench/host/scene/scene.h"
#include "testbench/tests/support/scene_text.h"

namespace repousse::host {
namespace {

using test::kGoodScene;
using test::message;
using test::swept;
using test::with;

struct Refusal {
    const char* from;
    const char* to;
    const char* expected;  // start of the message
};

TEST(SceneRefusal, RefusesWithFileLineAndColumn) {
    const Refusal cases[] = {
        {"width_px = 64", "width_px = 0",
         "s.toml:3:12: viewport.width_px is 0, expected an integer in 1..8192"},
        {"width_px = 64", "width_px = 64.5",
         "s.toml:3:12: viewport.width_px is a number, expected an integer"},
        {"width_px", "widht_px",
         "s.toml:3:1: unknown key \"widht_px\" in [viewport], expected one of height_px, width_px; "
         "did you mean \"width_px\"?"},
        {"normal_threshold = 0.2", "normal_threshold = 2.5",
         "s.toml:18:20: object.adaptive.normal_threshold is 2.5, expected a number in 0..2"},
        {"normal_threshold = 0.2", "normal_threshold = nan",
         "s.toml:18:20: object.adaptive.normal_threshold is nan"},
        {"normal_threshold = 0.2", "normal_threshold = \"much\"",
         "s.toml:18:20: object.adaptive.normal_threshold holds a string, expected a number in "
         "0..2"},
        {"height_threshold_lsb = 4096", "height_threshold_lsb = 70000",
         "s.toml:19:24: object.adaptive.height_threshold_lsb is 70000, expected a number in "
         "0..65535"},
        {"height_threshold_lsb = 4096", "height_threshold_lsb = -1",
         "s.toml:19:24: object.adaptive"},
        {"height_threshold_lsb = 4096", "generation_cap = 16",
         "s.toml:19:18: object.adaptive.generation_cap is 16, expected an integer in 0..15"},
        {"height_threshold_lsb = 4096", "height_mode = \"sum\"\nheight_threshold_lsb = 4096",
         "s.toml:20:24: height_mode \"sum\" does not take this threshold"},
        {"height_threshold_lsb = 4096", "uniform = true", "s.toml:19:11: uniform = true together"},
        {"height_threshold_lsb = 4096", "treshold = 1", "s.toml:19:1: unknown key \"treshold\""},
        {"method = \"adaptive\"", "method = \"decal\"",
         "s.toml:10:10: method \"decal\" is not built yet, expected \"adaptive\", \"sweep\" or "
         "\"direct\""},
        {"method = \"adaptive\"", "method = \"adaptiv\"",
         "s.toml:10:10: object.method is \"adaptiv\", expected \"adaptive\", \"sweep\" or "
         "\"direct\"; did you mean \"adaptive\"?"},
        {"method = \"adaptive\"", "method = \"swep\"",
         "s.toml:10:10: object.method is \"swep\", expected \"adaptive\", \"sweep\" or "
         "\"direct\"; did you mean \"sweep\"?"},
        {"method = \"adaptive\"", "method = \"sweep\"",
         "s.toml:17:1: [object.adaptive] in an object of method \"sweep\""},
        {"method = \"adaptive\"", "method = \"direct\"",
         "s.toml:14:1: [object.map] in an object of method \"direct\""},
        {"", "[object.sweep]", "s.toml:20:1: [object.sweep] in an object of method \"adaptive\""},
        {"kind = \"donut\"", "kind = \"range\"", "s.toml:14:1: object.map.file is missing"},
        {"kind = \"donut\"", "kind = \"range\"\nfile = \"a.png\"",
         "s.toml:16:8: map file \"a.png\" is of an unknown type, expected a mesh"},
        {"kind = \"donut\"",
         "kind = \"range\"\nfile = \"a.off\"\naxis = [0, 0, 1, 0, 0, 1]\nfront = [1, 0, 0]",
         "s.toml:17:8: object.map.axis has no length"},
        {"kind = \"donut\"",
         "kind = \"range\"\nfile = \"a.off\"\naxis = [0, 0, 0, 0, 0, 1]\nfront = [0, 0, 1]",
         "s.toml:18:9: object.map.front is zero or runs along the axis"},
        {"", "[object.shade]\nshininess = 0",
         "s.toml:21:13: object.shade.shininess is 0, expected an integer in 1..255"},
        {"", "[object.shade]\nshininess = 256", "s.toml:21:13: object.shade.shininess is 256"},
        {"", "[object.shade]\nshininess = 2.5",
         "s.toml:21:13: object.shade.shininess is a number, expected an integer"},
        {"", "[object.shade]\ndiffuse = [0.5, 1.5, 0]",
         "s.toml:21:17: object.shade.diffuse is 1.5"},
        {"", "[object.shade]\nambient = 0.5", "s.toml:21:11: object.shade.ambient is a number"},
        {"", "[object.shade]\ntwo_sided = 1", "s.toml:21:13: object.shade.two_sided is"},
        {"", "[object.shade]\nspeculer = [0, 0, 0]",
         "s.toml:21:1: unknown key \"speculer\" in [object.shade], expected one of ambient, "
         "diffuse, "
         "shininess, specular, two_sided; did you mean \"specular\"?"},
        {"kind = \"donut\"", "file = \"no_such.png\"",
         "s.toml:15:8: map file \"no_such.png\" does not exist, expected a file beside the scene"},
        {"kind = \"donut\"", "file = \"map.jpeg\"",
         "s.toml:15:8: map file \"map.jpeg\" is of an unknown type"},
        {"kind = \"donut\"", "kind = \"doughnut\"", "s.toml:15:8: object.map.kind is \"doughnut\""},
        {"kind = \"donut\"\n", "", "s.toml:14:1: object.map.kind is missing"},
        {"range = 0.12", "", "s.toml:14:1: object.map.range is missing"},
        {"range = 0.12", "range = [0.2, 0.1]", "s.toml:16:9: object.map.range is [0.2, 0.1]"},
        {"range = 0.12", "range = 1\ncrop_texels = [0, 0, 300, 10]",
         "s.toml:17:15: object.map.crop_texels is not inside the map"},
        {"range = 0.12", "range = 1\nwrap = true\nuv = \"centres\"",
         "s.toml:18:6: uv = \"centres\" on a map"},
        {"kind = \"grid\"", "file = \"no.ply\"",
         "s.toml:12:8: mesh file \"no.ply\" does not exist"},
        {"kind = \"grid\"", "file = \"no.stl\"",
         "s.toml:12:8: mesh file \"no.stl\" is of an unknown type"},
        {"quads = [3, 3]", "quads = [3]", "s.toml:13:9: object.mesh.quads has 1 items"},
        {"quads = [3, 3]", "quads = [3, 0]", "s.toml:13:13: object.mesh.quads is 0"},
        {"quads = [3, 3]", "quads = [3, 1.5]", "s.toml:13:13: object.mesh.quads holds 1.5"},
        {"target = [0, 0, 0]", "target = [0, -1, 1]",
         "s.toml:7:10: camera.target is the eye itself"},
        {"target = [0, 0, 0]", "target = [0, 0, 0]\nup = [0, 2, -2]",
         "s.toml:8:6: camera.up is zero or"},
        {"target = [0, 0, 0]", "target = [0, 0, inf]", "s.toml:7:17: camera.target is inf"},
        {"target = [0, 0, 0]", "target = [0, 0, 0]\nfar = 0.001",
         "s.toml:8:7: camera.far is not beyond"},
        {"[viewport]", "[viewprot]", "s.toml:2:2: unknown key \"viewprot\", expected one of"},
        {"[[object]]", "[object]", "s.toml:8:1: object is a table, expected an array of tables"},
        {"title = \"t\"", "title = 3", "s.toml:1:9: title is an integer, expected a string"},
        {"title = \"t\"", "title = ", "s.toml:1:"},
        {"title = \"t\"", "title = \"t\"\ntitle = \"u\"", "s.toml:2:"},
    };
    for (const Refusal& c : cases) {
        const std::string start = c.expected;
        EXPECT_EQ(message(with(c.from, c.to)).substr(0, start.size()), start);
    }
    EXPECT_EQ(message("").substr(0, 11), "s.toml:1:1:");
}

TEST(SceneRefusal, RefusesABadSweep) {
    const Refusal cases[] = {
        {"", "coarseness_px = 0", "s.toml:18:17: object.sweep.coarseness_px is 0, expected"},
        {"", "coarseness_px = -1", "s.toml:18:17: object.sweep.coarseness_px is -1, expected"},
        {"", "coarseness = 1",
         "s.toml:18:1: unknown key \"coarseness\" in [object.sweep], expected one of clip, "
         "coarseness_px, guard_grid, w_min; did you mean \"coarseness_px\"?"},
        {"", "guard_grid = 5000",
         "s.toml:18:14: object.sweep.guard_grid is 5000, expected an integer in 1..4096"},
        {"", "w_min = 0", "s.toml:18:9: object.sweep.w_min is 0"},
        {"", "clip = 1", "s.toml:18:8: object.sweep.clip"},
    };
    for (const Refusal& c : cases) {
        const std::string start = c.expected;
        EXPECT_EQ(message(swept(c.to)).substr(0, start.size()), start);
    }
}

TEST(SceneRefusal, NoTestAtAllIsRefused) {
    std::string text = kGoodScene;
    text.resize(text.find("normal_threshold"));
    EXPECT_EQ(message(text).substr(0, 65),
              "s.toml:17:1: [object.adaptive] has no test that splits a triangle");
    EXPECT_EQ(message(text + "view_threshold_px = 4\n").substr(0, 12), "s.toml:17:1:");
    EXPECT_EQ(message(text + "uniform = true\nview_threshold_px = 4\n"), "(accepted)");
}

TEST(SceneRefusal, ErrorsInNamedFilesNameTheSceneLine) {
    const std::string folder = testing::TempDir();
    std::ofstream(folder + "/bad.off") << "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n";
    std::ofstream(folder + "/empty.npz") << "";
    const auto scene = parse_scene(
        with("kind = \"grid\"\nquads = [3, 3]", "file = \"bad.off\"\nprojection = \"planar\""),
        "s.toml", folder);
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    const auto mesh = load_mesh(scene->objects[0]);
    ASSERT_FALSE(mesh.ok());
    EXPECT_NE(mesh.error().message().find("bad.off:4:3: \"nan\" is not finite"), std::string::npos);
    EXPECT_NE(mesh.error().message().find("named at s.toml:12:8"), std::string::npos);
    const auto other =
        parse_scene(with("kind = \"donut\"", "file = \"empty.npz\""), "s.toml", folder);
    ASSERT_TRUE(other.ok()) << other.error().message();
    const auto map = load_map(other->objects[0], {});
    ASSERT_FALSE(map.ok());
    EXPECT_NE(map.error().message().find("empty.npz: offset 0"), std::string::npos);
    EXPECT_NE(map.error().message().find("named at s.toml:15:8"), std::string::npos);
}

TEST(SceneRefusal, TheDocumentNamesEveryKey) {
    std::ifstream file("docs/scene.md");
    const std::string document((std::istreambuf_iterator<char>(file)), {});
    const Refusal tables[] = {
        {"title = \"t\"", "x_ = 1", ""},
        {"[viewport]", "[viewport]\nx_ = 1", ""},
        {"[camera]", "[camera]\nx_ = 1", ""},
        {"", "[[light]]\nx_ = 1", ""},
        {"", "[view]\nx_ = 1", ""},
        {"[[object]]", "[[object]]\nx_ = 1", ""},
        {"kind = \"grid\"", "kind = \"grid\"\nx_ = 1", ""},
        {"kind = \"grid\"\nquads = [3, 3]", "kind = \"cylinder\"\nx_ = 1", ""},
        {"kind = \"donut\"", "kind = \"fbm\"\nx_ = 1", ""},
        {"kind = \"donut\"", "kind = \"ramp\"\nx_ = 1", ""},
        {"kind = \"donut\"", "kind = \"checker\"\nx_ = 1", ""},
        {"kind = \"donut\"", "kind = \"constant\"\nx_ = 1", ""},
        {"kind = \"donut\"",
         "kind = \"range\"\nfile = \"a.off\"\nfallback = { kind = \"fbm\" }\nx_ = 1", ""},
        {"[object.adaptive]", "[object.adaptive]\nx_ = 1", ""},
        {"", "[object.shade]\nx_ = 1", ""},
        {nullptr, "x_ = 1", ""}};
    for (const Refusal& table : tables) {
        const std::string text =
            table.from == nullptr ? swept(table.to) : with(table.from, table.to);
        const auto scene = parse_scene(text, "s.toml", ".");
        ASSERT_FALSE(scene.ok()) << table.to;
        std::istringstream keys(scene.error().expected.substr(7));  // "one of a, b, c"
        for (std::string key; std::getline(keys >> std::ws, key, ',');) {
            const bool named = document.find("`" + key + "`") != std::string::npos ||
                               document.find("[" + key + "]") != std::string::npos ||
                               document.find("[object." + key + "]") != std::string::npos;
            EXPECT_TRUE(named) << key;
        }
    }
}

}  // namespace
}  // namespace repousse::host
