#pragma once

#include <cstdint>
#include <vector>

#include "testbench/host/view/clip.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::host {

/// What a sample sees: the nearest triangle and where on it.
struct Sample {
    float inverse_w = 0.0f;  ///< 0 = background
    std::uint32_t triangle = 0;
    float weight_b = 0.0f;  ///< perspective-correct weights of the triangle's corners b and c
    float weight_c = 0.0f;
};

/// A clipped, projected piece of a triangle, ready for `rasterise`.
struct Piece {
    SnappedVertex at[3];
    double inverse_w[3];
    glm::dvec3 corner_weights[3];
    std::uint32_t triangle;
    int low_y, high_y;  ///< sample rows it can touch
};

/// Depth-tested samples of a band of picture rows. Bands keep the memory small: at 1280 x 720 with
/// 4 x 4 samples the whole picture would take 235 MB.
class VisibilityBuffer {
public:
    VisibilityBuffer(int width, int rows, int samples)
        : width_(width * samples),
          rows_(rows * samples),
          samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows_)) {}

    /// Clears, then draws all pieces that touch sample rows first_row..first_row + rows.
    void draw(const std::vector<Piece>& pieces, int first_row);

    const Sample& at(int x, int y) const {
        return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x)];
    }

private:
    int width_;
    int rows_;
    std::vector<Sample> samples_;
};

/// All pieces of a list of triangles; numbers of triangles count from `first`.
void add_pieces(std::vector<Piece>& pieces, const RenderMesh& mesh, std::uint32_t first,
                const ViewProjection& view, int samples);

/// How many pieces cover a sample's centre when nothing is hidden.
struct FillCount {
    std::uint32_t front = 0;  ///< by pieces that run counter-clockwise in the picture
    std::uint32_t back = 0;   ///< by those that run clockwise
};

/// Fill counts of all samples of a picture, row by row. With the fill rule, front - back is at
/// every sample how often the mesh's rim winds around it: 0 for a closed mesh, 1 inside the rim of
/// a sheet, however the sheet is folded; a sample covered twice or missed would differ.
///
/// @param width, height  of the picture in samples, as the pieces were made for
std::vector<FillCount> count_fills(const std::vector<Piece>& pieces, int width, int height);

}  // namespace repousse::host
