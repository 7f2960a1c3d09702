#include "testbench/host/mesh/mesh_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/uv_projection.h"

namespace repousse::host {
namespace {

/// How a triangle's position depends on u and v. `sign` is that of its UV area, 0 without one.
struct UvFrame {
    glm::dvec3 per_u{0.0};
    glm::dvec3 per_v{0.0};
    double area = 0.0;  // world
    int sign = 0;
};

UvFrame uv_frame(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
    const glm::dvec3 e1 = mesh.positions[t[1]] - mesh.positions[t[0]];
    const glm::dvec3 e2 = mesh.positions[t[2]] - mesh.positions[t[0]];
    const glm::dvec2 d1 = mesh.uv[t[1]] - mesh.uv[t[0]];
    const glm::dvec2 d2 = mesh.uv[t[2]] - mesh.uv[t[0]];
    UvFrame frame;
    frame.area = 0.5 * glm::length(glm::cross(e1, e2));
    const double det = d1.x * d2.y - d2.x * d1.y;
    if (det == 0.0) return frame;
    frame.sign = det > 0.0 ? 1 : -1;
    frame.per_u = (e1 * d2.y - e2 * d1.y) / det;
    frame.per_v = (e2 * d1.x - e1 * d2.x) / det;
    return frame;
}

/// A unit vector at right angles to `normal`, for vertices without UV area.
glm::dvec3 any_tangent(const glm::dvec3& normal) {
    const glm::dvec3 axis =
        std::fabs(normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

/// UV modulo whole maps, on a grid of 2^-20: what makes two copies of a vertex one in a wrapped
/// map.
std::pair<std::int64_t, std::int64_t> uv_in_map(const glm::dvec2& uv) {
    constexpr double kSteps = 1048576.0;
    constexpr std::int64_t kMask = 1048575;
    return {static_cast<std::int64_t>(std::floor(uv.x * kSteps + 0.5)) & kMask,
            static_cast<std::int64_t>(std::floor(uv.y * kSteps + 0.5)) & kMask};
}

}  // namespace

std::vector<glm::dvec3> area_weighted_normals(
    const std::vector<glm::dvec3>& positions,
    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    const std::vector<std::uint32_t> welded = weld(positions);
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (const auto& t : triangles) {
        const glm::dvec3 twice_area =
            glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
        for (const std::uint32_t corner : t) sums[welded[corner]] += twice_area;
    }
    std::vector<glm::dvec3> normals(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3& sum = sums[welded[i]];
        const double length = glm::length(sum);
        normals[i] = length > 0.0 ? sum / length : glm::dvec3(0.0, 0.0, 1.0);
    }
    return normals;
}

void project_uv(Mesh& mesh, UvProjection projection) {
    if (projection == UvProjection::None) return;
    if (projection == UvProjection::Planar) return project_planar(mesh);
    const MeshDiagnosis box = mesh_check(mesh);
    RoundProjection round;
    round.centre = (box.low + box.high) * 0.5;
    round.spherical = projection == UvProjection::Spherical;
    round.low_z = box.low.z;
    round.high_z = box.high.z;
    project_round(mesh, round);
}

void compute_tangents(Mesh& mesh) {
    const std::size_t count = mesh.positions.size();
    std::vector<UvFrame> frames;
    frames.reserve(mesh.triangles.size());
    std::vector<double> votes(count, 0.0);
    for (const auto& t : mesh.triangles) {
        frames.push_back(uv_frame(mesh, t));
        for (const std::uint32_t corner : t)
            votes[corner] += frames.back().sign * frames.back().area;
    }
    // A group is what may share a tangent: position, place in the map, handedness.
    const std::vector<std::uint32_t> welded = weld(mesh.positions);
    using Key = std::tuple<std::uint32_t, std::pair<std::int64_t, std::int64_t>, int>;
    std::map<Key, std::uint32_t> groups;
    std::vector<std::uint32_t> group(count);
    mesh.handedness.assign(count, 1.0);
    for (std::size_t i = 0; i < count; ++i) {
        const int hand = votes[i] < 0.0 ? -1 : 1;
        mesh.handedness[i] = hand;
        const Key key{welded[i], uv_in_map(mesh.uv[i]), hand};
        group[i] = groups.try_emplace(key, static_cast<std::uint32_t>(groups.size())).first->second;
    }
    std::vector<glm::dvec3> sums(groups.size(), glm::dvec3(0.0));
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        const double length = glm::length(frames[k].per_u);
        if (!(length > 0.0)) continue;
        const glm::dvec3 weighted = frames[k].per_u * (frames[k].area / length);
        for (const std::uint32_t corner : mesh.triangles[k]) sums[group[corner]] += weighted;
    }
    mesh.tangents.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3& n = mesh.normals[i];
        const glm::dvec3 flat = sums[group[i]] - n * glm::dot(n, sums[group[i]]);
        const double length = glm::length(flat);
        mesh.tangents[i] = length > 1e-300 ? flat / length : any_tangent(n);
    }
}

glm::dvec2 measure_world_per_uv(const Mesh& mesh) {
    glm::dvec2 sum(0.0);
    double area = 0.0;
    for (const auto& t : mesh.triangles) {
        const UvFrame frame = uv_frame(mesh, t);
        if (frame.sign == 0) continue;
        sum += glm::dvec2(glm::length(frame.per_u), glm::length(frame.per_v)) * frame.area;
        area += frame.area;
    }
    return area > 0.0 ? sum / area : glm::dvec2(0.0);
}

Status complete_mesh(Mesh& mesh, UvProjection projection, const std::string& name) {
    project_uv(mesh, projection);
    if (mesh.uv.empty()) {
        return Error{ErrorKind::Input, name, "the mesh has no texture coordinates",
                     "UV in the file, or projection = \"planar\", \"spherical\" or \"cylindrical\"",
                     ""};
    }
    if (mesh.normals.empty()) mesh.normals = area_weighted_normals(mesh.positions, mesh.triangles);
    if (mesh.tangents.empty() || mesh.handedness.empty()) compute_tangents(mesh);
    if (mesh.world_per_uv == glm::dvec2(0.0)) mesh.world_per_uv = measure_world_per_uv(mesh);
    return done();
}

}  // namespace repousse::host
