#include "testbench/host/mesh/uv_projection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace repousse::host {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGrid = 1073741824.0;  // 2^30: 30 fraction bits leave 23 for u + 1 and the map

double on_grid(double value) { return std::floor(value * kGrid + 0.5) / kGrid; }

/// uv of one point. `on_axis` says that the azimuth is meaningless there.
glm::dvec2 project(const RoundProjection& projection, const glm::dvec3& position, bool& on_axis) {
    const glm::dvec3 d = position - projection.centre;
    const double rho = std::sqrt(d.x * d.x + d.y * d.y);
    on_axis = rho <= 1e-12 * (rho + std::fabs(d.z) + 1e-300);
    double u = on_axis ? 0.0 : on_grid(std::atan2(d.y, d.x) / (2.0 * kPi));
    if (u < 0.0) u += 1.0;
    double v = 0.0;
    if (projection.spherical) {
        v = 0.5 + std::atan2(d.z, rho) / kPi;
    } else if (projection.high_z > projection.low_z) {
        v = (position.z - projection.low_z) / (projection.high_z - projection.low_z);
    }
    return {u, on_grid(v)};
}

/// Hands out the vertex that has the position of `vertex` and the given u, making copies.
class Copies {
public:
    explicit Copies(Mesh& mesh) : mesh_(mesh), taken_(mesh.positions.size(), false) {}

    std::uint32_t at(std::uint32_t vertex, double u) {
        const auto [place, fresh] = found_.try_emplace({vertex, u}, vertex);
        if (!fresh) return place->second;
        if (taken_[vertex]) place->second = copy(vertex);
        taken_[vertex] = true;
        mesh_.uv[place->second].x = u;
        return place->second;
    }

private:
    std::uint32_t copy(std::uint32_t vertex) {
        const glm::dvec3 position = mesh_.positions[vertex];
        const glm::dvec2 uv = mesh_.uv[vertex];
        mesh_.positions.push_back(position);
        mesh_.uv.push_back(uv);
        if (!mesh_.normals.empty()) {
            const glm::dvec3 normal = mesh_.normals[vertex];
            mesh_.normals.push_back(normal);
        }
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    Mesh& mesh_;
    std::vector<bool> taken_;  // the original is in use for some u already
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> found_;
};

}  // namespace

void project_round(Mesh& mesh, const RoundProjection& projection) {
    const std::size_t count = mesh.positions.size();
    mesh.tangents.clear();
    mesh.handedness.clear();
    mesh.uv.assign(count, glm::dvec2(0.0));
    std::vector<char> axis(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        bool on_axis = false;
        mesh.uv[i] = project(projection, mesh.positions[i], on_axis);
        axis[i] = on_axis ? 1 : 0;
    }
    const std::vector<glm::dvec2> base = mesh.uv;
    Copies copies(mesh);
    for (auto& triangle : mesh.triangles) {
        double low = 2.0;
        double high = -1.0;
        int round = 0;  // corners off the axis
        for (const std::uint32_t corner : triangle) {
            if (axis[corner]) continue;
            low = std::min(low, base[corner].x);
            high = std::max(high, base[corner].x);
            ++round;
        }
        // A triangle never spans half a turn, so a wider one crosses the meridian.
        const bool crosses = high - low > 0.5;
        double u[3] = {0.0, 0.0, 0.0};
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) {
            if (axis[triangle[k]]) continue;
            u[k] = base[triangle[k]].x;
            if (crosses && u[k] < 0.5) u[k] += 1.0;
            sum += u[k];
        }
        for (int k = 0; k < 3; ++k) {
            if (axis[triangle[k]]) u[k] = round > 0 ? on_grid(sum / round) : 0.0;
            triangle[k] = copies.at(triangle[k], u[k]);
        }
    }
}

void project_planar(Mesh& mesh) {
    mesh.tangents.clear();
    mesh.handedness.clear();
    mesh.uv.assign(mesh.positions.size(), glm::dvec2(0.0));
    if (mesh.positions.empty()) return;
    glm::dvec3 low = mesh.positions[0];
    glm::dvec3 high = low;
    for (const glm::dvec3& p : mesh.positions) {
        low = glm::dvec3(std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z));
        high = glm::dvec3(std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z));
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3& p = mesh.positions[i];
        if (high.x > low.x) mesh.uv[i].x = (p.x - low.x) / (high.x - low.x);
        if (high.y > low.y) mesh.uv[i].y = (p.y - low.y) / (high.y - low.y);
    }
}

}  // namespace repousse::host
