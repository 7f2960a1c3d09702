#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace repousse::test {

/// A square [0, side]^2 cut into triangles with corners on integer points, clockwise where y runs
/// down. Every edge within has a triangle on either side, and no vertex lies inside an edge.
struct Triangulation {
    int side = 0;
    std::vector<std::array<std::int64_t, 2>> points;
    std::vector<std::array<std::size_t, 3>> triangles;

    std::int64_t area(std::size_t a, std::size_t b, std::size_t c) const {
        const auto &p = points[a], &q = points[b], &r = points[c];
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    }

    /// Puts a point into the triangles that it is inside or on the border of.
    void insert(std::int64_t x, std::int64_t y) {
        const std::size_t n = points.size();
        points.push_back({x, y});
        std::vector<std::array<std::size_t, 3>> next;
        bool is_corner = false;
        for (const auto& t : triangles) {
            std::array<std::int64_t, 3> areas{};
            bool outside = false;
            for (std::size_t k = 0; k < 3; ++k) {
                areas[k] = area(t[k], t[(k + 1) % 3], n);
                outside = outside || areas[k] < 0;
                is_corner = is_corner || points[t[k]] == points[n];
            }
            if (outside) {
                next.push_back(t);
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                if (areas[k] > 0) next.push_back({t[k], t[(k + 1) % 3], n});
            }
        }
        if (is_corner) {
            points.pop_back();
        } else {
            triangles = std::move(next);
        }
    }

    /// Replaces an edge of triangle `i` by the other diagonal of its quad, if that is convex.
    void flip(std::size_t i, std::size_t k) {
        const std::size_t a = triangles[i][k], b = triangles[i][(k + 1) % 3];
        const std::size_t c = triangles[i][(k + 2) % 3];
        for (std::size_t j = 0; j < triangles.size(); ++j) {
            for (std::size_t m = 0; m < 3; ++m) {
                if (triangles[j][m] != b || triangles[j][(m + 1) % 3] != a) continue;
                const std::size_t d = triangles[j][(m + 2) % 3];
                if (area(a, d, c) <= 0 || area(d, b, c) <= 0) return;
                triangles[i] = {a, d, c};
                triangles[j] = {d, b, c};
                return;
            }
        }
    }
};

/// `inserts` random points (some of them on edges and on the border), then as many flips.
inline Triangulation random_triangulation(int side, int inserts, std::mt19937_64& random) {
    Triangulation result;
    result.side = side;
    result.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
    result.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto any = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const auto places = static_cast<std::size_t>(side) + 1;
    for (int n = 0; n < inserts; ++n) {
        const auto x = static_cast<std::int64_t>(any(places));
        result.insert(x, static_cast<std::int64_t>(any(places)));
    }
    for (int n = 0; n < inserts; ++n) result.flip(any(result.triangles.size()), any(3));
    return result;
}

}  // namespace repousse::test
