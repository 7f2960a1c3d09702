#include "testbench/host/view/visibility_buffer.h"

#include <algorithm>

namespace repousse::host {

void VisibilityBuffer::draw(const std::vector<Piece>& pieces, int first_row) {
    std::fill(samples_.begin(), samples_.end(), Sample{});
    for (const Piece& piece : pieces) {
        if (piece.high_y < first_row || piece.low_y >= first_row + rows_) continue;
        const double* iw = piece.inverse_w;
        const PixelBox box{0, first_row, width_, first_row + rows_};
        rasterise(piece.at[0], piece.at[1], piece.at[2], box, [&](int x, int y, const Weights& w) {
            // 1/w is linear on the screen; equal depths keep the earlier triangle.
            const double depth = w.a * iw[0] + w.b * iw[1] + w.c * iw[2];
            Sample& sample = samples_[static_cast<std::size_t>(y - first_row) *
                                          static_cast<std::size_t>(width_) +
                                      static_cast<std::size_t>(x)];
            if (static_cast<float>(depth) <= sample.inverse_w) return;
            const glm::dvec3 corners =
                (piece.corner_weights[0] * (w.a * iw[0]) + piece.corner_weights[1] * (w.b * iw[1]) +
                 piece.corner_weights[2] * (w.c * iw[2])) /
                depth;
            sample = {static_cast<float>(depth), piece.triangle, static_cast<float>(corners.y),
                      static_cast<float>(corners.z)};
        });
    }
}

void add_pieces(std::vector<Piece>& pieces, const RenderMesh& mesh, std::uint32_t first,
                const ViewProjection& view, int samples) {
    std::vector<ClipVertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (const glm::dvec3& p : mesh.positions) vertices.push_back(clip_vertex(view, p));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const ClipPolygon polygon =
            clip_triangle(view, vertices[t[0]], vertices[t[1]], vertices[t[2]]);
        for (int k = 2; k < polygon.count; ++k) {
            Piece piece;
            piece.triangle = first + static_cast<std::uint32_t>(i);
            const int corners[3] = {0, k - 1, k};
            for (int j = 0; j < 3; ++j) {
                const ClipVertex& v = polygon.corners[static_cast<std::size_t>(corners[j])];
                piece.at[j] = snap(view, v, samples);
                piece.inverse_w[j] = 1.0 / v.w;
                piece.corner_weights[j] = v.corner_weights;
            }
            const auto [low, high] = std::minmax({piece.at[0].y, piece.at[1].y, piece.at[2].y});
            piece.low_y = static_cast<int>(low >> kSubpixelBits);
            piece.high_y = static_cast<int>(high >> kSubpixelBits);
            pieces.push_back(piece);
        }
    }
}

std::vector<FillCount> count_fills(const std::vector<Piece>& pieces, int width, int height) {
    std::vector<FillCount> counts(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
    for (const Piece& piece : pieces) {
        // Rows run downwards, so what is counter-clockwise to the eye has a negative area.
        const bool is_front = doubled_area(piece.at[0], piece.at[1], piece.at[2]) < 0;
        const auto count = [&](int x, int y, const Weights&) {
            FillCount& sample =
                counts[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
            ++(is_front ? sample.front : sample.back);
        };
        rasterise(piece.at[0], piece.at[1], piece.at[2], {0, 0, width, height}, count);
    }
    return counts;
}

}  // namespace repousse::host
