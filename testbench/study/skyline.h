#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "testbench/host/map/height_map.h"
#include "testbench/host/view/camera.h"
#include "testbench/host/view/picture.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::study {

/// A surface's upper silhouette: for each column of pixels how high it reaches anywhere in the
/// column, in pixels above the picture's bottom border; 0 where nothing is. Exact: the highest
/// point of any triangle's edge there, so that no summit is lost between the columns' middles. The
/// surface lies in front of the near plane.
std::vector<double> skyline(const host::RenderMesh& surface, const host::ViewProjection& view,
                            const host::Viewport& viewport);

/// A peak: a place where something is higher than all within `reach` around it.
struct Peak {
    int x = 0;
    int y = 0;  ///< 0 on a skyline
    double height = 0.0;
};

/// The `most` highest peaks of a curve over its columns, heights above `ground`.
std::vector<Peak> peaks_of(const std::vector<double>& curve, const std::vector<double>& ground,
                           int reach, std::size_t most);

/// The `most` highest peaks of a map, in texels and height LSB.
std::vector<Peak> peaks_of(const host::HeightMap& map, int reach, std::size_t most);

/// What part of its peaks' heights something keeps: 1 is all.
struct PeaksKept {
    double mean = 0.0;
    double least = 0.0;
    double most = 0.0;
    double lost = 0.0;  ///< mean of what is missing; higher than it was counts as nothing missing
};

/// Of a skyline's peaks; a peak may move by `reach` columns. Heights are above the ground at the
/// peak's own column.
PeaksKept kept(const std::vector<Peak>& peaks, const std::vector<double>& curve,
               const std::vector<double>& ground, int reach);

/// Of a map's peaks: the highest vertex of the displaced plane z = 0 within `reach` texels of each,
/// in x and y. Heights are those of the map, above its h = 0.
///
/// @param texel  world size of a texel; the first one's centre is at the origin
PeaksKept kept(const std::vector<Peak>& peaks, const host::RenderMesh& surface, glm::dvec2 texel,
               const host::HeightMap& map, int reach);

/// Draws a skyline into a picture of its view, two pixels thick, in a colour of linear light.
void draw_skyline(host::Picture& picture, const std::vector<double>& curve,
                  const glm::dvec3& colour);

}  // namespace repousse::study
