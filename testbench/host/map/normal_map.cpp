#include "testbench/host/map/normal_map.h"

#include <cmath>

namespace repousse::host {
namespace {

/// The two texels whose difference is the slope at `i`, and how many texels they are apart.
struct Stencil {
    int low = 0;
    int high = 0;
    int distance = 1;
};

Stencil stencil(int i, int size, bool wrap) {
    if (size == 1) return {0, 0, 1};
    if (wrap) return {i == 0 ? size - 1 : i - 1, i == size - 1 ? 0 : i + 1, 2};
    const int low = i == 0 ? 0 : i - 1;
    const int high = i == size - 1 ? size - 1 : i + 1;
    return {low, high, high - low};
}

}  // namespace

std::vector<glm::dvec3> normal_map(const HeightMap& map, double texel_width, double texel_height) {
    std::vector<glm::dvec3> normals;
    normals.reserve(map.texels.size());
    const double unit = map.world_per_lsb();
    for (int y = 0; y < map.height; ++y) {
        const Stencil v = stencil(y, map.height, map.wrap);
        for (int x = 0; x < map.width; ++x) {
            const Stencil u = stencil(x, map.width, map.wrap);
            const int rise_x = int{map.at(u.high, y)} - int{map.at(u.low, y)};
            const int rise_y = int{map.at(x, v.high)} - int{map.at(x, v.low)};
            const double slope_x = rise_x * unit / (u.distance * texel_width);
            const double slope_y = rise_y * unit / (v.distance * texel_height);
            const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0);
            normals.emplace_back(-slope_x / length, -slope_y / length, 1.0 / length);
        }
    }
    return normals;
}

glm::dvec2 turns_of(const glm::dvec3& n) {
    constexpr double kPi = 3.14159265358979323846;
    return {std::atan2(n.x, std::hypot(n.y, n.z)) / kPi, std::atan2(n.y, n.z) / kPi};
}

}  // namespace repousse::host
