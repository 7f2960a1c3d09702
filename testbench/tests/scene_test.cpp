// Scene files: every setting, its default, and what is loaded for it.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/scene/assets.h"
#include "testbench/host/scene/scene.h"
#include "testbench/tests/support/scene_text.h"

namespace repousse::host {
namespace {

using test::kGoodScene;
using test::message;
using test::swept;
using test::with;

TEST(Scene, ReadsEverySetting) {
    const auto scene = parse_scene(kGoodScene, "s.toml", ".");
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
    EXPECT_EQ(average->objects[0].map.finer_levels, 0);
    const auto finer =
        parse_scene(with_map("levels = \"average\"\nfiner_levels = 2"), "s.toml", ".");
    ASSERT_TRUE(finer.ok()) << finer.error().message();
    EXPECT_EQ(finer->objects[0].map.finer_levels, 2);

    EXPECT_THAT(message(with_map("levels = \"average\"\nfiner_levels = 3")),
                testing::HasSubstr("object.map.finer_levels"));
    EXPECT_THAT(message(with_map("levels = \"average\"\nfilter = \"average\"\nfiner_levels = 1")),
                testing::AllOf(testing::HasSubstr("finer_levels = 1 with filter = \"average\""),
                               testing::HasSubstr("filter = \"maximum\", or finer_levels = 0"),
                               testing::StartsWith("s.toml:")));
    EXPECT_THAT(message(with_map("finer_levels = 1")),
                testing::HasSubstr("finer_levels = 1 with filter = \"nearest\""));
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
