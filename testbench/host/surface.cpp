#include "testbench/host/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "testbench/host/scene/assets.h"
#include "testbench/host/shade_registers.h"

namespace repousse::host {
namespace {

// A corner's words: what has the same words is the same vertex.
using Key = std::array<uint64_t, 10>;

struct KeyHash {
    std::size_t operator()(const Key& key) const {
        uint64_t h = 0x9E3779B97F4A7C15ULL;
        for (const uint64_t word : key) h = (h ^ word) * 0xBF58476D1CE4E5B9ULL ^ (h >> 31);
        return static_cast<std::size_t>(h);
    }
};

template <class V>
uint64_t bits(V value) {
    uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    return word;
}

template <class OutputVertex>
Key key_of(const OutputVertex& v) {
    const uint64_t uv = uint64_t(uint32_t(v.uv.x)) << 32 | uint32_t(v.uv.y);
    return {uv,
            bits(v.displaced.x),
            bits(v.displaced.y),
            bits(v.displaced.z),
            bits(v.displaced_normal.x),
            bits(v.displaced_normal.y),
            bits(v.displaced_normal.z),
            bits(v.colour.red),
            bits(v.colour.green),
            bits(v.colour.blue)};
}

template <class V>
glm::dvec3 to_double(const Vec3<V>& v, int frac) {
    return {std::ldexp(double(v.x), -frac), std::ldexp(double(v.y), -frac),
            std::ldexp(double(v.z), -frac)};
}

glm::dvec2 texel_of(Uv uv, int frac) {
    return {std::ldexp(double(uv.x), -frac), std::ldexp(double(uv.y), -frac)};
}

double bilinear_height(const HeightMap& map, glm::dvec2 texel) {
    const auto address = [&](int i, int size) {
        return map.wrap ? (i % size + size) % size : std::clamp(i, 0, size - 1);
    };
    const double x = texel.x - .5, y = texel.y - .5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const auto at = [&](int di, int dj) {
        return double(map.at(address(i + di, map.width), address(j + dj, map.height)));
    };
    const double fx = x - i, fy = y - j;
    const double lower = at(0, 0) + (at(1, 0) - at(0, 0)) * fx;
    const double upper = at(0, 1) + (at(1, 1) - at(0, 1)) * fx;
    return (lower + (upper - lower) * fy) / 65535.;
}

// `corner(t, k)` is corner k of triangle t.
template <class P, class Corner>
Mesh mesh_of(std::size_t triangles, Corner&& corner, const Profile& profile,
             const DrawInputs& inputs) {
    const bool is_real = std::is_same_v<P, Real>;
    const int position_frac = is_real ? 0 : profile.position.frac;
    const int normal_frac = is_real ? 0 : profile.displaced_normal.frac;
    const bool has_normals = inputs.bump || inputs.settings.normal_threshold.has_value();
    Mesh mesh;
    std::unordered_map<Key, uint32_t, KeyHash> numbers;
    mesh.triangles.reserve(triangles);
    for (std::size_t t = 0; t < triangles; ++t) {
        std::array<uint32_t, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& v = corner(t, k);
            const auto next = static_cast<uint32_t>(mesh.positions.size());
            const auto [entry, is_new] = numbers.emplace(key_of(v), next);
            corners[k] = entry->second;
            if (!is_new) continue;
            mesh.positions.push_back(to_double(v.displaced, position_frac));
            mesh.uv.push_back(map_uv(texel_of(v.uv, profile.uv.frac), *inputs.map, inputs.uv));
            if (has_normals) {
                mesh.normals.push_back(to_double(v.displaced_normal, normal_frac));
            }
            if (inputs.shade) mesh.colours.push_back(linear_light<P>(v.colour, profile));
        }
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

}  // namespace

template <class P>
Mesh surface_mesh(const std::vector<OutputTriangle<P>>& triangles, const Profile& profile,
                  const DrawInputs& inputs) {
    const auto corner = [&](std::size_t t, std::size_t k) -> const OutputVertex<P>& {
        return triangles[t].corners[k];
    };
    return mesh_of<P>(triangles.size(), corner, profile, inputs);
}

template <class P>
Mesh surface_mesh(const SweepMesh<P>& mesh, const Profile& profile, const DrawInputs& inputs) {
    const auto corner = [&](std::size_t t, std::size_t k) -> const SweepOutputVertex<P>& {
        return mesh.corner(mesh.triangles[t], k);
    };
    return mesh_of<P>(mesh.triangles.size(), corner, profile, inputs);
}

RenderMesh surface_view(const Mesh& surface, const DrawInputs& inputs) {
    RenderMesh view;
    view.positions = surface.positions;
    view.triangles = surface.triangles;
    view.colours = surface.colours;
    for (const glm::dvec3& n : surface.normals) {
        const double length = glm::length(n);
        view.normals.push_back(length > 0 ? n / length : glm::dvec3(0, 0, 1));
    }
    for (const glm::dvec2& uv : surface.uv) {
        view.heights.push_back(
            bilinear_height(*inputs.map, texel_coordinate(uv, *inputs.map, inputs.uv)));
    }
    return view;
}

template Mesh surface_mesh(const std::vector<OutputTriangle<Fixed>>&, const Profile&,
                           const DrawInputs&);
template Mesh surface_mesh(const std::vector<OutputTriangle<Real>>&, const Profile&,
                           const DrawInputs&);
template Mesh surface_mesh(const SweepMesh<Fixed>&, const Profile&, const DrawInputs&);
template Mesh surface_mesh(const SweepMesh<Real>&, const Profile&, const DrawInputs&);

}  // namespace repousse::host
