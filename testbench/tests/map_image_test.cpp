// Images as maps, and pictures as images.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "testbench/host/files.h"
#include "testbench/host/image/image_map.h"
#include "testbench/host/image/picture_file.h"
#include "testbench/host/map/voids.h"

namespace repousse::host {
namespace {

std::string temp(const std::string& name) { return testing::TempDir() + "/" + name; }

template <class T>
void write(const std::string& path, int width, int height, OIIO::TypeDesc type,
           const std::vector<T>& samples) {
    auto output = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->open(path, OIIO::ImageSpec(width, height, 1, type)));
    ASSERT_TRUE(output->write_image(OIIO::BaseTypeFromC<T>::value, samples.data()));
    ASSERT_TRUE(output->close());
}

std::string message(const std::string& path) {
    const auto grid = read_image_grid(path, {});
    return grid.ok() ? "(accepted)" : grid.error().message();
}

TEST(ImageMap, SixteenBitSamplesPassUnchanged) {
    std::vector<std::uint16_t> samples;
    for (int i = 0; i < 65536; i += 16) samples.push_back(static_cast<std::uint16_t>(i + i / 4096));
    for (const char* name : {"m.png", "m.tif"}) {
        write(temp(name), 64, 64, OIIO::TypeDesc::UINT16, samples);
        const auto grid = read_image_grid(temp(name), {});
        ASSERT_TRUE(grid.ok()) << grid.error().message();
        EXPECT_EQ(grid->width, 64);
        EXPECT_EQ(quantise(*grid).texels, samples) << name;
    }
}

TEST(ImageMap, EightBitSpansTheWholeRange) {
    write(temp("b.png"), 4, 1, OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>{0, 1, 128, 255});
    const auto grid = read_image_grid(temp("b.png"), {});
    ASSERT_TRUE(grid.ok());
    EXPECT_EQ(quantise(*grid).texels, (std::vector<std::uint16_t>{0, 257, 128 * 257, 65535}));
}

TEST(ImageMap, FloatsSpanTheirMeasuredOrDeclaredRange) {
    write(temp("f.exr"), 3, 1, OIIO::TypeDesc::FLOAT, std::vector<float>{-2.0f, 0.0f, 2.0f});
    const auto measured = read_image_grid(temp("f.exr"), {});
    ASSERT_TRUE(measured.ok()) << measured.error().message();
    EXPECT_EQ(quantise(*measured).texels, (std::vector<std::uint16_t>{0, 32768, 65535}));
    const auto declared = read_image_grid(temp("f.exr"), glm::dvec2(0.0, 4.0));
    ASSERT_TRUE(declared.ok());
    EXPECT_EQ(quantise(*declared).texels, (std::vector<std::uint16_t>{0, 0, 32768}));
}

TEST(ImageMap, SignedElevationsKeepTheirUnit) {
    write(temp("s.tif"), 3, 1, OIIO::TypeDesc::INT16, std::vector<std::int16_t>{-100, 236, 1076});
    const auto grid = read_image_grid(temp("s.tif"), {});
    ASSERT_TRUE(grid.ok()) << grid.error().message();
    EXPECT_EQ(grid->samples, (std::vector<double>{-100, 236, 1076}));
    EXPECT_EQ(grid->low, -100.0);
}

TEST(ImageMap, NotFiniteTexelsStayAndAreOutsideTheRange) {
    std::vector<float> samples(12, 0.5f);
    samples[0] = -1.0f;
    samples[4 + 2] = std::numeric_limits<float>::quiet_NaN();
    samples[4 + 3] = std::numeric_limits<float>::infinity();
    write(temp("n.exr"), 4, 3, OIIO::TypeDesc::FLOAT, samples);
    const auto grid = read_image_grid(temp("n.exr"), {});
    ASSERT_TRUE(grid.ok()) << grid.error().message();
    EXPECT_TRUE(std::isnan(grid->samples[6]));
    EXPECT_EQ(grid->low, -1.0);
    EXPECT_EQ(grid->high, 0.5);
    EXPECT_EQ(refuse_voids(*grid, "n.exr").error().message(),
              "n.exr: texel (2, 1) is not finite, expected finite heights; fill_voids = true fills "
              "such texels");
}

TEST(ImageMap, RefusesMissingEmptyAndForeignFiles) {
    EXPECT_EQ(message(temp("none.png")),
              temp("none.png") + ": no such file, expected an image file");
    std::ofstream(temp("empty.png")).flush();
    EXPECT_EQ(
        message(temp("empty.png")),
        temp("empty.png") + ": offset 0: the image file is empty (0 bytes), expected an image");
    std::ofstream(temp("text.png")) << "this is not a picture";
    EXPECT_NE(message(temp("text.png")).find("not a readable image"), std::string::npos);
}

std::string big(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
    return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string body = type + data;
    return big(static_cast<std::uint32_t>(data.size())) + body +
           big(static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()),
                                                static_cast<uInt>(body.size()))));
}

TEST(ImageMap, RefusesAHeaderThatClaimsTooMuchWithoutReadingIt) {
    const std::string header = big(100000) + big(100000) + std::string("\x10\0\0\0\0", 5);
    std::ofstream(temp("huge.png"), std::ios::binary)
        << "\x89PNG\r\n\x1a\n"
        << chunk("IHDR", header)
        << chunk("IDAT", std::string("\x78\x9c\x03\x00\x00\x00\x00\x01", 8)) << chunk("IEND", "");
    EXPECT_EQ(message(temp("huge.png")),
              temp("huge.png") +
                  ": the image header claims 100000 x 100000 texels, expected sides of "
                  "1..16384");
}

TEST(ImageMap, RefusesATruncatedImage) {
    std::vector<std::uint16_t> samples(256 * 256);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = static_cast<std::uint16_t>(i * 40503u >> 3);
    }
    write(temp("whole.png"), 256, 256, OIIO::TypeDesc::UINT16, samples);
    const auto bytes = read_file(temp("whole.png"));
    ASSERT_TRUE(bytes.ok());
    std::ofstream(temp("half.png"), std::ios::binary) << bytes->substr(0, bytes->size() / 2);
    EXPECT_NE(message(temp("half.png")).find("damaged or truncated"), std::string::npos);
}

Picture gradient() {
    Picture picture;
    picture.width = 16;
    picture.height = 8;
    for (int i = 0; i < 16 * 8 * 3; ++i) picture.rgb.push_back(static_cast<float>(i) / 384.0f);
    return picture;
}

TEST(PictureFile, TheSamePictureGivesTheSameBytesAndLeavesNoPart) {
    ASSERT_TRUE(write_png(temp("a.png"), gradient()).ok());
    ASSERT_TRUE(write_png(temp("b2.png"), gradient()).ok());
    ASSERT_TRUE(write_exr(temp("a.exr"), gradient()).ok());
    EXPECT_EQ(*read_file(temp("a.png")), *read_file(temp("b2.png")));
    EXPECT_FALSE(is_file(temp("a.png.part.png")));
    const auto input = OIIO::ImageInput::open(temp("a.png"));
    ASSERT_TRUE(input);
    EXPECT_EQ(input->spec().width, 16);
    std::vector<std::uint8_t> bytes(16 * 8 * 3);
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, bytes.data()));
    EXPECT_EQ(bytes, to_srgb8(gradient()));
}

TEST(PictureFile, AFailedWriteIsAnEnvironmentErrorAndKeepsTheOldFile) {
    const Status status = write_png("no/such/folder/a.png", gradient());
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().kind, ErrorKind::Environment);
    EXPECT_EQ(write_file("no/such/folder/a.txt", "x").error().kind, ErrorKind::Environment);
}

}  // namespace
}  // namespace repousse::host
