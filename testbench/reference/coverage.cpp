#include "testbench/reference/coverage.h"

#include <algorithm>
#include <cstdlib>

namespace repousse::reference {
namespace {

int64_t cross(int64_t ax, int64_t ay, int64_t bx, int64_t by) { return ax * by - ay * bx; }

}  // namespace

void CoverageChecker::start(const CoverBase& base) {
    base_ = base;
    report_ = {};
    half_edges_.clear();
    area_ = 0;
    uint64_t ids = 3;
    for (std::size_t e = 0; e < 3; ++e) {
        int64_t steps = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int64_t d = base.corners[(e + 1) % 3][axis] - base.corners[e][axis];
            steps = std::max(steps, std::abs(d));
        }
        scale_[e] = steps;
        edge_ids_[e] = ids;
        ids += static_cast<uint64_t>(steps);
    }
    interior_ids_ = ids;

    const auto at = [&](std::size_t corner, int axis) {
        return base.corners[corner][static_cast<std::size_t>(axis)];
    };
    const int a = base.axis_a, b = base.axis_b;
    const int64_t area =
        cross(at(1, a) - at(0, a), at(1, b) - at(0, b), at(2, a) - at(0, a), at(2, b) - at(0, b));
    sign_ = area < 0 ? -1 : 1;
    scale_[3] = area == 0 ? 1 : sign_ * area;
    low_ = {std::min({at(0, a), at(1, a), at(2, a)}), std::min({at(0, b), at(1, b), at(2, b)})};
    high_ = {std::max({at(0, a), at(1, a), at(2, a)}), std::max({at(0, b), at(1, b), at(2, b)})};
    if (area == 0) high_ = {low_[0] - 1, low_[1] - 1};  // nothing lies inside

    // What lies outside: the edge sequences, backwards.
    for (std::size_t e = 0; e < 3; ++e) {
        uint64_t from = e;
        for (int64_t k = 1; k <= scale_[e]; ++k) {
            const uint64_t to =
                k == scale_[e] ? (e + 1) % 3 : edge_ids_[e] + static_cast<uint64_t>(k);
            add_half_edge(to, from);
            from = to;
        }
    }
}

bool CoverageChecker::row_of(const CoverVertex& vertex, Row& row) const {
    const auto part = static_cast<std::size_t>(vertex.part);
    row.weight = {0, 0, 0};
    switch (vertex.kind) {
        case CoverVertex::Kind::Corner:
            if (part > 2) return false;
            row.weight[part] = 1;
            row.denominator = -1;
            row.id = part;
            return true;
        case CoverVertex::Kind::Edge:
            if (part > 2 || vertex.a < 1 || vertex.a >= scale_[part]) return false;
            row.weight[part] = scale_[part] - vertex.a;
            row.weight[(part + 1) % 3] = vertex.a;
            row.denominator = vertex.part;
            row.id = edge_ids_[part] + static_cast<uint64_t>(vertex.a);
            return true;
        case CoverVertex::Kind::Interior:
            break;
    }
    if (vertex.a < low_[0] || vertex.a > high_[0] || vertex.b < low_[1] || vertex.b > high_[1]) {
        return false;
    }
    std::array<std::array<int64_t, 2>, 3> to{};
    for (std::size_t i = 0; i < 3; ++i) {
        to[i] = {base_.corners[i][static_cast<std::size_t>(base_.axis_a)] - vertex.a,
                 base_.corners[i][static_cast<std::size_t>(base_.axis_b)] - vertex.b};
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const auto &p = to[(i + 1) % 3], &q = to[(i + 2) % 3];
        row.weight[i] = sign_ * cross(p[0], p[1], q[0], q[1]);
    }
    row.denominator = 3;
    row.id = interior_ids_ + static_cast<uint64_t>((vertex.a - low_[0]) * (high_[1] - low_[1] + 1) +
                                                   vertex.b - low_[1]);
    return true;
}

// The determinant over the product of denominators, times all four scales. It divides exactly:
// each further row on the same edge, or inside, contributes its scale as a factor. 66 bits are
// left.
CoverageChecker::Wide CoverageChecker::scaled_area(const std::array<Row, 3>& rows) const {
    const auto &p = rows[0].weight, &q = rows[1].weight, &r = rows[2].weight;
    Wide area = static_cast<Wide>(p[0]) * (q[1] * r[2] - q[2] * r[1]) +
                static_cast<Wide>(p[1]) * (q[2] * r[0] - q[0] * r[2]) +
                static_cast<Wide>(p[2]) * (q[0] * r[1] - q[1] * r[0]);
    std::array<int, 4> times{};
    for (const Row& row : rows) {
        if (row.denominator >= 0) ++times[static_cast<std::size_t>(row.denominator)];
    }
    for (std::size_t i = 0; i < 4; ++i) {
        for (int n = 1; n < times[i]; ++n) area /= scale_[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
        if (times[i] == 0) area *= scale_[i];
    }
    return area;
}

void CoverageChecker::add(const CoverTriangle& triangle) {
    ++report_.triangles;
    std::array<Row, 3> rows;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!row_of(triangle[i], rows[i])) {
            ++report_.bad_names;
            return;
        }
    }
    Wide area = 0;
    if (rows[0].denominator == 3 && rows[1].denominator == 3 && rows[2].denominator == 3) {
        // Three points of the plane's grid: the same number without the detour.
        const auto &p = triangle[0], &q = triangle[1], &r = triangle[2];
        const int64_t twice = sign_ * cross(q.a - p.a, q.b - p.b, r.a - p.a, r.b - p.b);
        const int64_t steps = scale_[0] * scale_[1] * scale_[2];  // 42 bits
        area = static_cast<Wide>(twice) * steps;
    } else {
        area = scaled_area(rows);
    }
    report_.not_positive += area <= 0;
    area_ += area;
    for (std::size_t i = 0; i < 3; ++i) add_half_edge(rows[i].id, rows[(i + 1) % 3].id);
}

// Ids have 27 bits: 64 M grid points and the edges. The lowest bit is the direction.
void CoverageChecker::add_half_edge(uint64_t from, uint64_t to) {
    const uint64_t low = std::min(from, to), high = std::max(from, to);
    half_edges_.push_back(low << 33 | high << 1 | static_cast<uint64_t>(from > to));
}

// Each edge must occur once in either direction.
std::size_t CoverageChecker::count_open_edges() {
    std::sort(half_edges_.begin(), half_edges_.end());
    std::size_t open = 0;
    for (std::size_t i = 0; i < half_edges_.size();) {
        std::size_t end = i;
        while (end < half_edges_.size() && half_edges_[end] >> 1 == half_edges_[i] >> 1) ++end;
        const bool pair = end == i + 2 && half_edges_[i] != half_edges_[i + 1];
        if (!pair) open += end - i;
        i = end;
    }
    return open;
}

CoverReport CoverageChecker::finish() {
    Wide whole = 1;
    for (const int64_t scale : scale_) whole *= scale;
    report_.area_differs = area_ != whole;
    report_.open_edges = count_open_edges();
    return report_;
}

}  // namespace repousse::reference
