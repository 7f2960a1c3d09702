#include "testbench/host/image/picture_file.h"

#include <filesystem>
#include <memory>

#include <OpenImageIO/imageio.h>

namespace repousse::host {
namespace {

Error failed(const std::string& path, const std::string& why) {
    return {ErrorKind::Environment, path, "the picture cannot be written: " + why, "", ""};
}

/// Writes through OpenImageIO to a file beside `path`, whose extension must stay the last part of
/// the name because it selects the format, then renames.
Status write_through(const std::string& path, const std::string& extension,
                     const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels) {
    namespace fs = std::filesystem;
    const std::string part = path + ".part" + extension;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(part);
    if (!output) return failed(path, OIIO::geterror());
    std::error_code code;
    const bool opened = output->open(part, spec);
    const bool written = opened && output->write_image(type, pixels);
    const std::string why = output->geterror();
    const bool closed = opened && output->close();
    if (written && closed) {
        fs::rename(part, path, code);
        if (!code) return done();
    }
    std::error_code ignored;
    fs::remove(part, ignored);
    return failed(path, code ? code.message() : why.empty() ? "unknown reason" : why);
}

}  // namespace

Status write_png(const std::string& path, const Picture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 9);
    const std::vector<std::uint8_t> bytes = to_srgb8(picture);
    return write_through(path, ".png", spec, OIIO::TypeDesc::UINT8, bytes.data());
}

Status write_exr(const std::string& path, const Picture& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::HALF);
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    return write_through(path, ".exr", spec, OIIO::TypeDesc::FLOAT, picture.rgb.data());
}

}  // namespace repousse::host
