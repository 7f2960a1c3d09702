// What a sample sees of a triangle: perspective-correct corner weights, whatever is interpolated
// with them (normals, heights, colours, texture coordinates).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/view/visibility_buffer.h"
#include "testbench/tests/support/from_above.h"

namespace repousse::host {
namespace {

using test::from_above;

/// The corner weights of the point where the ray of a pixel's place meets a triangle's plane.
glm::dvec3 ray_weights(const ViewFrame& frame, double x, double y, const glm::dvec3 (&p)[3]) {
    const glm::dvec3 ray = frame.forward + frame.right * ((x - frame.centre.x) / frame.focal.x) +
                           frame.up * ((y - frame.centre.y) / frame.focal.y);
    const glm::dvec3 e[3] = {p[0] - frame.eye, p[1] - frame.eye, p[2] - frame.eye};
    // Signed volumes of (ray, edge) over their sum: Cramer's rule for e b = t ray, b summing to 1.
    const glm::dvec3 volumes(glm::dot(ray, glm::cross(e[1], e[2])),
                             glm::dot(ray, glm::cross(e[2], e[0])),
                             glm::dot(ray, glm::cross(e[0], e[1])));
    return volumes / (volumes.x + volumes.y + volumes.z);
}

/// Largest errors over random triangles whose corners are 1 to 1000 away.
struct AttributeErrors {
    double correct = 0.0;  ///< of attributes in 0..1, as the view interpolates them
    double affine = 0.0;   ///< if it did so on the screen
    std::size_t samples = 0;
};

TEST(Attributes, AreTheExactRayPlaneValues) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const CameraSettings camera = from_above();
    const Viewport viewport{64, 48};
    const ViewFrame frame = view_frame(camera, viewport);
    const ViewProjection projection = view_projection(camera, viewport);
    AttributeErrors worst;
    for (int n = 0; n < 400; ++n) {
        const int samples = 1 + n % 4;
        RenderMesh mesh;
        glm::dvec3 at[3];
        double u[3];
        for (int k = 0; k < 3; ++k) {
            // On the raster that vertices are snapped to, so that snapping changes nothing.
            const double x = std::floor(unit(random) * 64 * samples * 256) / 256 / samples;
            const double y = std::floor(unit(random) * 48 * samples * 256) / 256 / samples;
            const double w = std::pow(10.0, 3.0 * unit(random)) / 20.0;
            at[k] = frame.eye +
                    w * (frame.forward + frame.right * ((x - frame.centre.x) / frame.focal.x) +
                         frame.up * ((y - frame.centre.y) / frame.focal.y));
            u[k] = unit(random);
            mesh.positions.push_back(at[k]);
        }
        mesh.triangles = {{0, 1, 2}};
        std::vector<Piece> pieces;
        add_pieces(pieces, mesh, 0, projection, samples);
        VisibilityBuffer buffer(64, 48, samples);
        buffer.draw(pieces, 0);
        for (int y = 0; y < 48 * samples; ++y) {
            for (int x = 0; x < 64 * samples; ++x) {
                const Sample& sample = buffer.at(x, y);
                if (sample.inverse_w == 0.0f) continue;
                const double px = (x + 0.5) / samples, py = (y + 0.5) / samples;
                const glm::dvec3 b = ray_weights(frame, px, py, at);
                const double exact = u[0] * b.x + u[1] * b.y + u[2] * b.z;
                const double wb = static_cast<double>(sample.weight_b);
                const double wc = static_cast<double>(sample.weight_c);
                const double found = u[0] * (1.0 - wb - wc) + u[1] * wb + u[2] * wc;
                worst.correct = std::max(worst.correct, std::fabs(found - exact));
                // Weights on the screen: each is b w over the sum of the three.
                glm::dvec3 flat(b.x * projection.project(at[0]).w,
                                b.y * projection.project(at[1]).w,
                                b.z * projection.project(at[2]).w);
                flat /= flat.x + flat.y + flat.z;
                worst.affine = std::max(
                    worst.affine, std::fabs(u[0] * flat.x + u[1] * flat.y + u[2] * flat.z - exact));
                ++worst.samples;
            }
        }
    }
    std::printf("%zu samples: error %.1e, affine %.2f\n", worst.samples, worst.correct,
                worst.affine);
    EXPECT_LE(worst.correct, 5e-7);
    EXPECT_GT(worst.affine, 0.5);
    EXPECT_GT(worst.samples, 200'000u);
}

TEST(Attributes, BelongToASampleAlsoOnTrianglesThatWereClippedOrSnapped) {
    // The interpolated place, projected, is the sample's centre but for the snapping of vertices:
    // at most 1/512 of a sample in x and y.
    Mesh grid = make_grid(7, 9, {40.0, 60.0});
    RenderMesh plain;
    plain.triangles = grid.triangles;
    for (const glm::dvec3& p : grid.positions) {
        plain.positions.push_back({p.x - 19.0, p.y - 21.0, 0.2 * std::sin(3.0 * p.x + p.y)});
    }
    CameraSettings camera;
    camera.eye = {0.3, -1.0, 1.1};
    camera.target = {0.2, 4.0, 0.3};
    camera.near = 0.05;
    const Viewport viewport{80, 60};
    const ViewProjection projection = view_projection(camera, viewport);
    for (int samples = 1; samples <= 4; ++samples) {
        std::vector<Piece> pieces;
        add_pieces(pieces, plain, 0, projection, samples);
        EXPECT_NE(pieces.size(), plain.triangles.size()) << "nothing was clipped";
        VisibilityBuffer buffer(viewport.width_px, viewport.height_px, samples);
        buffer.draw(pieces, 0);
        double worst = 0.0;
        std::size_t seen = 0;
        for (int y = 0; y < viewport.height_px * samples; ++y) {
            for (int x = 0; x < viewport.width_px * samples; ++x) {
                const Sample& s = buffer.at(x, y);
                if (s.inverse_w == 0.0f) continue;
                const auto& t = plain.triangles[s.triangle];
                const double b = static_cast<double>(s.weight_b);
                const double c = static_cast<double>(s.weight_c);
                const ScreenPoint back =
                    projection.project(plain.positions[t[0]] * (1.0 - b - c) +
                                       plain.positions[t[1]] * b + plain.positions[t[2]] * c);
                worst = std::max({worst, std::fabs(back.x * samples - x - 0.5),
                                  std::fabs(back.y * samples - y - 0.5)});
                ++seen;
            }
        }
        EXPECT_LE(worst, 1.0 / 512 + 2e-3) << samples;  // and weights are floats
        EXPECT_GT(seen, 2000u * samples * samples);
    }
}

}  // namespace
}  // namespace repousse::host
