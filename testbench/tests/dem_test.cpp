// The elevation file's format: ZIP archive, NumPy array, and what is wrong with broken ones.
#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <zlib.h>

#include "testbench/host/files.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/map/zip_archive.h"

namespace repousse::host {
namespace {

std::string little(std::uint64_t value, int count) {
    std::string bytes;
    for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> (8 * i) & 0xFF);
    return bytes;
}

std::string npy(const std::string& type, const std::string& shape, const std::string& data) {
    std::string header =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
    header += std::string(63 - (10 + header.size()) % 64, ' ') + "\n";
    return std::string("\x93NUMPY\x01\0", 8) + little(header.size(), 2) + header + data;
}

std::string deflated(const std::string& data) {
    std::string packed(compressBound(data.size()), '\0');
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string input = data;
    stream.next_in = reinterpret_cast<Bytef*>(&input[0]);
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

/// An archive with one deflated member; `claim` overrides its unpacked size.
std::string zip(const std::string& name, const std::string& data, std::uint64_t claim = ~0ull) {
    const std::string packed = deflated(data);
    const std::uint64_t size = claim == ~0ull ? data.size() : claim;
    const auto crc =
        crc32(0, reinterpret_cast<const Bytef*>(data.data()), static_cast<uInt>(data.size()));
    const std::string common = little(20, 2) + little(0, 2) + little(8, 2) + little(0, 4) +
                               little(crc, 4) + little(packed.size(), 4) + little(size, 4) +
                               little(name.size(), 2) + little(0, 2);
    const std::string local = "PK\x03\x04" + common + name + packed;
    const std::string entry = "PK\x01\x02" + little(20, 2) + common + little(0, 2) + little(0, 2) +
                              little(0, 2) + little(0, 4) + little(0, 4) + name;
    return local + entry + "PK\x05\x06" + little(0, 4) + little(1, 2) + little(1, 2) +
           little(entry.size(), 4) + little(local.size(), 4) + little(0, 2);
}

const std::string kSamples =
    little(0xFFFE, 2) + little(5, 2) + little(100, 2) + little(0, 2) + little(7, 2) + little(9, 2);

std::string message(const Result<ElevationGrid>& grid) {
    return grid.ok() ? "(accepted)" : grid.error().message();
}

TEST(Npz, ReadsSignedSamplesInRowOrder) {
    const auto grid = read_npz(zip("elevation.npy", npy("<i2", "(2, 3)", kSamples)), "d.npz");
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_EQ(grid->width, 3);
    EXPECT_EQ(grid->height, 2);
    EXPECT_EQ(grid->samples, (std::vector<double>{-2, 5, 100, 0, 7, 9}));
    EXPECT_EQ(grid->low, -2.0);
    EXPECT_EQ(grid->high, 100.0);
    EXPECT_TRUE(grid->metres);
}

TEST(Npz, RefusesBrokenArchives) {
    const std::string good = zip("elevation.npy", npy("<i2", "(2, 3)", kSamples));
    for (std::size_t size = 0; size < good.size(); ++size) {
        const auto grid = read_npz(good.substr(0, size), "d.npz");
        ASSERT_FALSE(grid.ok()) << size;
        EXPECT_EQ(grid.error().where.substr(0, 14), "d.npz: offset ");
    }
    // One bit changed anywhere is either harmless (times, versions) or refused, never a crash.
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x10);
        const auto grid = read_npz(bad, "d.npz");
        EXPECT_TRUE(!grid.ok() || grid->samples.size() == 6u) << at;
    }
    EXPECT_EQ(message(read_npz(zip("other.npy", "x"), "d.npz")).substr(0, 12), "d.npz: offse");
    EXPECT_NE(message(read_npz(zip("other.npy", "x"), "d.npz")).find("other.npy"),
              std::string::npos);
}

TEST(Npz, RefusesFalseSizesBeforeAllocating) {
    const std::string array = npy("<i2", "(2, 3)", kSamples);
    const auto bomb = read_npz(zip("elevation.npy", array, 0xFFFFFFF0u), "d.npz");
    EXPECT_NE(message(bomb).find("the ZIP member claims 4294967280 bytes"), std::string::npos);
    const auto longer = read_npz(zip("elevation.npy", array, 1000000), "d.npz");
    EXPECT_NE(message(longer).find("truncated or its size is wrong"), std::string::npos);
    const auto shorter = read_npz(zip("elevation.npy", array, array.size() - 1), "d.npz");
    EXPECT_NE(message(shorter).find("damaged"), std::string::npos);
}

TEST(Npy, RefusesWhatItCannotRead) {
    EXPECT_NE(
        message(read_npy(npy("<i2", "(100000, 100000)", kSamples), "d")).find("expected 1..16384"),
        std::string::npos);
    EXPECT_NE(message(read_npy(npy("<i2", "(2, 4)", kSamples), "d")).find("truncated"),
              std::string::npos);
    EXPECT_NE(message(read_npy(npy("<i2", "(6,)", kSamples), "d")).find("shape"),
              std::string::npos);
    EXPECT_NE(message(read_npy(npy("<i2", "(1, 2, 3)", kSamples), "d")).find("shape"),
              std::string::npos);
    EXPECT_NE(message(read_npy(npy("<c8", "(2, 3)", kSamples), "d")).find("\"<c8\""),
              std::string::npos);
    EXPECT_NE(message(read_npy(npy("<i2", "(0, 3)", ""), "d")).find("1..16384"), std::string::npos);
}

TEST(Npy, LeavesVoidsInTheGrid) {
    const std::string nan = little(0x7FC00000u, 4);
    const auto grid = read_npy(npy("<f4", "(1, 1)", nan), "d");
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_TRUE(std::isnan(grid->samples[0]));
}

TEST(Jacksboro, TheRealFileHasItsKnownContent) {
    const std::string path = "inputs/jacksboro_fault_dem.npz";
    if (!is_file(path)) GTEST_SKIP() << path << " has not been fetched";
    const auto bytes = read_file(path);
    ASSERT_TRUE(bytes.ok());
    const auto grid = read_npz(*bytes, path);
    ASSERT_TRUE(grid.ok()) << message(grid);
    EXPECT_EQ(grid->width, 403);
    EXPECT_EQ(grid->height, 344);
    EXPECT_EQ(grid->low, 236.0);
    EXPECT_EQ(grid->high, 1076.0);
    const HeightMap map = quantise(*grid);
    std::uint64_t sum = 0;
    for (const std::uint16_t h : map.texels) sum += h;
    EXPECT_GT(sum, 1ull << 31);  // needs more than 31 bits: the table is not a float's job
    EXPECT_EQ(map.at(0, 0), static_cast<int>((grid->samples[0] - 236) * 65535 / 840 + .5));
}

}  // namespace
}  // namespace repousse::host
