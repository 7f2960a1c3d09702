#include <array>
#include <map>
#include <set>

#include "testbench/host/mesh/mesh_builder.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/text_reader.h"

namespace repousse::host {
namespace {

/// Indices of one face corner into the file's three lists, 0-based; -1 = not given.
using Corner = std::array<std::int64_t, 3>;

class ObjReader {
public:
    ObjReader(const std::string& bytes, const std::string& name) : text_(bytes, name) {}

    Result<Mesh> read(const std::string& name) {
        do {
            const std::string word(text_.in_line());
            if (word.empty()) continue;
            const Status status = line(word);
            if (!status.ok()) return status.error();
        } while (text_.skip_line());
        return finish_mesh(std::move(mesh_), name);
    }

private:
    Status line(const std::string& word) {
        // Grouping, materials and points or lines say nothing about the surface.
        static const std::set<std::string> kSkipped{
            "g",   "o",     "s",        "usemtl",   "mtllib", "l",      "p",          "mg",
            "lod", "bevel", "c_interp", "d_interp", "maplib", "usemap", "shadow_obj", "trace_obj"};
        if (word == "v") return values(positions_, 3, 3, "a vertex coordinate");
        if (word == "vn") return values(normals_, 3, 3, "a normal's component");
        if (word == "vt") return values(uvs_, 1, 2, "a texture coordinate");
        if (word == "f") return face();
        if (kSkipped.count(word) > 0) return done();
        return text_.error("unknown element \"" + word + "\"", "v, vt, vn or f");
    }

    /// `least`..`most` numbers; what follows (w, vertex colours) is not part of the surface.
    Status values(std::vector<glm::dvec3>& list, int least, int most, const char* what) {
        glm::dvec3 value(0.0);
        for (int k = 0; k < most; ++k) {
            const Result<double> number = text_.number(what);
            if (!number.ok()) {
                if (k >= least && number.error().what == "the line ends here") break;
                return number.error();
            }
            value[k] = *number;
        }
        list.push_back(value);
        return done();
    }

    /// v, v/t, v//n or v/t/n; counts from 1, or backwards from the last element with -1.
    Result<Corner> corner(std::string_view token) {
        static const char* const kNames[3] = {"vertex", "texture coordinate", "normal"};
        const std::size_t sizes[3] = {positions_.size(), uvs_.size(), normals_.size()};
        Corner result{-1, -1, -1};
        for (int k = 0; k < 3; ++k) {
            const std::size_t slash = token.find('/');
            const std::string_view part = token.substr(0, slash);
            if (!part.empty() || k == 0) {
                const auto index = parse_integer(part);
                const auto size = static_cast<std::int64_t>(sizes[k]);
                if (!index) {
                    return text_.error(
                        "\"" + std::string(part.substr(0, 32)) + "\" is not an index",
                        "a corner v, v/vt, v//vn or v/vt/vn");
                }
                result[k] = *index < 0 ? size + *index : *index - 1;
                if (*index == 0 || result[k] < 0 || result[k] >= size) {
                    return text_.error(
                        std::string(kNames[k]) + " index " + std::to_string(*index) +
                            " is out of range",
                        "1.." + std::to_string(size) + " (or negative from the end)");
                }
            }
            if (slash == std::string_view::npos) return result;
            token.remove_prefix(slash + 1);
        }
        return text_.error("a corner with more than three indices", "v/vt/vn");
    }

    Status face() {
        std::vector<std::uint32_t> corners;
        for (std::string_view token = text_.in_line(); !token.empty(); token = text_.in_line()) {
            const Result<Corner> found = corner(token);
            if (!found.ok()) return found.error();
            const bool first = mesh_.positions.empty();
            if (first) {
                has_uv_ = (*found)[1] >= 0;
                has_normal_ = (*found)[2] >= 0;
            }
            if (has_uv_ != ((*found)[1] >= 0) || has_normal_ != ((*found)[2] >= 0)) {
                return text_.error("this corner's indices are unlike those before it",
                                   "texture coordinates and normals on all corners or on none");
            }
            corners.push_back(vertex(*found));
        }
        if (corners.size() < 3) {
            return text_.error("a face with " + std::to_string(corners.size()) + " corners",
                               "at least 3");
        }
        add_fan(mesh_, corners);
        return done();
    }

    std::uint32_t vertex(const Corner& corner) {
        const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
        const auto [place, fresh] = vertices_.try_emplace(corner, next);
        if (!fresh) return place->second;
        mesh_.positions.push_back(positions_[static_cast<std::size_t>(corner[0])]);
        if (has_uv_) mesh_.uv.emplace_back(uvs_[static_cast<std::size_t>(corner[1])]);
        if (has_normal_) mesh_.normals.push_back(normals_[static_cast<std::size_t>(corner[2])]);
        return next;
    }

    TextReader text_;
    std::vector<glm::dvec3> positions_, uvs_, normals_;
    std::map<Corner, std::uint32_t> vertices_;
    bool has_uv_ = false;
    bool has_normal_ = false;
    Mesh mesh_;
};

}  // namespace

Result<Mesh> read_obj(const std::string& bytes, const std::string& name) {
    return ObjReader(bytes, name).read(name);
}

}  // namespace repousse::host
