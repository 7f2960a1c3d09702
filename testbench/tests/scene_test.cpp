// Scene files: what is accepted, and that every refusal names file, line and column.
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/scene/assets.h"
#include "testbench/host/scene/scene.h"

namespace repousse::host {
namespace {

const char* const kGood = R"(title = "t"
[viewport]
width_px = 64
height_px = 48
[camera]
eye = [0, -1, 1]
target = [0, 0, 0]
[[object]]
name = "o"
method = "adaptive"
[object.mesh]
kind = "grid"
quads = [3, 3]
[object.map]
kind = "donut"
range = 0.12
[object.adaptive]
normal_threshold = 0.2
height_threshold_lsb = 4096
)";

/// The good scene with one line replaced (or, with an empty `from`, one added at its end).
std::string with(const std::string& from, const std::string& to) {
    std::string text = kGood;
    if (from.empty()) return text + to + "\n";
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// The good scene, swept; `settings` is the content of [object.sweep], if any.
std::string swept(const std::string& settings) {
    std::string text = with("method = \"adaptive\"", "method = \"sweep\"");
    text.resize(text.find("[object.adaptive]"));
    return settings.empty() ? text : text + "[object.sweep]\n" + settings + "\n";
}

std::string message(const std::string& text) {
    const auto scene = parse_scene(text, "s.toml", "testbench/tests");
    return scene.ok() ? "(accepted)" : scene.error().message();
}

TEST(Scene, ReadsEverySetting) {
    const auto scene = parse_scene(kGood, "s.toml", ".");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    EXPECT_EQ(scene->viewport.width_px, 64);
    EXPECT_EQ(scene->lights.size(), 2u);  // default ones
    ASSERT_EQ(scene->objects.size(), 1u);
    const Object& object = scene->objects[0];
    EXPECT_EQ(object.mesh.columns, 3);
    EXPECT_EQ(object.map.recipe.kind, MapKind::Donut);
    EXPECT_EQ(object.map.range, glm::dvec2(0.0, 0.12));
    EXPECT_FALSE(object.adaptive.generation_cap.has_value());
    EXPECT_EQ(object.adaptive.normal_threshold, 0.2);
    EXPECT_EQ(object.adaptive.height_threshold, 4096.0);
    EXPECT_FALSE(object.adaptive.view_threshold_px.has_value());
    EXPECT_FALSE(object.bump);
    const auto sum = parse_scene(
        with("height_threshold_lsb = 4096", "height_threshold_lsb_texel2 = 1e6\n[object.bump]"),
        "s.toml", ".");
    ASSERT_TRUE(sum.ok()) << sum.error().message();
    EXPECT_EQ(sum->objects[0].adaptive.height_mode, HeightMode::Sum);
    EXPECT_EQ(sum->objects[0].adaptive.height_threshold, 1e6);
    EXPECT_TRUE(sum->objects[0].bump);
}

TEST(Scene, TheShippedScenesAreGood) {
    for (const char* name :
         {"donut", "donut_small", "jacksboro", "jacksboro_small", "cylinder", "head", "head_small",
          "head_sweep", "head_sweep_small", "head_lit", "head_lit_small", "terrain_sweep",
          "terrain_sweep_small", "tilt", "tilt_small"}) {
        const auto scene = read_scene(std::string("scenes/") + name + ".toml");
        ASSERT_TRUE(scene.ok()) << scene.error().message();
        const Object& object = scene->objects.at(0);
        const auto mesh = load_mesh(object);
        const auto map = load_map(object, {});
        ASSERT_TRUE(mesh.ok() && map.ok()) << name;
        EXPECT_EQ(mesh->uv.size(), mesh->positions.size());
        EXPECT_EQ(map->texels.size(), static_cast<std::size_t>(map->width * map->height));
        const bool small = std::string(name).find("_small") != std::string::npos;
        EXPECT_TRUE(!small || (map->width <= 64 && scene->viewport.height_px <= 64)) << name;
    }
}

struct Refusal {
    const char* from;
    const char* to;
    const char* expected;  // start of the message
};

TEST(Scene, RefusesWithFileLineAndColumn) {
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

TEST(Scene, TheDocumentNamesEveryKey) {
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

TEST(Scene, ReadsAMaterial) {
    EXPECT_FALSE(parse_scene(swept(""), "s.toml", ".")->objects[0].shade.has_value());
    const auto plain = parse_scene(with("", "[object.shade]"), "s.toml", ".");
    ASSERT_TRUE(plain.ok()) << plain.error().message();
    ASSERT_TRUE(plain->objects[0].shade.has_value());
    EXPECT_EQ(plain->objects[0].shade->shininess, 40);
    EXPECT_FALSE(plain->objects[0].shade->two_sided);
    EXPECT_EQ(plain->objects[0].shade->mark.text(), "s.toml:20:1");
    const auto set =
        parse_scene(with("",
                         "[object.shade]\nambient = [0, 0, 0.1]\ndiffuse = [0.5, 0.25, 1]\n"
                         "specular = [0, 0, 0]\nshininess = 255\ntwo_sided = true"),
                    "s.toml", ".");
    ASSERT_TRUE(set.ok()) << set.error().message();
    const Material& material = *set->objects[0].shade;
    EXPECT_EQ(material.ambient, glm::dvec3(0, 0, 0.1));
    EXPECT_EQ(material.diffuse, glm::dvec3(0.5, 0.25, 1));
    EXPECT_EQ(material.specular, glm::dvec3(0));
    EXPECT_EQ(material.shininess, 255);
    EXPECT_TRUE(material.two_sided);

    // What is not displaced passes the unit by.
    std::string direct = with("method = \"adaptive\"", "method = \"direct\"");
    direct.resize(direct.find("[object.map]"));
    EXPECT_EQ(message(direct + "[object.shade]\n"),
              "s.toml:14:1: [object.shade] in an object of method \"direct\", expected an object "
              "without it");
}

TEST(Scene, ReadsASweep) {
    const auto plain = parse_scene(swept(""), "s.toml", ".");
    ASSERT_TRUE(plain.ok()) << plain.error().message();
    EXPECT_EQ(plain->objects[0].method, Method::Sweep);
    EXPECT_EQ(plain->objects[0].sweep.coarseness_px, 1.0);
    EXPECT_EQ(plain->objects[0].sweep.guard_grid, 4096);
    EXPECT_FALSE(plain->objects[0].sweep.w_min.has_value());
    EXPECT_TRUE(plain->objects[0].sweep.clip);
    const auto set = parse_scene(
        swept("coarseness_px = 45\nguard_grid = 300\nw_min = 0.25\nclip = false"), "s.toml", ".");
    ASSERT_TRUE(set.ok()) << set.error().message();
    EXPECT_EQ(set->objects[0].sweep.coarseness_px, 45.0);
    EXPECT_EQ(set->objects[0].sweep.guard_grid, 300);
    EXPECT_EQ(set->objects[0].sweep.w_min, 0.25);
    EXPECT_FALSE(set->objects[0].sweep.clip);
}

TEST(Scene, RefusesABadSweep) {
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

TEST(Scene, ReadsFilterLevels) {
    const auto with_map = [](const std::string& keys) {
        std::string text = swept("");
        const std::string kind = "kind = \"donut\"";
        return text.replace(text.find(kind), kind.size(), kind + "\n" + keys);
    };
    const auto none = parse_scene(with_map("levels = \"none\""), "s.toml", ".");
    ASSERT_TRUE(none.ok()) << none.error().message();
    EXPECT_FALSE(none->objects[0].map.levels.has_value());
    EXPECT_EQ(none->objects[0].map.filter, HeightFilter::Nearest);
    const auto plain = parse_scene(with_map("levels = \"variational\""), "s.toml", ".");
    ASSERT_TRUE(plain.ok()) << plain.error().message();
    EXPECT_EQ(plain->objects[0].map.levels, LevelFilter::Variational);
    EXPECT_EQ(plain->objects[0].map.filter, HeightFilter::Maximum);
    const auto average =
        parse_scene(with_map("levels = \"maximum\"\nfilter = \"average\""), "s.toml", ".");
    ASSERT_TRUE(average.ok()) << average.error().message();
    EXPECT_EQ(average->objects[0].map.levels, LevelFilter::BoxMaximum);
    EXPECT_EQ(average->objects[0].map.filter, HeightFilter::Average);

    EXPECT_THAT(message(with_map("filter = \"maximum\"")),
                testing::HasSubstr("filter = \"maximum\" without filter levels"));
    EXPECT_THAT(message(with_map("levels = \"average\"\nfilter = \"bilinear\"")),
                testing::HasSubstr("filter levels that filter = \"bilinear\" does not read"));
    EXPECT_THAT(message(with_map("levels = \"highest\"")), testing::HasSubstr("object.map.levels"));
    EXPECT_THAT(message(with("kind = \"donut\"", "kind = \"donut\"\nlevels = \"average\"")),
                testing::HasSubstr("levels in an object of method \"adaptive\""));
}

TEST(Scene, ADirectObjectNeedsNoMap) {
    std::string text = with("method = \"adaptive\"", "method = \"direct\"");
    text.resize(text.find("[object.map]"));
    const auto scene = parse_scene(text, "s.toml", ".");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    EXPECT_EQ(scene->objects[0].method, Method::Direct);
    const auto map = load_map(scene->objects[0], {});
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(map->texels, std::vector<std::uint16_t>{0});
}

TEST(Scene, PlacesAMesh) {
    const auto scene = parse_scene(
        with("quads = [3, 3]", "quads = [1, 1]\nturn_deg = 90\ntranslation = [1, 2, 3]"), "s.toml",
        ".");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    const auto mesh = load_mesh(scene->objects[0]);
    ASSERT_TRUE(mesh.ok());
    // Counter-clockwise: x becomes y, y becomes -x.
    EXPECT_EQ(mesh->positions[0], glm::dvec3(1, 2, 3));
    EXPECT_NEAR(glm::length(mesh->positions[1] - glm::dvec3(1, 3, 3)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(mesh->positions[2] - glm::dvec3(0, 2, 3)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(mesh->tangents[0] - glm::dvec3(0, 1, 0)), 0.0, 1e-12);
}

TEST(Scene, NoTestAtAllIsRefused) {
    std::string text = kGood;
    text.resize(text.find("normal_threshold"));
    EXPECT_EQ(message(text).substr(0, 65),
              "s.toml:17:1: [object.adaptive] has no test that splits a triangle");
    EXPECT_EQ(message(text + "view_threshold_px = 4\n").substr(0, 12), "s.toml:17:1:");
    EXPECT_EQ(message(text + "uniform = true\nview_threshold_px = 4\n"), "(accepted)");
}

TEST(Scene, AnAbsentMapFallsBackAndSaysSo) {
    const std::string text = with("kind = \"donut\"",
                                  "file = \"gone.npz\"\n"
                                  "crop_texels = [0, 0, 4, 4]\n"
                                  "fallback = { kind = \"ramp\", size_texels = [32, 16], "
                                  "slope_lsb_per_texel = [9, 0] }");
    const auto scene = parse_scene(text, "s.toml", ".");
    ASSERT_TRUE(scene.ok()) << scene.error().message();
    ASSERT_EQ(scene->notes.size(), 1u);
    EXPECT_EQ(scene->notes[0],
              "s.toml:15:8: map file \"gone.npz\" is absent; the procedural fallback "
              "\"ramp\" (line 17) stands in");
    const auto map = load_map(scene->objects[0], {});
    ASSERT_TRUE(map.ok());
    EXPECT_EQ(map->width, 32);
    EXPECT_EQ(map->at(2, 0), 18);
    // A mistake in a fallback is found although nobody needs it yet.
    EXPECT_EQ(
        message(with("kind = \"donut\"", "file = \"gone.npz\"\nfallback = { kind = \"fbn\" }"))
            .substr(0, 13),
        "s.toml:16:21:");
}

TEST(Scene, ErrorsInNamedFilesNameTheSceneLine) {
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

TEST(TexelCoordinate, SpansEdgesOrCentres) {
    HeightMap map;
    map.width = 403;
    map.height = 344;
    EXPECT_EQ(texel_coordinate({0.0, 1.0}, map, UvSpan::Edges), glm::dvec2(0.0, 344.0));
    EXPECT_EQ(texel_coordinate({0.0, 1.0}, map, UvSpan::Centres), glm::dvec2(0.5, 343.5));
    Mesh mesh;
    mesh.world_per_uv = {1.0, 1.0};
    EXPECT_EQ(texel_size(mesh, map, UvSpan::Edges).x, 1.0 / 403);
    EXPECT_EQ(texel_size(mesh, map, UvSpan::Centres).y, 1.0 / 343);
}

}  // namespace
}  // namespace repousse::host
