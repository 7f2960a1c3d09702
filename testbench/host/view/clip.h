#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "testbench/host/view/camera.h"
#include "testbench/host/view/rasteriser.h"

namespace repousse::host {

/// A vertex before projection, with its weights of the three corners of the triangle it came from.
struct ClipVertex {
    double x = 0.0;
    double y = 0.0;
    double w = 0.0;
    glm::dvec3 corner_weights{0.0};
};

/// Clip-space position of a point.
ClipVertex clip_vertex(const ViewProjection& view, const glm::dvec3& position);

/// A convex polygon that a triangle leaves after clipping: at most 3 + 6 corners.
struct ClipPolygon {
    std::array<ClipVertex, 9> corners;
    int count = 0;
};

/// Clips a triangle against near and far and a guard band of 16 pictures (beyond which snapped
/// coordinates would leave their range). Two triangles that share an edge get bit-identical
/// intersections on it, because each is computed from its inner to its outer end.
ClipPolygon clip_triangle(const ViewProjection& view, const ClipVertex& a, const ClipVertex& b,
                          const ClipVertex& c);

/// Snapped screen position, on a picture whose pixels are split into samples x samples.
SnappedVertex snap(const ViewProjection& view, const ClipVertex& vertex, int samples);

}  // namespace repousse::host
