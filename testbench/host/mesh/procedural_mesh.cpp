#include "testbench/host/mesh/procedural_mesh.h"

#include <cmath>
#include <map>
#include <utility>

#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/uv_projection.h"

namespace repousse::host {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Two triangles a quad, vertices in rows of columns + 1.
void add_quads(Mesh& mesh, int columns, int rows) {
    const auto n = static_cast<std::uint32_t>(columns);
    mesh.triangles.reserve(2u * n * static_cast<std::uint32_t>(rows));
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh.triangles.push_back({a, a + 1, a + n + 2});
            mesh.triangles.push_back({a, a + n + 2, a + n + 1});
        }
    }
}

void add_vertex(Mesh& mesh, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 tangent,
                glm::dvec2 uv) {
    mesh.positions.push_back(position);
    mesh.normals.push_back(normal);
    mesh.tangents.push_back(tangent);
    mesh.handedness.push_back(1.0);
    mesh.uv.push_back(uv);
}

/// The icosahedron with vertices at both poles: two rings of five at z = +-1/sqrt(5), the upper
/// turned by 36 degrees against the lower.
Mesh make_icosahedron() {
    Mesh mesh;
    const double z = 1.0 / std::sqrt(5.0);
    const double rho = 2.0 * z;
    mesh.positions.push_back({0.0, 0.0, -1.0});
    for (int ring = 0; ring < 2; ++ring) {
        for (int k = 0; k < 5; ++k) {
            const double angle = (2 * k + ring) * kPi / 5.0;
            mesh.positions.push_back(
                {rho * std::cos(angle), rho * std::sin(angle), ring == 0 ? -z : z});
        }
    }
    mesh.positions.push_back({0.0, 0.0, 1.0});
    for (std::uint32_t k = 0; k < 5; ++k) {
        const std::uint32_t low = 1 + k;
        const std::uint32_t low_next = 1 + (k + 1) % 5;
        const std::uint32_t high = 6 + k;
        const std::uint32_t high_next = 6 + (k + 1) % 5;
        mesh.triangles.push_back({0, low_next, low});
        mesh.triangles.push_back({low, low_next, high});
        mesh.triangles.push_back({low_next, high_next, high});
        mesh.triangles.push_back({high, high_next, 11});
    }
    return mesh;
}

/// Each triangle into four; one new vertex per edge, pushed out to the unit sphere.
void subdivide(Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto key = a < b ? std::make_pair(a, b) : std::make_pair(b, a);
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        const auto [place, fresh] = middles.try_emplace(key, next);
        if (fresh) {
            const glm::dvec3 sum = mesh.positions[a] + mesh.positions[b];
            mesh.positions.push_back(glm::normalize(sum));
        }
        return place->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& t : mesh.triangles) {
        const std::uint32_t ab = middle(t[0], t[1]);
        const std::uint32_t bc = middle(t[1], t[2]);
        const std::uint32_t ca = middle(t[2], t[0]);
        finer.push_back({t[0], ab, ca});
        finer.push_back({ab, t[1], bc});
        finer.push_back({ca, bc, t[2]});
        finer.push_back({ab, bc, ca});
    }
    mesh.triangles = std::move(finer);
}

}  // namespace

Mesh make_grid(int columns, int rows, glm::dvec2 size) {
    Mesh mesh;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            const glm::dvec2 uv(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
            add_vertex(mesh, {uv.x * size.x, uv.y * size.y, 0.0}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0},
                       uv);
        }
    }
    add_quads(mesh, columns, rows);
    mesh.world_per_uv = size;
    return mesh;
}

Mesh make_cylinder(int segments, int rings, double radius, double height) {
    Mesh mesh;
    for (int j = 0; j <= rings; ++j) {
        const double v = static_cast<double>(j) / rings;
        for (int i = 0; i <= segments; ++i) {
            // The last column takes the angle of the first, so that its bits are the same.
            const double angle = 2.0 * kPi * (i % segments) / segments;
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            add_vertex(mesh, {radius * c, radius * s, v * height}, {c, s, 0.0}, {-s, c, 0.0},
                       {static_cast<double>(i) / segments, v});
        }
    }
    add_quads(mesh, segments, rings);
    mesh.world_per_uv = measure_world_per_uv(mesh);
    return mesh;
}

Mesh make_icosphere(int subdivisions, double radius) {
    Mesh mesh = make_icosahedron();
    for (int i = 0; i < subdivisions; ++i) subdivide(mesh);
    mesh.normals = mesh.positions;
    project_round(mesh, RoundProjection{});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const double angle = 2.0 * kPi * mesh.uv[i].x;
        const glm::dvec3 n = mesh.normals[i];
        const double rho = std::sqrt(n.x * n.x + n.y * n.y);
        // East, from the position so that seam copies agree; at a pole from the copy's own u.
        mesh.tangents.push_back(rho > 1e-12 ? glm::dvec3(-n.y / rho, n.x / rho, 0.0)
                                            : glm::dvec3(-std::sin(angle), std::cos(angle), 0.0));
        mesh.handedness.push_back(1.0);
        mesh.positions[i] = n * radius;
    }
    mesh.world_per_uv = measure_world_per_uv(mesh);
    return mesh;
}

}  // namespace repousse::host
