#include "testbench/host/mesh/mesh_check.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <unordered_map>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace repousse::host {
namespace {

std::uint64_t bits_of(double value) {
    const double positive_zero = value + 0.0;  // -0 + 0 is +0; every other value is unchanged
    std::uint64_t bits = 0;
    std::memcpy(&bits, &positive_zero, sizeof bits);
    return bits;
}

using PositionBits = std::array<std::uint64_t, 3>;

struct PositionHash {
    std::size_t operator()(const PositionBits& bits) const {
        std::uint64_t hash = 0;
        for (const std::uint64_t word : bits) {
            hash = (hash ^ word) * 0x9E3779B97F4A7C15ull;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash);
    }
};

/// Uses of one edge by triangles: along low -> high and back.
struct EdgeUse {
    std::uint32_t forward = 0;
    std::uint32_t backward = 0;
};

/// Disjoint sets of vertices, for counting components.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0u);
    }
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

private:
    std::vector<std::uint32_t> parent_;
};

using EdgeTable = std::unordered_map<std::uint64_t, EdgeUse>;

void count_edge(EdgeTable& edges, std::uint32_t a, std::uint32_t b) {
    const std::uint64_t low = std::min(a, b);
    EdgeUse& use = edges[low << 32 | std::max(a, b)];
    ++(a < b ? use.forward : use.backward);
}

void judge_edges(const EdgeTable& edges, MeshDiagnosis& result) {
    result.edges = edges.size();
    for (const auto& entry : edges) {
        const std::uint32_t uses = entry.second.forward + entry.second.backward;
        if (uses == 1) ++result.boundary_edges;
        if (uses > 2) ++result.non_manifold_edges;
        if (uses == 2 && entry.second.forward != 1) ++result.inconsistent_edges;
    }
}

std::string count_of(std::size_t count, const char* singular) {
    return fmt::format("{} {}{}", count, singular, count == 1 ? "" : "s");
}

}  // namespace

std::vector<std::uint32_t> weld(const std::vector<glm::dvec3>& positions) {
    std::unordered_map<PositionBits, std::uint32_t, PositionHash> first;
    first.reserve(positions.size());
    std::vector<std::uint32_t> welded(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const PositionBits key{bits_of(positions[i].x), bits_of(positions[i].y),
                               bits_of(positions[i].z)};
        welded[i] = first.try_emplace(key, static_cast<std::uint32_t>(i)).first->second;
    }
    return welded;
}

MeshDiagnosis mesh_check(const Mesh& mesh) {
    MeshDiagnosis result;
    result.vertices = mesh.positions.size();
    result.triangles = mesh.triangles.size();
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    std::vector<bool> used(mesh.positions.size(), false);
    std::vector<bool> used_position(mesh.positions.size(), false);
    Sets sets(mesh.positions.size());
    EdgeTable edges;
    for (const auto& t : mesh.triangles) {
        for (const std::uint32_t corner : t) {
            used[corner] = true;
            used_position[welded[corner]] = true;
        }
        const std::array<std::uint32_t, 3> w{welded[t[0]], welded[t[1]], welded[t[2]]};
        sets.join(w[0], w[1]);
        sets.join(w[1], w[2]);
        const glm::dvec3 twice_area = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                                 mesh.positions[t[2]] - mesh.positions[t[0]]);
        const bool same = w[0] == w[1] || w[1] == w[2] || w[2] == w[0];
        if (same || twice_area == glm::dvec3(0.0)) ++result.degenerate_triangles;
        // A flat triangle of three distinct corners still holds its neighbours together; one with
        // equal corners has no edges of its own.
        if (same) continue;
        for (int k = 0; k < 3; ++k) count_edge(edges, w[k], w[(k + 1) % 3]);
    }
    judge_edges(edges, result);
    bool first = true;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        if (!used[i]) ++result.unused_vertices;
        if (!used_position[i]) continue;
        ++result.welded_vertices;
        if (sets.root(i) == i) ++result.components;
        const glm::dvec3& p = mesh.positions[i];
        result.low = first ? p : glm::min(result.low, p);
        result.high = first ? p : glm::max(result.high, p);
        first = false;
    }
    result.euler = static_cast<std::int64_t>(result.welded_vertices) -
                   static_cast<std::int64_t>(result.edges) +
                   static_cast<std::int64_t>(result.triangles);
    return result;
}

std::string describe(const MeshDiagnosis& d) {
    std::string text = d.closed() ? "closed" : "open";
    text += d.manifold() && d.oriented() ? " 2-manifold, " : " mesh, ";
    text += count_of(d.triangles, "triangle") + ", " + count_of(d.edges, "edge") + ", " +
            count_of(d.components, "component");
    if (!d.closed()) text += ", " + count_of(d.boundary_edges, "boundary edge");
    if (!d.manifold()) text += ", " + count_of(d.non_manifold_edges, "non-manifold edge");
    if (!d.oriented()) text += ", " + count_of(d.inconsistent_edges, "inconsistent edge");
    if (d.degenerate_triangles > 0) {
        text += ", " + count_of(d.degenerate_triangles, "degenerate triangle");
    }
    if (d.unused_vertices > 0) {
        text += fmt::format(", {} unused {}", d.unused_vertices,
                            d.unused_vertices == 1 ? "vertex" : "vertices");
    }
    return text;
}

}  // namespace repousse::host
