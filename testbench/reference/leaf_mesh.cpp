#include "testbench/reference/leaf_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <unordered_map>

namespace repousse::reference {
namespace {

using Name = std::array<uint64_t, 3>;

struct NameHash {
    std::size_t operator()(const Name& name) const {
        uint64_t h = 0;
        for (const uint64_t word : name) h = (h ^ word) * 0x9E3779B97F4A7C15ULL ^ (h >> 29);
        return static_cast<std::size_t>(h);
    }
};

// -0.0 and 0.0 are the same place.
Name name_of(const LeafCorner& corner) {
    Name name;
    for (std::size_t k = 0; k < 3; ++k) {
        const double value = corner.position[k] + 0.0;
        std::memcpy(&name[k], &value, sizeof value);
    }
    return name;
}

// Vertices numbered by name, edges counted with sign: each manifold edge is walked once in either
// direction, so what does not sum to zero is open.
class EdgeBalance {
public:
    uint32_t id(const LeafCorner& corner) {
        const auto next = static_cast<uint32_t>(ids_.size());
        return ids_.emplace(name_of(corner), next).first->second;
    }

    void add(const LeafTriangle& triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            walk(id(triangle.corners[k]), id(triangle.corners[(k + 1) % 3]), 1);
        }
    }

    void walk(uint32_t from, uint32_t to, int times) {
        if (from < to) balance_[{from, to}] += times;
        if (to < from) balance_[{to, from}] -= times;
    }

    // Directed open edges, from -> to, as often as they are open.
    std::multimap<uint32_t, uint32_t> open() const {
        std::multimap<uint32_t, uint32_t> edges;
        for (const auto& [edge, count] : balance_) {
            for (int i = 0; i < std::abs(count); ++i) {
                edges.insert(count > 0 ? edge : std::make_pair(edge.second, edge.first));
            }
        }
        return edges;
    }

private:
    std::unordered_map<Name, uint32_t, NameHash> ids_;
    std::map<std::pair<uint32_t, uint32_t>, int> balance_;
};

// Follows open edges from one end of a rim edge to the other and takes them out; stops where the
// chain breaks, so that what is left counts as open.
void remove_chain(std::multimap<uint32_t, uint32_t>& open, uint32_t from, uint32_t to) {
    uint32_t at = from;
    do {
        const auto next = open.find(at);
        if (next == open.end()) return;
        at = next->second;
        open.erase(next);
    } while (at != to);
}

std::size_t count_open_edges(const std::vector<LeafTriangle>& leaves,
                             const std::vector<LeafTriangle>& base) {
    EdgeBalance leaf_edges;
    EdgeBalance base_edges;
    std::map<uint32_t, uint32_t> leaf_id;  // of a base vertex
    for (const LeafTriangle& triangle : leaves) leaf_edges.add(triangle);
    for (const LeafTriangle& triangle : base) {
        base_edges.add(triangle);
        for (const LeafCorner& corner : triangle.corners) {
            leaf_id[base_edges.id(corner)] = leaf_edges.id(corner);
        }
    }
    std::multimap<uint32_t, uint32_t> open = leaf_edges.open();
    for (const auto& [from, to] : base_edges.open()) {
        remove_chain(open, leaf_id[from], leaf_id[to]);
    }
    return open.size();
}

// Sign of the texture area. Coordinates have at most 31 bits: differences 32, products 63, so the
// two products are compared, not subtracted.
int area_sign(const LeafTriangle& triangle) {
    const auto& [a, b, c] = triangle.corners;
    const int64_t p = (b.uv[0] - a.uv[0]) * (c.uv[1] - a.uv[1]);
    const int64_t q = (c.uv[0] - a.uv[0]) * (b.uv[1] - a.uv[1]);
    return p > q ? 1 : p < q ? -1 : 0;
}

}  // namespace

LeafReport check_leaves(const std::vector<LeafTriangle>& leaves,
                        const std::vector<LeafTriangle>& base) {
    LeafReport report;
    report.triangles = leaves.size();
    std::vector<std::pair<Name, std::array<int64_t, 2>>> vertices;
    for (const LeafTriangle& triangle : leaves) {
        for (const LeafCorner& corner : triangle.corners) {
            vertices.emplace_back(name_of(corner), corner.uv);
        }
        const int expected = area_sign(base.at(triangle.base));
        const int found = area_sign(triangle);
        report.flipped += expected != 0 && found == -expected;
        report.zero_area += expected != 0 && found == 0;
    }
    std::sort(vertices.begin(), vertices.end());
    report.vertices =
        static_cast<std::size_t>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
    report.open_edges = count_open_edges(leaves, base);
    return report;
}

uint64_t hash_leaves(const std::vector<LeafTriangle>& leaves) {
    std::vector<std::array<int64_t, 6>> rows;
    rows.reserve(leaves.size());
    for (const LeafTriangle& triangle : leaves) {
        std::size_t first = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (triangle.corners[k].uv < triangle.corners[first].uv) first = k;
        }
        std::array<int64_t, 6> row;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& uv = triangle.corners[(first + k) % 3].uv;
            row[2 * k] = uv[0];
            row[2 * k + 1] = uv[1];
        }
        rows.push_back(row);
    }
    std::sort(rows.begin(), rows.end());
    uint64_t hash = 1469598103934665603ULL;
    for (const auto& row : rows) {
        for (const int64_t value : row) {
            for (int byte = 0; byte < 8; ++byte) {
                hash ^= static_cast<uint64_t>(value) >> (8 * byte) & 0xFF;
                hash *= 1099511628211ULL;
            }
        }
    }
    return hash;
}

HeightError height_error(const std::vector<LeafTriangle>& leaves, const SampleLattice& lattice,
                         const std::function<double(int, int)>& expected) {
    const auto columns = static_cast<std::size_t>(lattice.columns);
    std::vector<char> seen(columns * static_cast<std::size_t>(lattice.rows), 0);
    HeightError error;
    double sum = 0;
    for (const LeafTriangle& triangle : leaves) {
        // Corners in lattice units.
        std::array<double, 3> x, y, z;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& p = triangle.corners[k].position;
            x[k] = (p[0] - lattice.x0) / lattice.dx;
            y[k] = (p[1] - lattice.y0) / lattice.dy;
            z[k] = p[2];
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0) continue;
        // Points on an edge belong to both sides and have one z there; the margin only decides
        // which side is asked.
        constexpr double kMargin = -1e-9;
        const auto [x_low, x_high] = std::minmax({x[0], x[1], x[2]});
        const auto [y_low, y_high] = std::minmax({y[0], y[1], y[2]});
        const int i_end = std::min(lattice.columns - 1, int(std::floor(x_high + 1e-9)));
        const int j_end = std::min(lattice.rows - 1, int(std::floor(y_high + 1e-9)));
        for (int j = std::max(0, int(std::ceil(y_low - 1e-9))); j <= j_end; ++j) {
            for (int i = std::max(0, int(std::ceil(x_low - 1e-9))); i <= i_end; ++i) {
                char& done =
                    seen[static_cast<std::size_t>(j) * columns + static_cast<std::size_t>(i)];
                const double w1 = ((i - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (j - y[0])) / area;
                const double w2 = ((x[1] - x[0]) * (j - y[0]) - (i - x[0]) * (y[1] - y[0])) / area;
                if (done || w1 < kMargin || w2 < kMargin || w1 + w2 > 1 - kMargin) continue;
                done = 1;
                const double d = z[0] + w1 * (z[1] - z[0]) + w2 * (z[2] - z[0]) - expected(i, j);
                sum += d * d;
                error.max = std::max(error.max, std::fabs(d));
                ++error.samples;
            }
        }
    }
    error.rms = error.samples == 0 ? 0 : std::sqrt(sum / static_cast<double>(error.samples));
    return error;
}

}  // namespace repousse::reference
