#include "testbench/reference/fine_mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace repousse::reference {

// Kind in the top 2 bits, then 24 + 24 + 14 bits for an edge, 24 + 14 + 14 inside.
FineMeshChecker::Key FineMeshChecker::key_of(const FineName& name) {
    const auto field = [](int32_t x) { return static_cast<Key>(x + 8192) & 0x3FFF; };
    switch (name.kind) {
        case FineName::Kind::Vertex:
            return name.first;
        case FineName::Kind::Edge:
            return Key{1} << 62 | Key{name.first} << 38 | Key{name.second} << 14 | field(name.a);
        case FineName::Kind::Inside:
            break;
    }
    return Key{2} << 62 | Key{name.first} << 38 | field(name.a) << 14 | field(name.b);
}

void FineMeshChecker::start(const std::vector<std::array<uint32_t, 3>>& base) {
    report_ = {};
    vertices_.clear();
    shared_vertices_.clear();
    half_edges_.clear();
    shared_half_edges_.clear();
    rim_.clear();
    // How often each base edge is walked upwards, and downwards.
    std::map<std::pair<uint32_t, uint32_t>, std::array<int, 2>> uses;
    for (const auto& triangle : base) {
        for (std::size_t e = 0; e < 3; ++e) {
            const uint32_t from = triangle[e], to = triangle[(e + 1) % 3];
            ++uses[std::minmax(from, to)][from > to];
        }
    }
    for (const auto& [edge, count] : uses) {
        if (count != std::array{1, 1}) rim_.push_back(edge);
    }
}

void FineMeshChecker::add_triangle(const std::array<FineName, 3>& triangle) {
    ++report_.triangles;
    const std::array<Key, 3> keys = {key_of(triangle[0]), key_of(triangle[1]), key_of(triangle[2])};
    report_.degenerate += keys[0] == keys[1] || keys[1] == keys[2] || keys[2] == keys[0];
    for (std::size_t e = 0; e < 3; ++e) {
        const Key from = keys[e], to = keys[(e + 1) % 3];
        half_edges_.push_back({std::min(from, to), std::max(from, to), from > to});
    }
}

// Each edge must occur once in either direction; what does not is passed on.
void FineMeshChecker::pair_half_edges(std::vector<HalfEdge>& edges,
                                      std::vector<HalfEdge>& unpaired) {
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return std::tie(x.low, x.high, x.down) < std::tie(y.low, y.high, y.down);
    });
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].low == edges[i].low &&
               edges[end].high == edges[i].high) {
            ++end;
        }
        const bool pair = end == i + 2 && edges[i].down != edges[i + 1].down;
        if (!pair)
            unpaired.insert(unpaired.end(), edges.begin() + std::ptrdiff_t(i),
                            edges.begin() + std::ptrdiff_t(end));
        i = end;
    }
    edges.clear();
}

// A vertex inside a base triangle belongs to it alone; one name counts once.
void FineMeshChecker::count_vertices(std::vector<Occurrence>& vertices) {
    std::sort(vertices.begin(), vertices.end(), [](const Occurrence& x, const Occurrence& y) {
        return std::tie(x.name, x.digest) < std::tie(y.name, y.digest);
    });
    Key base_edge = 0;
    bool edge_cracked = false;
    for (std::size_t i = 0; i < vertices.size();) {
        std::size_t end = i + 1;
        bool cracked = false;
        for (; end < vertices.size() && vertices[end].name == vertices[i].name; ++end) {
            cracked |= vertices[end].digest != vertices[i].digest;
        }
        const Key name = vertices[i].name;
        ++report_.vertices;
        report_.cracked += cracked;
        if (name >> 62 == 1) {
            if (name >> 14 != base_edge) {
                base_edge = name >> 14;
                edge_cracked = false;
                ++report_.base_edges;
            }
            ++report_.edge_vertices;
            report_.cracked_edge_vertices += cracked;
            report_.cracked_base_edges += cracked && !edge_cracked;
            edge_cracked |= cracked;
        }
        i = end;
    }
    vertices.clear();
}

void FineMeshChecker::finish_base() {
    pair_half_edges(half_edges_, shared_half_edges_);
    const auto inside = std::partition(vertices_.begin(), vertices_.end(),
                                       [](const Occurrence& v) { return !is_inside(v.name); });
    shared_vertices_.insert(shared_vertices_.end(), vertices_.begin(), inside);
    vertices_.erase(vertices_.begin(), inside);
    count_vertices(vertices_);
}

// The base edge of one triangle that the half-edge is a step of, or none.
const std::pair<uint32_t, uint32_t>* FineMeshChecker::rim_of(const HalfEdge& edge) const {
    const auto ends = [](Key key) {
        return std::pair(static_cast<uint32_t>(key >> 38 & 0xFFFFFF),
                         static_cast<uint32_t>(key >> 14 & 0xFFFFFF));
    };
    const auto is_vertex = [](Key key) { return key >> 62 == 0; };
    if (is_inside(edge.high)) return nullptr;  // the kinds are in order
    std::pair<uint32_t, uint32_t> base = {static_cast<uint32_t>(edge.low),
                                          static_cast<uint32_t>(edge.high)};
    if (!is_vertex(edge.high)) {
        base = ends(edge.high);
        const auto corner = static_cast<uint32_t>(edge.low);
        const bool joined = is_vertex(edge.low)
                                ? corner == base.first || corner == base.second
                                : ends(edge.low) == base && edge.high - edge.low == 1;
        if (!joined) return nullptr;
    }
    const auto at = std::lower_bound(rim_.begin(), rim_.end(), base);
    return at != rim_.end() && *at == base ? &*at : nullptr;
}

FineReport FineMeshChecker::finish() {
    finish_base();
    std::vector<HalfEdge> open;
    pair_half_edges(shared_half_edges_, open);
    report_.open_edges = open.size();
    std::set<const std::pair<uint32_t, uint32_t>*> rim;
    for (const HalfEdge& edge : open) {
        const auto* base = rim_of(edge);
        report_.rim_edges += base != nullptr;
        if (base != nullptr) rim.insert(base);
    }
    report_.rim_base_edges = rim.size();
    count_vertices(shared_vertices_);
    return report_;
}

}  // namespace repousse::reference
