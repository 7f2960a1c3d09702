#include "testbench/host/mesh/mesh_builder.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/text_reader.h"

namespace repousse::host {
namespace {

constexpr std::int64_t kMostElements = 0x7FFFFFFF;

/// The optional letters before OFF.
struct OffKind {
    bool uv = false;
    bool colour = false;
    bool normal = false;
};

Result<OffKind> read_kind(TextReader& text) {
    std::string word(text.anywhere());
    OffKind kind;
    if (word.compare(0, 2, "ST") == 0) kind.uv = true, word.erase(0, 2);
    if (word.compare(0, 1, "C") == 0) kind.colour = true, word.erase(0, 1);
    if (word.compare(0, 1, "N") == 0) kind.normal = true, word.erase(0, 1);
    if (word != "OFF") {
        const bool wide = word == "4OFF" || word == "nOFF" || word == "4nOFF";
        return text.error(wide ? "OFF of another dimension" : "this is no OFF header",
                          "OFF, with ST, C or N before it at most");
    }
    const std::string_view next = text.in_line();
    if (next == "BINARY") return text.error("binary OFF is not read", "text OFF");
    if (!next.empty()) return text.error("something after the header", "the end of the line");
    return kind;
}

/// One vertex a line: x y z, then the normal, the colour and the texture coordinates that the
/// header announced.
Status read_vertex(TextReader& text, const OffKind& kind, Mesh& mesh) {
    glm::dvec3 position(0.0);
    for (int k = 0; k < 3; ++k) {
        const Result<double> value = text.number("a vertex coordinate", k > 0);
        if (!value.ok()) return value.error();
        position[k] = *value;
    }
    std::vector<double> rest;
    for (std::string_view token = text.in_line(); !token.empty(); token = text.in_line()) {
        const auto value = parse_double(token);
        if (!value || !(*value - *value == 0.0)) {
            return text.error("\"" + std::string(token.substr(0, 32)) + "\" is not a finite number",
                              "a vertex attribute");
        }
        rest.push_back(*value);
    }
    const std::size_t needed = (kind.normal ? 3u : 0u) + (kind.uv ? 2u : 0u);
    const std::size_t most = needed + (kind.colour ? 4u : 0u);
    if (rest.size() < needed || rest.size() > most) {
        return text.error(
            "the vertex has " + std::to_string(3 + rest.size()) + " numbers",
            std::to_string(3 + needed) + (most > needed ? ".." + std::to_string(3 + most) : ""));
    }
    mesh.positions.push_back(position);
    if (kind.normal) mesh.normals.emplace_back(rest[0], rest[1], rest[2]);
    if (kind.uv) mesh.uv.emplace_back(rest[rest.size() - 2], rest[rest.size() - 1]);
    return done();
}

/// One face a line: a count, its indices, and an optional colour that is skipped.
Status read_face(TextReader& text, Mesh& mesh, std::vector<std::uint32_t>& corners) {
    const auto last = static_cast<std::int64_t>(mesh.positions.size()) - 1;
    // Each index takes two bytes at least, so a count cannot outrun the file.
    const auto most = static_cast<std::int64_t>(text.bytes_left());
    const Result<std::int64_t> count = text.integer("a face's corner count", 3, most, false);
    if (!count.ok()) return count.error();
    corners.clear();
    for (std::int64_t k = 0; k < *count; ++k) {
        const Result<std::int64_t> index = text.integer("a vertex index", 0, last);
        if (!index.ok()) return index.error();
        corners.push_back(static_cast<std::uint32_t>(*index));
    }
    add_fan(mesh, corners);
    text.skip_line();
    return done();
}

}  // namespace

Result<Mesh> read_off(const std::string& bytes, const std::string& name) {
    TextReader text(bytes, name);
    const Result<OffKind> kind = read_kind(text);
    if (!kind.ok()) return kind.error();
    std::int64_t counts[3] = {0, 0, 0};
    const char* const names[3] = {"the vertex count", "the face count", "the edge count"};
    for (int k = 0; k < 3; ++k) {
        const Result<std::int64_t> count = text.integer(names[k], 0, kMostElements, false);
        if (!count.ok()) return count.error();
        counts[k] = *count;
        // "0 0 0" and "3 0 1 2" are the shortest lines: 6 and 8 bytes with their ends.
        const std::int64_t bytes_each = k == 0 ? 6 : k == 1 ? 8 : 0;
        if (counts[k] * bytes_each > static_cast<std::int64_t>(text.bytes_left()) + 1) {
            return text.error(std::string(names[k]) + " " + std::to_string(counts[k]) +
                                  " is more than the file can hold",
                              "at most " + std::to_string(text.bytes_left() / 6));
        }
    }
    Mesh mesh;
    mesh.positions.reserve(static_cast<std::size_t>(counts[0]));
    mesh.triangles.reserve(static_cast<std::size_t>(counts[1]));
    for (std::int64_t i = 0; i < counts[0]; ++i) {
        const Status status = read_vertex(text, *kind, mesh);
        if (!status.ok()) return status.error();
    }
    std::vector<std::uint32_t> corners;
    for (std::int64_t i = 0; i < counts[1]; ++i) {
        const Status status = read_face(text, mesh, corners);
        if (!status.ok()) return status.error();
    }
    return finish_mesh(std::move(mesh), name);
}

}  // namespace repousse::host
