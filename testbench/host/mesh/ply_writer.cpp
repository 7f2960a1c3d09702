#include "testbench/host/mesh/ply_writer.h"

#include <cstring>

#include "testbench/host/files.h"
#include "testbench/host/view/picture.h"

namespace repousse::host {
namespace {

/// Appends numbers in little-endian order whatever the machine's own is.
class Bytes {
public:
    explicit Bytes(std::string header) : bytes_(std::move(header)) {}

    void word(std::uint64_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes_.push_back(static_cast<char>(value >> (8 * i) & 0xFF));
    }
    void number(double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        word(bits, 8);
    }
    void reserve(std::size_t more) { bytes_.reserve(bytes_.size() + more); }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

}  // namespace

std::string to_ply(const Mesh& mesh) {
    const bool normals = !mesh.normals.empty();
    const bool uv = !mesh.uv.empty();
    const bool colours = !mesh.colours.empty();
    std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                         std::to_string(mesh.positions.size()) +
                         "\nproperty double x\nproperty double y\nproperty double z\n";
    if (normals) header += "property double nx\nproperty double ny\nproperty double nz\n";
    if (uv) header += "property double u\nproperty double v\n";
    if (colours) header += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    header += "element face " + std::to_string(mesh.triangles.size()) +
              "\nproperty list uchar uint vertex_indices\nend_header\n";
    Bytes out(std::move(header));
    out.reserve(mesh.positions.size() * 64 + mesh.triangles.size() * 13);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        for (int k = 0; k < 3; ++k) out.number(mesh.positions[i][k]);
        for (int k = 0; normals && k < 3; ++k) out.number(mesh.normals[i][k]);
        for (int k = 0; uv && k < 2; ++k) out.number(mesh.uv[i][k]);
        for (int k = 0; colours && k < 3; ++k) out.word(to_srgb8(mesh.colours[i][k]), 1);
    }
    for (const auto& triangle : mesh.triangles) {
        out.word(3, 1);
        for (const std::uint32_t corner : triangle) out.word(corner, 4);
    }
    return out.take();
}

Status write_ply(const std::string& path, const Mesh& mesh) {
    return write_file(path, to_ply(mesh));
}

}  // namespace repousse::host
