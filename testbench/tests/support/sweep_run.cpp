#include "testbench/tests/support/sweep_run.h"

#include <algorithm>

namespace repousse::test {

std::array<SweepCorner, 3> corners_of(const GridTriangle& points) {
    std::array<SweepCorner, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].id = static_cast<uint32_t>(i);
        corners[i].slot = points[i];
    }
    return corners;
}

std::array<SweepCorner, 3> with_data(const GridTriangle& points, std::mt19937_64& random,
                                     int bits) {
    auto corners = corners_of(points);
    for (auto& corner : corners) {
        for (int32_t& x : corner.data) x = static_cast<int32_t>(random()) >> (31 - bits);
    }
    return corners;
}

reference::CoverVertex cover_vertex(const VertexName& name, const SweepTriangle& triangle) {
    using Kind = reference::CoverVertex::Kind;
    switch (name.kind) {
        case NameKind::Corner:
            return {Kind::Corner, name.part, 0, 0};
        case NameKind::Interior:
            return {Kind::Interior, 0, name.a, name.b};
        case NameKind::Edge:
            break;
    }
    const std::size_t from = name.part, to = (from + 1) % 3;
    if (triangle.corners[from].id < triangle.corners[to].id) return {Kind::Edge, name.part, name.a};
    int32_t steps = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int32_t d = triangle.corners[to].slot[axis] - triangle.corners[from].slot[axis];
        steps = std::max(steps, std::abs(d));
    }
    return {Kind::Edge, name.part, steps - name.a};
}

SweepChain::SweepChain(const SweepLineOptions& sweep_options,
                       const TriangleSetupOptions& setup_options)
    : setup(setup_options),
      sweep(sweep_options),
      strip(static_cast<std::size_t>(std::max(1, sweep_options.column_depth))) {}

template <class Sink>
void SweepChain::each_triangle(const std::array<SweepCorner, 3>& corners, Sink&& sink) {
    setup(corners, base_);
    sweep.run(base_, [&](const SweepStep& step) {
        strip(step.strip, {step.vertices.data(), step.vertex_count}, made_);
        for (std::size_t i = 0; i < made_.count; ++i) sink(made_.triangles[i]);
    });
}

void SweepChain::remesh(const std::array<SweepCorner, 3>& corners) {
    triangles_.clear();
    each_triangle(corners, [&](const auto& triangle) { triangles_.push_back(triangle); });
}

reference::CoverReport SweepChain::cover(const GridTriangle& points) {
    reference::CoverBase base;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) base.corners[i][axis] = points[i][axis];
    }
    bool started = false;
    const auto start = [&] {
        if (!base_.single) base.axis_a = base_.sweep_axis, base.axis_b = base_.side_axis;
        checker_.start(base);
        started = true;
    };
    each_triangle(corners_of(points), [&](const auto& triangle) {
        if (!started) start();
        checker_.add({cover_vertex(triangle[0].name, base_), cover_vertex(triangle[1].name, base_),
                      cover_vertex(triangle[2].name, base_)});
    });
    if (!started) start();
    return checker_.finish();
}

std::size_t collect_vertices(const SweepChain& chain, std::map<VertexKey, VertexData>& vertices) {
    std::size_t conflicts = 0;
    for (const auto& triangle : chain.triangles()) {
        for (const auto& [name, data] : triangle) {
            const VertexKey key = {int(name.kind), name.part, name.a, name.b};
            const auto [at, is_new] = vertices.emplace(key, data);
            conflicts += !is_new && at->second != data;
        }
    }
    return conflicts;
}

std::string name_of(TriangleKind kind) {
    static constexpr const char* kNames[] = {"tiny",    "small",     "medium",   "large",
                                             "facing",  "edgewise",  "thin",     "far thin",
                                             "2 equal", "collinear", "one point"};
    return kNames[static_cast<std::size_t>(kind)];
}

GridTriangle random_triangle(TriangleKind kind, std::mt19937_64& random) {
    const auto in = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    const auto point = [&](int x, int y, int z) -> GridPoint {
        return {in(0, x), in(0, y), in(0, z)};
    };
    const auto cube = [&](int n) {
        return GridTriangle{point(n, n, n), point(n, n, n), point(n, n, n)};
    };
    // The third corner beside a point of the line through the first two.
    const auto thin = [&](int limit, int off) {
        GridTriangle t;
        for (std::size_t i = 0; i < 2; ++i) {
            for (int& x : t[i]) x = in(-limit, limit);
        }
        const int k = in(0, 1000);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int x = t[0][axis] + (t[1][axis] - t[0][axis]) * k / 1000 + in(-off, off);
            t[2][axis] = std::clamp(x, -limit, limit);
        }
        std::swap(t[2], t[random() % 3]);
        return t;
    };
    switch (kind) {
        case TriangleKind::Tiny:
            return cube(6);
        case TriangleKind::Small:
            return cube(20);
        case TriangleKind::Medium:
            return cube(100);
        case TriangleKind::Large: {
            GridTriangle t = cube(800);
            for (GridPoint& p : t) {
                for (int& x : p) x -= 400;
            }
            return t;
        }
        case TriangleKind::Facing:
            return {point(40, 40, 3), point(40, 40, 3), point(40, 40, 3)};
        case TriangleKind::Edgewise:
            return {point(3, 40, 40), point(3, 40, 40), point(3, 40, 40)};
        case TriangleKind::Thin:
            return thin(20, 1);
        case TriangleKind::FarThin:
            return thin(kGridLimit, 1);
        case TriangleKind::TwoEqual: {
            GridTriangle t = cube(40);
            const std::size_t i = random() % 3;
            t[i] = t[(i + 1 + random() % 2) % 3];
            return t;
        }
        case TriangleKind::Collinear: {
            const GridPoint p = point(9, 9, 9), d = {in(-6, 6), in(-6, 6), in(-6, 6)};
            GridTriangle t;
            for (GridPoint& q : t) {
                const int k = in(-5, 5);
                for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = p[axis] + k * d[axis];
            }
            return t;
        }
        case TriangleKind::Point:
            break;
    }
    const GridPoint p = point(9, 9, 9);
    return {p, p, p};
}

GridTriangle mixed_triangle(int n, std::mt19937_64& random) {
    static constexpr TriangleKind kKinds[] = {
        TriangleKind::Tiny,     TriangleKind::Small,     TriangleKind::Medium,
        TriangleKind::Facing,   TriangleKind::Edgewise,  TriangleKind::Thin,
        TriangleKind::TwoEqual, TriangleKind::Collinear,
    };
    return random_triangle(kKinds[n % 8], random);
}

GridTriangle flat_triangle(int size, std::mt19937_64& random) {
    GridTriangle t{};
    for (auto& p : t) {
        for (std::size_t axis = 0; axis < 2; ++axis) p[axis] = int(random() % unsigned(size + 1));
    }
    return t;
}

}  // namespace repousse::test
