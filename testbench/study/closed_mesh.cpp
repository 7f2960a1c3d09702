#include "testbench/study/closed_mesh.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/procedural_mesh.h"

namespace repousse::study {

host::Mesh welded(const host::Mesh& mesh) {
    const std::vector<uint32_t> first = host::weld(mesh.positions);
    std::vector<uint32_t> place(mesh.positions.size());
    host::Mesh out;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) continue;
        place[i] = static_cast<uint32_t>(out.positions.size());
        out.positions.push_back(mesh.positions[i]);
        if (!mesh.normals.empty()) out.normals.push_back(mesh.normals[i]);
        if (!mesh.uv.empty()) out.uv.push_back(mesh.uv[i]);
    }
    for (const auto& t : mesh.triangles) {
        out.triangles.push_back({place[first[t[0]]], place[first[t[1]]], place[first[t[2]]]});
    }
    return out;
}

host::Mesh make_capped_cylinder(int segments, int rings, double radius, double height) {
    host::Mesh mesh = welded(host::make_cylinder(segments, rings, radius, height));
    const auto n = static_cast<uint32_t>(segments);
    const auto bottom = static_cast<uint32_t>(mesh.positions.size()), top = bottom + 1;
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {0, 0, height}});
    mesh.normals.insert(mesh.normals.end(), {{0, 0, -1}, {0, 0, 1}});
    mesh.uv.insert(mesh.uv.end(), {{0.5, 0}, {0.5, 1}});
    const uint32_t last = n * static_cast<uint32_t>(rings);
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t next = (i + 1) % n;
        mesh.triangles.push_back({bottom, next, i});
        mesh.triangles.push_back({top, last + i, last + next});
    }
    for (glm::dvec3& p : mesh.positions) p.z -= height / 2;
    return mesh;
}

host::CameraSettings random_camera(std::mt19937_64& random, double radius, bool inside) {
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * std::ldexp(double(random() >> 11), -53);
    };
    const auto in_ball = [&] {
        glm::dvec3 p;
        do {
            p = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
        } while (glm::length(p) > 1 || glm::length(p) < 0.01);
        return p;
    };
    host::CameraSettings camera;
    camera.eye =
        inside ? radius * 0.5 * in_ball() : radius * uniform(1.02, 4) * glm::normalize(in_ball());
    camera.target = radius * 0.6 * in_ball();
    camera.up = glm::normalize(in_ball());
    camera.fov_deg = uniform(25, 90);
    camera.near = 0.02 * radius;
    camera.far = 10 * radius;
    return camera;
}

}  // namespace repousse::study
