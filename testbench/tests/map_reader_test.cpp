// Elevation files other than .npz: JSON and classic netCDF, whole and broken; and voids, the
// samples without an elevation: marked, refused, filled, and on their way through a scene.
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "testbench/host/files.h"
#include "testbench/host/map/json_reader.h"
#include "testbench/host/map/netcdf_reader.h"
#include "testbench/host/map/voids.h"
#include "testbench/host/scene/assets.h"

namespace repousse::host {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string message(const Result<ElevationGrid>& grid) {
    return grid.ok() ? "(accepted)" : grid.error().message();
}

TEST(JsonGrid, ReadsRowsInTheirOrderAndNullAsVoid) {
    const auto grid = read_json_grid(
        R"({"name": "x", "width": 3, "height": 2, "values": [1, 2.5, -3, null, 5, 6]})", "v.json");
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_EQ(grid->width, 3);
    EXPECT_EQ(grid->height, 2);
    EXPECT_EQ(grid->samples[1], 2.5);
    EXPECT_TRUE(std::isnan(grid->samples[3]));
    EXPECT_EQ(grid->low, -3);
    EXPECT_EQ(grid->high, 6);
    EXPECT_TRUE(grid->metres);
}

TEST(JsonGrid, SaysWhatIsWrongAndWhere) {
    EXPECT_EQ(message(read_json_grid("{\n \"width\": 3,\n ]", "v.json")),
              "v.json:3:2: this is no JSON, expected an elevation grid");
    EXPECT_EQ(message(read_json_grid("", "v.json")),
              "v.json:1:1: this is no JSON, expected an elevation grid");
    EXPECT_NE(message(read_json_grid("[1, 2]", "v.json")).find("the JSON is no object"),
              std::string::npos);
    EXPECT_NE(message(read_json_grid(R"({"width": 0, "height": 1, "values": []})", "v.json"))
                  .find("\"width\" is no size, expected an integer of 1..16384"),
              std::string::npos);
    EXPECT_NE(message(read_json_grid(R"({"width": 1, "height": 1e9, "values": []})", "v.json"))
                  .find("\"height\" is no size"),
              std::string::npos);
    EXPECT_NE(message(read_json_grid(R"({"width": 2, "height": 1, "values": [1]})", "v.json"))
                  .find("expected 2 numbers"),
              std::string::npos);
    EXPECT_NE(message(read_json_grid(R"({"width": 2, "height": 1, "values": [1, "a"]})", "v.json"))
                  .find("values[1] is no number"),
              std::string::npos);
    EXPECT_FALSE(read_json_grid(R"({"width": 1, "height": 1, "values": [1e999]})", "v.json").ok());
}

std::string big(std::uint64_t value, int count = 4) {
    std::string bytes;
    while (count-- > 0) bytes += static_cast<char>(value >> (8 * count) & 0xFF);
    return bytes;
}

std::string text(const std::string& value) {
    return big(value.size()) + value + std::string((4 - value.size() % 4) % 4, '\0');
}

std::string floats(const std::vector<float>& values) {
    std::string bytes;
    for (const float value : values) {
        std::uint32_t word = 0;
        std::memcpy(&word, &value, 4);
        bytes += big(word);
    }
    return bytes;
}

/// A CDF-1 or CDF-2 file of 2 rows and 3 columns of float32, after a coordinate variable.
std::string netcdf(int version = 1, const std::string& attribute = "missing_value") {
    const int offset = version == 1 ? 4 : 8;
    const auto make = [&](std::uint64_t begin) {
        const std::string x =
            text("x") + big(1) + big(0) + big(0) + big(0) + big(6) + big(24) + big(begin, offset);
        const std::string missing = text(attribute) + big(5) + big(1) + floats({-9999.0f});
        const std::string units = text("units") + big(2) + text("meters");
        const std::string z = text("height") + big(2) + big(1) + big(0) + big(12) + big(2) +
                              missing + units + big(5) + big(24) + big(begin + 24, offset);
        const std::string dimensions = big(10) + big(2) + text("x") + big(3) + text("y") + big(2);
        return "CDF" + std::string(1, static_cast<char>(version)) + big(0) + dimensions + big(12) +
               big(1) + text("history") + big(2) + text("made here") + big(11) + big(2) + x + z;
    };
    const std::uint64_t begin = make(0).size();
    return make(begin) + std::string(24, '\0') + floats({1, 2, -9999, 4, 5, 6.5});
}

TEST(NetCdf, ReadsTheFirstTwoDimensionalVariable) {
    for (const int version : {1, 2}) {
        const auto grid = read_netcdf(netcdf(version), "e.nc");
        ASSERT_TRUE(grid.ok()) << message(grid);
        EXPECT_EQ(grid->width, 3);
        EXPECT_EQ(grid->height, 2);
        EXPECT_EQ(grid->samples[0], 1);
        EXPECT_TRUE(std::isnan(grid->samples[2]));
        EXPECT_EQ(grid->samples[5], 6.5);
        EXPECT_EQ(grid->low, 1);
        EXPECT_EQ(grid->high, 6.5);
        EXPECT_TRUE(grid->metres);
    }
}

TEST(NetCdf, RefusesWhatIsBrokenOrNotRead) {
    const std::string good = netcdf();
    for (std::size_t size = 0; size < good.size(); ++size) {
        const auto grid = read_netcdf(good.substr(0, size), "e.nc");
        ASSERT_FALSE(grid.ok()) << size;
        EXPECT_EQ(grid.error().where.substr(0, 13), "e.nc: offset ");
    }
    // One bit changed anywhere is harmless or refused, never a crash or an allocation of gigabytes.
    for (std::size_t at = 0; at < good.size(); ++at) {
        for (const int bit : {0x80, 0x10, 0x01}) {
            std::string bad = good;
            bad[at] = static_cast<char>(bad[at] ^ bit);
            const auto grid = read_netcdf(bad, "e.nc");
            EXPECT_TRUE(!grid.ok() || grid->samples.size() <= 6u) << at;
        }
    }
    EXPECT_NE(message(read_netcdf("\x89HDF\r\n\x1a\n", "e.nc")).find("no classic netCDF"),
              std::string::npos);
    EXPECT_NE(message(read_netcdf(netcdf(1, "scale_factor"), "e.nc")).find("packed"),
              std::string::npos);
}

ElevationGrid grid_of(int width, std::vector<double> samples) {
    ElevationGrid grid;
    grid.width = width;
    grid.height = static_cast<int>(samples.size()) / width;
    grid.samples = std::move(samples);
    measure_range(grid);
    return grid;
}

TEST(Voids, AMarkedValueLeavesTheMeasuredRange) {
    ElevationGrid grid = grid_of(2, {-32768, 10, 20, -32768});
    EXPECT_EQ(grid.low, -32768);
    mark_voids(grid, -32768);
    EXPECT_EQ(grid.low, 10);
    EXPECT_EQ(grid.high, 20);
    grid.measured = false;  // a declared range stays
    mark_voids(grid, 10);
    EXPECT_EQ(grid.low, 10);
}

TEST(Voids, AreFilledFromTheirRimWithMeans) {
    ElevationGrid grid = grid_of(5, {1, kNan, kNan, kNan, 9});
    const auto filled = fill_voids(grid, false, "m");
    ASSERT_TRUE(filled.ok());
    EXPECT_EQ(*filled, 3u);
    EXPECT_EQ(grid.samples, (std::vector<double>{1, 1, 5, 9, 9}));
    // Across the seam when the map wraps.
    for (const bool wrap : {false, true}) {
        grid = grid_of(3, {kNan, 3, 9});
        ASSERT_TRUE(fill_voids(grid, wrap, "m").ok());
        EXPECT_EQ(grid.samples, (std::vector<double>{wrap ? 6.0 : 3.0, 3, 9}));
    }
}

TEST(Voids, ABigHoleIsFilledWithinItsRimsHeightsAndNothingElseMoves) {
    constexpr int kSide = 200;
    std::vector<double> samples;
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide - 90, y = i / kSide - 110;
        samples.push_back(x * x + y * y < 80 * 80 ? kNan : i % 7 + 100);
    }
    ElevationGrid grid = grid_of(kSide, samples);
    const auto filled = fill_voids(grid, false, "m");
    ASSERT_TRUE(filled.ok());
    std::size_t holes = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::isnan(samples[i])) {
            ++holes;
            EXPECT_GE(grid.samples[i], 100);
            EXPECT_LE(grid.samples[i], 106);
        } else {
            EXPECT_EQ(grid.samples[i], samples[i]);
        }
    }
    EXPECT_EQ(*filled, holes);
}

TEST(Voids, AllVoidsOrNoneAskedForAreErrors) {
    ElevationGrid grid = grid_of(2, {kNan, kNan});
    const auto filled = fill_voids(grid, true, "m.npz");
    ASSERT_FALSE(filled.ok());
    EXPECT_EQ(filled.error().message(),
              "m.npz: no texel has a height: all are voids, expected at least one finite height");
    EXPECT_EQ(quantise(grid).texels, (std::vector<std::uint16_t>{0, 0}));
    EXPECT_EQ(refuse_voids(grid_of(2, {1, 2, kNan, 3}), "m.npz").error().message(),
              "m.npz: texel (0, 1) is not finite, expected finite heights; fill_voids = true fills "
              "such texels");
}

/// The map of a scene whose file is `json`; `keys` go into its map table.
Result<HeightMap> scene_map(const std::string& json, const std::string& keys) {
    const std::string folder = testing::TempDir();
    std::ofstream(folder + "/m.json") << json;
    const auto scene = parse_scene(
        "[camera]\neye = [0.5, -1, 1]\ntarget = [0.5, 0.5, 0]\n[[object]]\n[object.mesh]\n"
        "kind = \"grid\"\n[object.map]\nfile = \"m.json\"\nrange = 1\n" +
            keys + "\n[object.adaptive]\nheight_threshold_lsb = 1\n",
        "s.toml", folder);
    if (!scene.ok()) return scene.error();
    return load_map(scene->objects[0], {});
}

TEST(Voids, ThroughAScene) {
    const std::string grid = R"({"width": 3, "height": 1, "values": [0, -32768, 100]})";
    const auto plain = scene_map(grid, "");
    ASSERT_TRUE(plain.ok()) << plain.error().message();
    EXPECT_EQ(plain->texels[1], 0);
    EXPECT_EQ(plain->elevation_low_m, -32768);
    const auto marked = scene_map(grid, "void_value = -32768");
    ASSERT_TRUE(marked.ok()) << marked.error().message();
    EXPECT_EQ(marked->texels, (std::vector<std::uint16_t>{0, 32768, 65535}));
    EXPECT_EQ(marked->filled_texels, 1u);
    EXPECT_EQ(marked->elevation_low_m, 0);
    const std::string hole = R"({"width": 3, "height": 1, "values": [0, null, 100]})";
    const auto refused = scene_map(hole, "");
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message().find("m.json: texel (1, 0) is not finite"),
              std::string::npos);
    EXPECT_NE(refused.error().message().find("named at s.toml:8:8"), std::string::npos);
    const auto filled = scene_map(hole, "fill_voids = true");
    ASSERT_TRUE(filled.ok()) << filled.error().message();
    EXPECT_EQ(filled->texels, marked->texels);
    EXPECT_FALSE(scene_map(R"({"width": 1, "height": 1, "values": [null]})", "fill_voids = true"));
}

TEST(BadMaps, OneTexelAllEqualAndAllHighest) {
    const auto one = scene_map(R"({"width": 1, "height": 1, "values": [42]})", "");
    ASSERT_TRUE(one.ok());
    EXPECT_EQ(one->texels, std::vector<std::uint16_t>{0});  // no range: the low end
    const auto equal = scene_map(R"({"width": 2, "height": 2, "values": [7, 7, 7, 7]})", "");
    ASSERT_TRUE(equal.ok());
    EXPECT_EQ(equal->texels, std::vector<std::uint16_t>(4, 0));
    const auto highest = scene_map(R"({"width": 2, "height": 1, "values": [65535, 65535]})",
                                   "sample_range = [0, 65535]");
    ASSERT_TRUE(highest.ok());
    EXPECT_EQ(highest->texels, std::vector<std::uint16_t>(2, 65535));
}

TEST(RealFiles, Etopo5HasItsKnownContent) {
    const std::string path = "inputs/etopo5.cdf";
    if (!is_file(path)) GTEST_SKIP() << path << " has not been fetched";
    const auto bytes = read_file(path);
    ASSERT_TRUE(bytes.ok());
    const auto grid = read_netcdf(*bytes, path);
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_EQ(grid->width, 4320);
    EXPECT_EQ(grid->height, 2161);
    EXPECT_EQ(grid->low, -10376);
    EXPECT_EQ(grid->high, 7833);
    EXPECT_TRUE(grid->metres);
    EXPECT_TRUE(refuse_voids(*grid, path).ok());
    // Lhasa (29.67 N, 91.17 E) lies high, the Atlantic at 30 N, 50 W deep: row 0 is 90 S.
    const auto at = [&](double north, double east) {
        return grid->samples[static_cast<std::size_t>((north + 90) * 12) * 4320 +
                             static_cast<std::size_t>(east * 12)];
    };
    EXPECT_GT(at(29.67, 91.17), 3000);
    EXPECT_LT(at(30, 310), -3000);
}

TEST(RealFiles, TheVolcanoHasItsKnownContent) {
    const std::string path = "inputs/volcano.json";
    if (!is_file(path)) GTEST_SKIP() << path << " has not been fetched";
    const auto bytes = read_file(path);
    ASSERT_TRUE(bytes.ok());
    const auto grid = read_json_grid(*bytes, path);
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_EQ(grid->width, 87);
    EXPECT_EQ(grid->height, 61);
    EXPECT_EQ(grid->low, 94);
    EXPECT_EQ(grid->high, 195);
}

}  // namespace
}  // namespace repousse::host
