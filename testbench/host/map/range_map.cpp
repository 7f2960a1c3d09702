#include "testbench/host/map/range_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace repousse::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Point {
    double x, y;
};

// The mesh seen along the axis: x towards the front, z from 0 to 1 along the axis.
std::vector<glm::dvec3> to_axis(const Mesh& mesh, const RangeAxis& axis) {
    const glm::dvec3 along = axis.high - axis.low;
    const double length = glm::length(along);
    const glm::dvec3 up = along / length;
    const glm::dvec3 x = glm::normalize(axis.front - glm::dot(axis.front, up) * up);
    const glm::dvec3 y = glm::cross(up, x);
    std::vector<glm::dvec3> points;
    points.reserve(mesh.positions.size());
    for (const glm::dvec3& p : mesh.positions) {
        const glm::dvec3 d = p - axis.low;
        points.emplace_back(glm::dot(d, x), glm::dot(d, y), glm::dot(d, up) / length);
    }
    return points;
}

class Scan {
public:
    Scan(int width, int height) : width_(width), height_(height) {
        grid_.width = width;
        grid_.height = height;
        grid_.samples.assign(std::size_t(width) * std::size_t(height), -1.0);
    }

    void add(const std::array<glm::dvec3, 3>& t) {
        const auto [low, high] = std::minmax({t[0].z, t[1].z, t[2].z});
        const int first = std::max(0, int(std::ceil(low * height_ - .5)));
        const int last = std::min(height_ - 1, int(std::floor(high * height_ - .5)));
        for (int row = first; row <= last; ++row) add_row(t, row);
    }

    ElevationGrid finish() {
        for (int column = 0; column < width_; ++column) fill(column);
        measure_range(grid_);
        return std::move(grid_);
    }

private:
    double& at(int column, int row) {
        return grid_.samples[std::size_t(row) * std::size_t(width_) + std::size_t(column)];
    }

    // Where the plane of the row's centres cuts the triangle: one segment.
    void add_row(const std::array<glm::dvec3, 3>& t, int row) {
        const double z = (row + .5) / height_;
        std::array<Point, 3> cuts;
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 &p = t[k], &q = t[(k + 1) % 3];
            if ((p.z < z) == (q.z < z)) continue;
            const double f = (z - p.z) / (q.z - p.z);
            cuts[count++] = {p.x + f * (q.x - p.x), p.y + f * (q.y - p.y)};
        }
        if (count == 2) add_segment(cuts[0], cuts[1], row);
    }

    // Every ray between the azimuths of the two ends meets the segment once.
    void add_segment(Point p, Point q, int row) {
        double from = std::atan2(p.y, p.x), to = std::atan2(q.y, q.x);
        if (from > to) std::swap(from, to);
        if (to - from > kPi) {
            from += 2 * kPi;
            std::swap(from, to);
        }
        const double step = 2 * kPi / width_;
        const auto first = int(std::ceil(from / step - .5));
        const auto last = int(std::floor(to / step - .5));
        for (int i = first; i <= last; ++i) {
            const double azimuth = (i + .5) * step;
            const double c = std::cos(azimuth), s = std::sin(azimuth);
            // Distances of the ends from the ray's line, to either side of it.
            const double a = p.y * c - p.x * s, b = q.y * c - q.x * s;
            const double f = a == b ? 0.0 : std::clamp(a / (a - b), 0.0, 1.0);
            const double range = (p.x + f * (q.x - p.x)) * c + (p.y + f * (q.y - p.y)) * s;
            double& sample = at((i % width_ + width_) % width_, row);
            sample = std::max(sample, range);
        }
    }

    void fill(int column) {
        std::vector<int> hits;
        for (int row = 0; row < height_; ++row) {
            if (at(column, row) >= 0) hits.push_back(row);
        }
        for (int row = 0; row < height_; ++row) {
            if (at(column, row) >= 0) continue;
            const auto nearer = [row](int x, int y) {
                return std::abs(x - row) < std::abs(y - row);
            };
            const auto nearest = std::min_element(hits.begin(), hits.end(), nearer);
            at(column, row) = nearest == hits.end() ? 0.0 : at(column, *nearest);
        }
    }

    int width_, height_;
    ElevationGrid grid_;
};

}  // namespace

ElevationGrid range_map(const Mesh& mesh, const RangeAxis& axis, int width, int height) {
    const std::vector<glm::dvec3> points = to_axis(mesh, axis);
    Scan scan(width, height);
    for (const auto& t : mesh.triangles) scan.add({points[t[0]], points[t[1]], points[t[2]]});
    return scan.finish();
}

}  // namespace repousse::host
