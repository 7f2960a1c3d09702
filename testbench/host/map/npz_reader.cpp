#include "testbench/host/map/npz_reader.h"

#include <cstring>

#include "testbench/host/map/zip_archive.h"

namespace repousse::host {
namespace {

constexpr const char* kMember = "elevation.npy";
constexpr std::uint64_t kLimitBytes = std::uint64_t{8} * kMaxMapSide * kMaxMapSide;

Error at(const std::string& name, std::size_t offset, std::string what, std::string expected) {
    return {ErrorKind::Input, name + ": offset " + std::to_string(offset), std::move(what),
            std::move(expected), ""};
}

std::uint64_t little(const std::string& bytes, std::size_t from, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = count; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[from + i]);
    }
    return value;
}

/// What follows `'key':` in the header, up to the next comma outside brackets, without blanks.
std::string header_value(const std::string& header, const std::string& key) {
    std::size_t i = header.find("'" + key + "'");
    if (i == std::string::npos) return {};
    i = header.find(':', i);
    std::string value;
    int depth = 0;
    for (++i; i < header.size() && (depth > 0 || (header[i] != ',' && header[i] != '}')); ++i) {
        if (header[i] == '(') ++depth;
        if (header[i] == ')') --depth;
        if (header[i] != ' ') value += header[i];
    }
    return value;
}

/// "(rows,columns)" into two sizes; false unless there are exactly two of at most five digits.
bool parse_shape(const std::string& text, int& rows, int& columns) {
    long sizes[2] = {0, 0};
    std::size_t i = 1;
    if (text.empty() || text[0] != '(') return false;
    for (int k = 0; k < 2; ++k) {
        const std::size_t start = i;
        while (i < text.size() && text[i] >= '0' && text[i] <= '9' && i - start < 6) {
            sizes[k] = 10 * sizes[k] + (text[i++] - '0');
        }
        if (i == start || i >= text.size() || text[i] != (k == 0 ? ',' : ')')) return false;
        ++i;
    }
    rows = static_cast<int>(sizes[0]);
    columns = static_cast<int>(sizes[1]);
    return true;
}

double sample(const std::string& type, const std::string& bytes, std::size_t from) {
    if (type == "<i2") return static_cast<std::int16_t>(little(bytes, from, 2));
    if (type == "<u2") return static_cast<double>(little(bytes, from, 2));
    if (type == "<i4") return static_cast<std::int32_t>(little(bytes, from, 4));
    if (type == "<f4") {
        const auto word = static_cast<std::uint32_t>(little(bytes, from, 4));
        float value = 0.0f;
        std::memcpy(&value, &word, sizeof value);
        return value;
    }
    const std::uint64_t word = little(bytes, from, 8);
    double value = 0.0;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

/// Bytes a sample of a type string, 0 for a type that is not read.
std::size_t sample_size(const std::string& type) {
    if (type == "<i2" || type == "<u2") return 2;
    if (type == "<i4" || type == "<f4") return 4;
    return type == "<f8" ? 8 : 0;
}

}  // namespace

Result<ElevationGrid> read_npy(const std::string& bytes, const std::string& name) {
    // Magic, version, header length (2 bytes in version 1, 4 later), a Python dictionary as text.
    if (bytes.compare(0, 6, "\x93NUMPY") != 0 || bytes.size() < 12) {
        return at(name, 0, "this is no NumPy array", "the .npy magic bytes");
    }
    const std::size_t length_bytes = bytes[6] == 1 ? 2 : 4;
    const std::size_t header_at = 8 + length_bytes;
    const std::size_t header_size = little(bytes, 8, length_bytes);
    if (header_size > bytes.size() - header_at) {
        return at(name, 8, "the .npy header is truncated",
                  std::to_string(header_size) + " bytes of header");
    }
    const std::string header = bytes.substr(header_at, header_size);
    std::string type = header_value(header, "descr");
    if (type.size() > 2) type = type.substr(1, type.size() - 2);
    const std::size_t each = sample_size(type);
    if (each == 0) {
        return at(name, header_at, "samples of type \"" + type + "\" are not read",
                  "<i2, <u2, <i4, <f4 or <f8");
    }
    if (header_value(header, "fortran_order") != "False") {
        return at(name, header_at, "the array is in Fortran order", "C order");
    }
    ElevationGrid grid;
    const std::string shape = header_value(header, "shape");
    if (!parse_shape(shape, grid.height, grid.width)) {
        return at(name, header_at, "the array's shape is " + shape, "(rows, columns)");
    }
    const bool fits = grid.width >= 1 && grid.height >= 1 && grid.width <= kMaxMapSide &&
                      grid.height <= kMaxMapSide;
    if (!fits) {
        return at(name, header_at, "the array's shape is " + shape,
                  "1.." + std::to_string(kMaxMapSide) + " rows and columns");
    }
    const std::size_t count =
        static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    const std::size_t data = header_at + header_size;
    if (bytes.size() - data < count * each) {
        return at(name, bytes.size(), "the array's data is truncated",
                  std::to_string(count * each) + " bytes after the header");
    }
    grid.samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        grid.samples.push_back(sample(type, bytes, data + i * each));
    }
    grid.metres = true;
    measure_range(grid);
    return grid;
}

Result<ElevationGrid> read_npz(const std::string& bytes, const std::string& name) {
    const Result<std::string> member = read_zip_member(bytes, kMember, kLimitBytes, name);
    if (!member.ok()) return member.error();
    return read_npy(*member, name + "(" + kMember + ")");
}

}  // namespace repousse::host
