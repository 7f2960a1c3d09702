#include "testbench/host/image/image_map.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include <OpenImageIO/imageio.h>

#include "testbench/host/files.h"

namespace repousse::host {
namespace {

Error bad(const std::string& path, std::string what, std::string expected) {
    return {ErrorKind::Input, path, std::move(what), std::move(expected), ""};
}

/// First line of OpenImageIO's message: the rest repeats it.
std::string first_line(std::string text) {
    const std::size_t end = text.find('\n');
    if (end != std::string::npos) text.erase(end);
    return text.empty() ? "unknown reason" : text;
}

Status check_spec(const std::string& path, const OIIO::ImageSpec& spec) {
    const bool fits = spec.width >= 1 && spec.height >= 1 && spec.width <= kMaxMapSide &&
                      spec.height <= kMaxMapSide;
    if (!fits) {
        return bad(path,
                   "the image header claims " + std::to_string(spec.width) + " x " +
                       std::to_string(spec.height) + " texels",
                   "sides of 1.." + std::to_string(kMaxMapSide));
    }
    if (spec.depth > 1 || spec.deep) return bad(path, "a volume or deep image", "a flat image");
    if (spec.nchannels < 1 || spec.nchannels > 64) {
        return bad(path, "the image has " + std::to_string(spec.nchannels) + " channels", "1..64");
    }
    switch (spec.format.basetype) {
        case OIIO::TypeDesc::UINT8:
        case OIIO::TypeDesc::UINT16:
        case OIIO::TypeDesc::INT16:
        case OIIO::TypeDesc::HALF:
        case OIIO::TypeDesc::FLOAT:
        case OIIO::TypeDesc::DOUBLE:
            break;
        default:
            return bad(path, std::string("samples of type ") + spec.format.c_str(),
                       "uint8, uint16, int16, half, float or double");
    }
    return done();
}

/// The sample values that become heights 0 and 65535, for integer types; nothing for floats.
std::optional<glm::dvec2> type_range(OIIO::TypeDesc type) {
    switch (type.basetype) {
        case OIIO::TypeDesc::UINT8:
            return glm::dvec2(0.0, 255.0);
        case OIIO::TypeDesc::UINT16:
            return glm::dvec2(0.0, 65535.0);
        default:
            return std::nullopt;
    }
}

/// Channel 0 as doubles, one scan line band at a time in the file's own precision: integers come
/// as 16 bits, so that no normalisation to 0..1 rounds them.
Status read_samples(OIIO::ImageInput& input, const std::string& path, ElevationGrid& grid) {
    const std::size_t count =
        static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    grid.samples.resize(count);
    const OIIO::TypeDesc type = input.spec().format;
    bool read = false;
    if (type == OIIO::TypeDesc::INT16) {
        std::vector<std::int16_t> words(count);
        read = input.read_image(0, 0, 0, 1, OIIO::TypeDesc::INT16, words.data());
        std::copy(words.begin(), words.end(), grid.samples.begin());
    } else if (type == OIIO::TypeDesc::UINT8 || type == OIIO::TypeDesc::UINT16) {
        std::vector<std::uint16_t> words(count);
        read = input.read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT16, words.data());
        const double scale = type == OIIO::TypeDesc::UINT8 ? 1.0 / 257.0 : 1.0;
        for (std::size_t i = 0; i < count; ++i)
            grid.samples[i] = std::floor(words[i] * scale + 0.5);
    } else {
        std::vector<float> floats(count);
        read = input.read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, floats.data());
        for (std::size_t i = 0; i < count; ++i) grid.samples[i] = static_cast<double>(floats[i]);
    }
    if (read) return done();
    return bad(path, "the image is damaged or truncated: " + first_line(input.geterror()),
               "complete image data");
}

}  // namespace

Result<ElevationGrid> read_image_grid(const std::string& path, std::optional<glm::dvec2> samples) {
    if (!is_file(path)) return bad(path, "no such file", "an image file");
    std::error_code code;
    if (std::filesystem::file_size(path, code) == 0 && !code) {
        return Error{ErrorKind::Input, path + ": offset 0", "the image file is empty (0 bytes)",
                     "an image", ""};
    }
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
    if (!input) {
        return bad(path, "not a readable image: " + first_line(OIIO::geterror()),
                   "16-bit PNG, TIFF or OpenEXR");
    }
    Status status = check_spec(path, input->spec());
    if (!status.ok()) return status.error();
    ElevationGrid grid;
    grid.width = input->spec().width;
    grid.height = input->spec().height;
    status = read_samples(*input, path, grid);
    if (!status.ok()) return status.error();
    std::optional<glm::dvec2> range = samples;
    if (!range) range = type_range(input->spec().format);
    if (range) {
        grid.low = range->x;
        grid.high = range->y;
    } else {
        measure_range(grid);
    }
    return grid;
}

}  // namespace repousse::host
