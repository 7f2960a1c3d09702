#include "testbench/host/view/render.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/view/shading.h"
#include "testbench/host/view/visibility_buffer.h"

namespace repousse::host {
namespace {

constexpr int kBandRows = 32;
constexpr int kShadowCells = 2048;

/// One triangle of one mesh, found again from a sample.
struct Surface {
    const RenderMesh* mesh;
    std::uint32_t first;                // number of its first triangle
    std::vector<glm::dvec3> on_screen;  // of its vertices, for the wireframe: (x w, y w, w), pixels
};

/// How dark the wireframe is at a point: 1 on an edge, 0 from a pixel away. Where triangles are so
/// small that their lines would merge, the lines fade, down to a grey that still says how dense the
/// mesh is. `b` are the corner weights at the point.
///
/// In homogeneous coordinates the line through two vertices is their cross product, wherever they
/// are; so a triangle that reaches behind the eye has its edges drawn like any other.
double wire_strength(const glm::dvec3 (&p)[3], const glm::dvec3& b) {
    const double w = b.x * p[0].z + b.y * p[1].z + b.z * p[2].z;
    const double volume = std::fabs(glm::dot(p[0], glm::cross(p[1], p[2])));
    double nearest = 1e9;
    double lowest = 1e9;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 line = glm::cross(p[(k + 1) % 3], p[(k + 2) % 3]);
        const double scale = w * std::hypot(line.x, line.y);
        if (!(scale > 0.0)) return 0.0;
        // The point is b . p / w, and line . p is 0 at the line's own vertices: what is left of
        // the distance |line . point| is the weight of corner k times this, its altitude on the
        // screen (of a triangle across the view; in perspective, as steep as it is here).
        const double altitude = volume / scale;
        nearest = std::min(nearest, b[k] * altitude);
        lowest = std::min(lowest, altitude);
    }
    const double line = std::clamp(1.1 - nearest, 0.0, 1.0);
    return line * std::clamp(lowest / 6.0, 0.2, 1.0);
}

class Painter {
public:
    Painter(const std::vector<RenderMesh>& meshes, const ViewProjection& projection,
            const ViewSettings& view, const Shader& shader, int samples)
        : view_(view), shader_(shader) {
        std::uint32_t first = 0;
        for (const RenderMesh& mesh : meshes) {
            Surface surface{&mesh, first, {}};
            if (view.wireframe && mesh.kind == RenderMesh::Kind::Surface) {
                for (const glm::dvec3& p : mesh.positions) {
                    const ClipVertex v = clip_vertex(projection, p);
                    surface.on_screen.emplace_back(
                        projection.centre_x * v.w + projection.scale_x * v.x,
                        projection.centre_y * v.w + projection.scale_y * v.y, v.w);
                }
            }
            surfaces_.push_back(std::move(surface));
            add_pieces(pieces, mesh, first, projection, samples);
            first += static_cast<std::uint32_t>(mesh.triangles.size());
        }
    }

    /// Light at a place on a triangle, on a pixel with this background.
    glm::dvec3 paint(std::uint32_t triangle, double weight_b, double weight_c,
                     const glm::dvec3& background) const {
        std::size_t s = surfaces_.size() - 1;
        while (surfaces_[s].first > triangle) --s;
        const RenderMesh& mesh = *surfaces_[s].mesh;
        const auto& t = mesh.triangles[triangle - surfaces_[s].first];
        const glm::dvec3 b(1.0 - weight_b - weight_c, weight_b, weight_c);
        auto mixed = [&](const auto& list) {
            return list[t[0]] * b.x + list[t[1]] * b.y + list[t[2]] * b.z;
        };
        const glm::dvec3 position = mixed(mesh.positions);
        if (mesh.kind == RenderMesh::Kind::Floor) return background * shader_.floor_light(position);
        const glm::dvec3 face = face_normal(mesh, t);
        const glm::dvec3 smooth = mesh.normals.empty() ? face : mixed(mesh.normals);
        // The face decides which side is seen: near a silhouette the smooth normal already looks
        // away from the eye while the face does not.
        const double side = glm::dot(face, shader_.eye() - position) < 0.0 ? -1.0 : 1.0;
        const glm::dvec3 normal = glm::normalize(smooth) * side;
        if (mesh.kind == RenderMesh::Kind::Side) {
            return shader_.shade(position, normal, shader_.stratum(position.z), false);
        }
        std::optional<double> height;
        if (!mesh.heights.empty()) height = mixed(mesh.heights);
        const glm::dvec3 colour =
            mesh.colours.empty()
                ? shader_.shade(position, normal, shader_.albedo(height), view_.tint == Tint::Plain)
                : mixed(mesh.colours);
        if (surfaces_[s].on_screen.empty()) return colour;
        const auto& screen = surfaces_[s].on_screen;
        const double wire = wire_strength({screen[t[0]], screen[t[1]], screen[t[2]]}, b);
        return glm::mix(colour, colour * 0.1 + glm::dvec3(0.005, 0.006, 0.008), 0.85 * wire);
    }

    std::vector<Piece> pieces;

private:
    static glm::dvec3 face_normal(const RenderMesh& mesh, const std::array<std::uint32_t, 3>& t) {
        const glm::dvec3 n = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                        mesh.positions[t[2]] - mesh.positions[t[0]]);
        return glm::length(n) > 0.0 ? n : glm::dvec3(0.0, 0.0, 1.0);
    }

    const ViewSettings& view_;
    const Shader& shader_;
    std::vector<Surface> surfaces_;
};

/// Mean of a pixel's samples; each triangle among them is shaded once, at their mean place.
glm::dvec3 resolve(const VisibilityBuffer& buffer, const Painter& painter, int x, int y,
                   int samples, const glm::dvec3& background) {
    glm::dvec3 sum(0.0);
    Sample seen[16];
    int count = 0;
    for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
            seen[count++] = buffer.at(x * samples + i, y * samples + j);
        }
    }
    for (int k = 0; k < count; ++k) {
        if (seen[k].inverse_w == 0.0f) {
            sum += background;
            continue;
        }
        if (seen[k].inverse_w < 0.0f) continue;  // shaded with an earlier sample
        double b = 0.0;
        double c = 0.0;
        int same = 0;
        for (int m = k; m < count; ++m) {
            if (seen[m].inverse_w <= 0.0f || seen[m].triangle != seen[k].triangle) continue;
            b += static_cast<double>(seen[m].weight_b);
            c += static_cast<double>(seen[m].weight_c);
            ++same;
            if (m > k) seen[m].inverse_w = -1.0f;
        }
        sum += painter.paint(seen[k].triangle, b / same, c / same, background) *
               static_cast<double>(same);
    }
    return sum / static_cast<double>(count);
}

/// Surfaces as they are drawn: normals filled in, sides and floor added.
std::vector<RenderMesh> prepare(const std::vector<RenderMesh>& surfaces, const ViewSettings& view) {
    std::vector<RenderMesh> meshes = surfaces;
    for (RenderMesh& mesh : meshes) {
        if (view.shading == Shading::Flat) {
            mesh.normals.clear();
        } else if (mesh.normals.empty()) {
            mesh.normals = area_weighted_normals(mesh.positions, mesh.triangles);
        }
    }
    if (!view.skirt) return meshes;
    for (const RenderMesh& surface : surfaces) {
        const double base = block_base(surface);
        meshes.push_back(make_skirt(surface, base));
        if (view.shadows) meshes.push_back(make_floor(surface, base));
    }
    return meshes;
}

glm::dvec3 linear(const glm::dvec3& srgb) {
    return {srgb_to_linear(srgb.x), srgb_to_linear(srgb.y), srgb_to_linear(srgb.z)};
}

}  // namespace

Picture render(const std::vector<RenderMesh>& surfaces, const CameraSettings& camera,
               const Viewport& viewport, const ViewSettings& view,
               const std::vector<Light>& lights) {
    const std::vector<RenderMesh> meshes = prepare(surfaces, view);
    const ViewProjection projection = view_projection(camera, viewport);
    std::unique_ptr<ShadowMap> shadows;
    if (view.shadows && !lights.empty()) {
        const double softness = 0.0025 * glm::length(camera.target - camera.eye);
        shadows = std::make_unique<ShadowMap>(meshes, lights[0].direction, kShadowCells, softness);
    }
    const Shader shader(view, lights, camera.eye, shadows.get());
    const Painter painter(meshes, projection, view, shader, view.samples);
    VisibilityBuffer buffer(viewport.width_px, kBandRows, view.samples);
    Picture picture;
    picture.width = viewport.width_px;
    picture.height = viewport.height_px;
    picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) *
                       static_cast<std::size_t>(picture.height));
    for (int band = 0; band < picture.height; band += kBandRows) {
        buffer.draw(painter.pieces, band * view.samples);
        for (int y = band; y < std::min(band + kBandRows, picture.height); ++y) {
            const double down = (y + 0.5) / picture.height;
            const glm::dvec3 background = linear(glm::mix(view.background, view.horizon, down));
            for (int x = 0; x < picture.width; ++x) {
                const glm::dvec3 light =
                    resolve(buffer, painter, x, y - band, view.samples, background);
                float* pixel = picture.pixel(x, y);
                for (int k = 0; k < 3; ++k) pixel[k] = static_cast<float>(light[k]);
            }
        }
    }
    return picture;
}

Picture render_scene(const Scene& scene, const std::vector<RenderMesh>& surfaces) {
    return render(surfaces, scene.camera, scene.viewport, scene.view, scene.lights);
}

}  // namespace repousse::host
