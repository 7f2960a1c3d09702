#include "testbench/reference/tessellator.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "testbench/reference/map_reader.h"

namespace repousse::reference {
namespace {

struct Corner {
    Uv uv{};
    glm::dvec3 position, normal, tangent;
    double handedness = 1.0;
    int generation = 0;
    glm::dvec3 map_normal, displaced, displaced_normal;
    glm::dvec2 screen{0.0};
    bool behind = false;
};

struct Piece {
    std::array<Corner, 3> corners;
    uint32_t base = 0;
    std::size_t depth = 0;
};

glm::dvec3 unit(const glm::dvec3& v) {
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length == 0.0 ? glm::dvec3(0.0) : v / length;
}

class Tessellator {
public:
    explicit Tessellator(const TessellatorInput& input)
        : in_(input),
          map_(input.map, input.uv_frac, input.map.wrap && input.mistake != Mistake::ClampedSeam) {}

    Tessellation run() {
        std::vector<Piece> waiting;
        for (std::size_t i = in_.triangles.size(); i-- > 0;) {
            Piece piece;
            piece.base = static_cast<uint32_t>(i);
            for (std::size_t k = 0; k < 3; ++k) {
                const TessellatorVertex& v = in_.vertices[in_.triangles[i][k]];
                Corner& c = piece.corners[k];
                c.uv = v.uv;
                c.position = v.position;
                c.normal = v.normal;
                c.tangent = v.tangent;
                c.handedness = v.handedness;
                displace(c);
            }
            waiting.push_back(piece);
        }
        while (!waiting.empty() && result_.visits < in_.visit_limit) {
            const Piece piece = waiting.back();
            waiting.pop_back();
            ++result_.visits;
            for (const Piece& child : children(piece)) waiting.push_back(child);
        }
        result_.finished = waiting.empty();
        return result_;
    }

private:
    /// Equation 1, and N_D rotated into the vertex's frame.
    void displace(Corner& c) const {
        const double d = map_.height(c.uv) * in_.map.scale + in_.map.bias;
        c.displaced = c.position + d * c.normal;
        if (in_.normal_threshold) {
            const glm::dvec3 n = c.map_normal = map_.normal(c.uv);
            const glm::dvec3 bitangent = c.handedness * glm::cross(c.normal, c.tangent);
            c.displaced_normal = unit(c.tangent * n.x + bitangent * n.y + c.normal * n.z);
        }
        if (!in_.view) return;
        const glm::dvec3 e = c.displaced - in_.view->eye;
        const double w = glm::dot(in_.view->forward, e);
        c.behind = w <= in_.view->near;
        if (c.behind) return;
        const glm::dvec2 ratio(glm::dot(in_.view->right, e) / w, glm::dot(in_.view->up, e) / w);
        c.screen = in_.view->centre + in_.view->focal * ratio;
    }

    Corner midpoint(const Corner& a, const Corner& b) const {
        Corner m;
        for (std::size_t k = 0; k < 2; ++k) {
            const int64_t sum = a.uv[k] + b.uv[k];
            m.uv[k] = in_.mistake == Mistake::TruncatingMidpoint
                          ? a.uv[k] + (b.uv[k] - a.uv[k]) / 2
                          : (sum - (sum % 2 != 0 && sum < 0 ? 1 : 0)) / 2;
        }
        m.position = (a.position + b.position) * 0.5;
        m.normal = unit(a.normal + b.normal);
        m.tangent = unit(a.tangent + b.tangent);
        m.handedness = a.handedness;
        m.generation = std::max(a.generation, b.generation) + 1;
        displace(m);
        return m;
    }

    bool tex_coord_test(const Corner& a, const Corner& b, const Corner& m) const {
        const Uv texel = map_.texel_of(m.uv);
        return texel != map_.texel_of(a.uv) && texel != map_.texel_of(b.uv);
    }

    bool view_test(const Corner& a, const Corner& b) const {
        if (!in_.view || a.behind || b.behind) return true;
        return std::abs(a.screen.x - b.screen.x) + std::abs(a.screen.y - b.screen.y) >
               in_.view->threshold_px;
    }

    bool normal_test(const Corner& a, const Corner& b, const Corner& m) const {
        const double threshold = *in_.normal_threshold;
        const auto differ = [threshold](const glm::dvec3& p, const glm::dvec3& q) {
            return std::abs(p.x - q.x) > threshold || std::abs(p.y - q.y) > threshold ||
                   std::abs(p.z - q.z) > threshold;
        };
        if (!in_.map_space) {
            return differ(m.displaced_normal, a.displaced_normal) ||
                   differ(m.displaced_normal, b.displaced_normal);
        }
        return differ(m.map_normal, a.map_normal) || differ(m.map_normal, b.map_normal) ||
               differ(m.normal, a.normal) || differ(m.normal, b.normal);
    }

    bool height_test(const Corner& a, const Corner& b, const Corner& m) const {
        Uv e{b.uv[0] - a.uv[0], b.uv[1] - a.uv[1]};
        if (in_.mistake != Mistake::SignedShiftBoxes) e = {std::abs(e[0]), std::abs(e[1])};
        if (!in_.literal) e[0] = e[1] = std::max(std::abs(e[0]), std::abs(e[1]));
        const MapBox s12 = map_.box(m.uv, {e[0] >> 2, e[1] >> 2}, !in_.sum);
        const MapBox s1 = map_.box(a.uv, {e[0] >> 3, e[1] >> 3}, !in_.sum);
        const MapBox s2 = map_.box(b.uv, {e[0] >> 3, e[1] >> 3}, !in_.sum);
        const int64_t ends = s1.sum + s2.sum;
        if (in_.sum) return std::abs(s12.sum - 2 * ends) > 2 * *in_.height_threshold;
        const int64_t area = s1.area + s2.area;
        return std::abs(s12.sum * area - ends * s12.area) > *in_.height_threshold * s12.area * area;
    }

    bool splits(const Piece& piece, const Corner& a, const Corner& b, const Corner& m) const {
        const int level = in_.cap_depth ? static_cast<int>(piece.depth) + 1 : m.generation;
        if (in_.cap && level > *in_.cap) return false;
        if (!tex_coord_test(a, b, m) || !view_test(a, b)) return false;
        if (!in_.normal_threshold && !in_.height_threshold) return true;
        return (in_.normal_threshold && normal_test(a, b, m)) ||
               (in_.height_threshold && height_test(a, b, m));
    }

    std::vector<Piece> children(const Piece& piece) {
        const auto& c = piece.corners;
        std::array<Corner, 3> mid;
        std::array<bool, 3> split{};
        for (std::size_t e = 0; e < 3; ++e) {
            mid[e] = midpoint(c[e], c[(e + 1) % 3]);
            split[e] = splits(piece, c[e], c[(e + 1) % 3], mid[e]);
        }
        const auto count = static_cast<std::size_t>(split[0] + split[1] + split[2]);
        ++result_.by_split_edges[count];
        const auto child = [&piece](const Corner& p, const Corner& q, const Corner& r) {
            return Piece{{p, q, r}, piece.base, piece.depth + 1};
        };
        if (count == 3) {
            return {child(c[0], mid[0], mid[2]), child(mid[0], c[1], mid[1]),
                    child(mid[2], mid[1], c[2]), child(mid[0], mid[1], mid[2])};
        }
        for (std::size_t e = 0; e < 3; ++e) {
            const Corner &a = c[e], &b = c[(e + 1) % 3], &apex = c[(e + 2) % 3];
            if (count == 1 && split[e]) return {child(a, mid[e], apex), child(mid[e], b, apex)};
            if (count == 2 && !split[e]) {
                const Corner &m1 = mid[(e + 1) % 3], &m2 = mid[(e + 2) % 3];
                if (squared_length(a, m1) <= squared_length(b, m2)) {
                    return {child(m2, m1, apex), child(a, b, m1), child(a, m1, m2)};
                }
                return {child(m2, m1, apex), child(a, b, m2), child(b, m1, m2)};
            }
        }
        emit(piece);
        return {};
    }

    static double squared_length(const Corner& p, const Corner& q) {
        const glm::dvec3 d = p.displaced - q.displaced;
        return d.x * d.x + d.y * d.y + d.z * d.z;
    }

    void emit(const Piece& piece) {
        const auto leaf = [&piece](glm::dvec3 Corner::*place) {
            LeafTriangle triangle;
            triangle.base = piece.base;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3& p = piece.corners[k].*place;
                triangle.corners[k] = {piece.corners[k].uv, {p.x, p.y, p.z}};
            }
            return triangle;
        };
        result_.leaves.push_back(leaf(&Corner::displaced));
        result_.flat.push_back(leaf(&Corner::position));
        result_.deepest = std::max(result_.deepest, piece.depth);
    }

    const TessellatorInput& in_;
    MapReader map_;
    Tessellation result_;
};

}  // namespace

Tessellation tessellate(const TessellatorInput& input) { return Tessellator(input).run(); }

}  // namespace repousse::reference
