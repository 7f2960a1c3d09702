// Elevation files other than .npz: JSON and classic netCDF, whole and broken.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/files.h"
#include "testbench/host/map/json_reader.h"
#include "testbench/host/map/netcdf_reader.h"
#include "testbench/host/map/voids.h"

namespace repousse::host {
namespace {

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
