#include <cmath>
#include <cstring>
#include <string_view>

#include "testbench/host/mesh/mesh_builder.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/ply_header.h"
#include "testbench/host/mesh/text_reader.h"

namespace repousse::host {
namespace {

/// The body of a PLY file as a stream of numbers, text or binary. Every type fits a double exactly.
class PlyBody {
public:
    PlyBody(const std::string& bytes, const PlyHeader& header, const std::string& name)
        : bytes_(bytes),
          format_(header.format),
          name_(name),
          at_(header.size_bytes),
          text_(bytes, name) {
        for (int i = 0; i < header.lines; ++i) text_.skip_line();
    }

    Result<double> next(PlyType type, const char* what) {
        if (format_ == PlyFormat::Ascii) {
            return text_.number(what, false);
        }
        last_ = at_;
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size) return error("the file ends here", what);
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < size; ++i) {
            const std::size_t from = format_ == PlyFormat::LittleEndian ? size - 1 - i : i;
            word = word << 8 | static_cast<unsigned char>(bytes_[at_ + from]);
        }
        at_ += size;
        return as_double(word, type);
    }

    /// An error at the number read last: line and column in text, offset in binary.
    Error error(const std::string& what, const std::string& expected) const {
        if (format_ == PlyFormat::Ascii) return text_.error(what, expected);
        return {ErrorKind::Input, name_ + ": offset " + std::to_string(last_), what, expected, ""};
    }

    std::size_t bytes_left() const {
        return format_ == PlyFormat::Ascii ? text_.bytes_left() : bytes_.size() - at_;
    }

private:
    static double as_double(std::uint64_t word, PlyType type) {
        switch (type) {
            case PlyType::Int8:
                return static_cast<std::int8_t>(word);
            case PlyType::Int16:
                return static_cast<std::int16_t>(word);
            case PlyType::Int32:
                return static_cast<std::int32_t>(word);
            case PlyType::Uint8:
            case PlyType::Uint16:
            case PlyType::Uint32:
                return static_cast<double>(word);
            case PlyType::Float: {
                const auto narrow = static_cast<std::uint32_t>(word);
                float value = 0.0f;
                std::memcpy(&value, &narrow, sizeof value);
                return value;
            }
            case PlyType::Double: {
                double value = 0.0;
                std::memcpy(&value, &word, sizeof value);
                return value;
            }
        }
        return 0.0;
    }

    const std::string& bytes_;
    PlyFormat format_;
    std::string name_;
    std::size_t at_;
    std::size_t last_ = 0;
    TextReader text_;
};

/// Reads one element's properties; scalars into `values`, the list `wanted` into `items`.
Status read_properties(PlyBody& body, const PlyElement& element, int wanted,
                       std::vector<double>& values, std::vector<double>& items) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (!property.list) {
            const Result<double> value = body.next(property.type, property.name.c_str());
            if (!value.ok()) return value.error();
            if (!std::isfinite(*value)) {
                return body.error(property.name + " is not finite", "a finite number");
            }
            values[k] = *value;
            continue;
        }
        const Result<double> count = body.next(property.count_type, "a list's length");
        if (!count.ok()) return count.error();
        if (!(*count >= 0.0) || *count > static_cast<double>(body.bytes_left())) {
            return body.error("a list of " + std::to_string(static_cast<std::int64_t>(*count)) +
                                  " items, more than the file can hold",
                              "a complete file");
        }
        if (static_cast<int>(k) == wanted) items.clear();
        for (double i = 0.0; i < *count; i += 1.0) {
            const Result<double> value = body.next(property.type, "a list item");
            if (!value.ok()) return value.error();
            if (static_cast<int>(k) != wanted) continue;
            items.push_back(*value);
            // Indices are checked where they stand, so that the error names the place.
            if (*value != std::floor(*value)) {
                return body.error("an index is not an integer", "a vertex index");
            }
        }
    }
    return done();
}

Status read_vertices(PlyBody& body, const PlyElement& element, const std::string& name,
                     Mesh& mesh) {
    const int at[8] = {element.find({"x"}),
                       element.find({"y"}),
                       element.find({"z"}),
                       element.find({"nx"}),
                       element.find({"ny"}),
                       element.find({"nz"}),
                       element.find({"u", "s", "texture_u"}),
                       element.find({"v", "t", "texture_v"})};
    for (int k = 0; k < 8; ++k) {
        const bool list = at[k] >= 0 && element.properties[static_cast<std::size_t>(at[k])].list;
        if (list || (k < 3 && at[k] < 0)) {
            return Error{ErrorKind::Input, name, "the vertex element lacks a scalar x, y or z",
                         "properties x, y and z (and nx, ny, nz, u, v as scalars)", ""};
        }
    }
    const bool normals = at[3] >= 0 && at[4] >= 0 && at[5] >= 0;
    const bool uv = at[6] >= 0 && at[7] >= 0;
    std::vector<double> values(element.properties.size(), 0.0);
    std::vector<double> items;
    mesh.positions.reserve(static_cast<std::size_t>(element.count));
    for (std::int64_t i = 0; i < element.count; ++i) {
        const Status status = read_properties(body, element, -1, values, items);
        if (!status.ok()) return status.error();
        auto pick = [&](int k) { return values[static_cast<std::size_t>(at[k])]; };
        mesh.positions.emplace_back(pick(0), pick(1), pick(2));
        if (normals) mesh.normals.emplace_back(pick(3), pick(4), pick(5));
        if (uv) mesh.uv.emplace_back(pick(6), pick(7));
    }
    return done();
}

Status read_faces(PlyBody& body, const PlyElement& element, Mesh& mesh) {
    const int wanted = element.find({"vertex_indices", "vertex_index"});
    std::vector<double> values(element.properties.size(), 0.0);
    std::vector<double> items;
    std::vector<std::uint32_t> corners;
    const auto count = static_cast<double>(mesh.positions.size());
    for (std::int64_t i = 0; i < element.count; ++i) {
        const Status status = read_properties(body, element, wanted, values, items);
        if (!status.ok()) return status.error();
        if (items.size() < 3) {
            return body.error(
                "face " + std::to_string(i) + " has " + std::to_string(items.size()) + " corners",
                "at least 3");
        }
        corners.clear();
        for (const double index : items) {
            if (!(index >= 0.0 && index < count)) {
                return body.error("vertex index " +
                                      std::to_string(static_cast<std::int64_t>(index)) +
                                      " of face " + std::to_string(i) + " is out of range",
                                  "0.." + std::to_string(mesh.positions.size() - 1));
            }
            corners.push_back(static_cast<std::uint32_t>(index));
        }
        add_fan(mesh, corners);
    }
    return done();
}

}  // namespace

Result<Mesh> read_ply(const std::string& bytes, const std::string& name) {
    const Result<PlyHeader> header = read_ply_header(bytes, name);
    if (!header.ok()) return header.error();
    PlyBody body(bytes, *header, name);
    Mesh mesh;
    bool seen_vertices = false;
    for (const PlyElement& element : header->elements) {
        Status status = done();
        if (element.name == "vertex") {
            status = read_vertices(body, element, name, mesh);
            seen_vertices = true;
        } else if (element.name == "face") {
            const int list = element.find({"vertex_indices", "vertex_index"});
            if (!seen_vertices || list < 0 ||
                !element.properties[static_cast<std::size_t>(list)].list) {
                return Error{ErrorKind::Input, name, "the face element cannot be read",
                             "a list vertex_indices, after the vertices", ""};
            }
            status = read_faces(body, element, mesh);
        } else if (!element.properties.empty()) {
            std::vector<double> values(element.properties.size());
            std::vector<double> items;
            for (std::int64_t i = 0; i < element.count && status.ok(); ++i) {
                status = read_properties(body, element, -1, values, items);
            }
        }
        if (!status.ok()) return status.error();
    }
    return finish_mesh(std::move(mesh), name);
}

}  // namespace repousse::host
