#include "testbench/host/view/render_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_check.h"

namespace repousse::host {
namespace {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

Box box_of(const RenderMesh& mesh) {
    Box box;
    for (const glm::dvec3& p : mesh.positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

}  // namespace

double block_base(const RenderMesh& surface) {
    if (surface.positions.empty()) return 0.0;
    const Box box = box_of(surface);
    return box.low.z - 0.04 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
}

RenderMesh make_skirt(const RenderMesh& surface, double base_z) {
    const std::vector<std::uint32_t> welded = weld(surface.positions);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : surface.triangles) {
        for (int k = 0; k < 3; ++k) ++uses[{welded[t[k]], welded[t[(k + 1) % 3]]}];
    }
    RenderMesh skirt;
    skirt.kind = RenderMesh::Kind::Side;
    for (const auto& [edge, count] : uses) {
        if (uses.count({edge.second, edge.first}) > 0) continue;  // has a neighbour
        const glm::dvec3 a = surface.positions[edge.first];
        const glm::dvec3 b = surface.positions[edge.second];
        const glm::dvec3 along(b.x - a.x, b.y - a.y, 0.0);
        const double length = glm::length(along);
        if (!(length > 0.0)) continue;
        // The surface lies to the left of a -> b, so the wall faces right.
        const glm::dvec3 normal(along.y / length, -along.x / length, 0.0);
        const auto first = static_cast<std::uint32_t>(skirt.positions.size());
        for (const glm::dvec3& p :
             {a, glm::dvec3(a.x, a.y, base_z), glm::dvec3(b.x, b.y, base_z), b}) {
            skirt.positions.push_back(p);
            skirt.normals.push_back(normal);
        }
        skirt.triangles.push_back({first, first + 1, first + 2});
        skirt.triangles.push_back({first, first + 2, first + 3});
    }
    return skirt;
}

RenderMesh make_floor(const RenderMesh& surface, double base_z) {
    RenderMesh floor;
    floor.kind = RenderMesh::Kind::Floor;
    if (surface.positions.empty()) return floor;
    const Box box = box_of(surface);
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    const double reach = 3.0 * std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        floor.positions.emplace_back(middle.x + sx * reach, middle.y + sy * reach, base_z);
        floor.normals.emplace_back(0.0, 0.0, 1.0);
    }
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    return floor;
}

}  // namespace repousse::host
