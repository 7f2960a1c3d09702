#include "testbench/host/view/clip.h"

#include <cmath>

namespace repousse::host {
namespace {

constexpr double kGuardBand = 16.0;

double dot4(const std::array<double, 4>& row, const glm::dvec3& p) {
    return row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
}

/// Signed distance of a vertex from clip plane `plane`; positive is inside.
double distance(const ViewProjection& view, const ClipVertex& v, int plane) {
    switch (plane) {
        case 0:
            return v.w - view.near;
        case 1:
            return view.far - v.w;
        case 2:
            return kGuardBand * v.w - v.x;
        case 3:
            return kGuardBand * v.w + v.x;
        case 4:
            return kGuardBand * v.w - v.y;
        default:
            return kGuardBand * v.w + v.y;
    }
}

ClipVertex between(const ClipVertex& in, const ClipVertex& out, double d_in, double d_out) {
    const double t = d_in / (d_in - d_out);
    return {in.x + t * (out.x - in.x), in.y + t * (out.y - in.y), in.w + t * (out.w - in.w),
            in.corner_weights + t * (out.corner_weights - in.corner_weights)};
}

/// Sutherland and Hodgman's step for one plane.
ClipPolygon clip_plane(const ViewProjection& view, const ClipPolygon& polygon, int plane) {
    ClipPolygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const auto next = static_cast<std::size_t>((i + 1) % polygon.count);
        const ClipVertex& p = polygon.corners[static_cast<std::size_t>(i)];
        const ClipVertex& q = polygon.corners[next];
        const double dp = distance(view, p, plane);
        const double dq = distance(view, q, plane);
        auto add = [&result](const ClipVertex& v) {
            result.corners[static_cast<std::size_t>(result.count++)] = v;
        };
        if (dp >= 0.0) add(p);
        if (dp >= 0.0 && dq < 0.0) add(between(p, q, dp, dq));
        if (dp < 0.0 && dq >= 0.0) add(between(q, p, dq, dp));
    }
    return result;
}

}  // namespace

ClipVertex clip_vertex(const ViewProjection& view, const glm::dvec3& position) {
    return {dot4(view.x_row, position), dot4(view.y_row, position), dot4(view.w_row, position),
            glm::dvec3(0.0)};
}

ClipPolygon clip_triangle(const ViewProjection& view, const ClipVertex& a, const ClipVertex& b,
                          const ClipVertex& c) {
    ClipPolygon polygon;
    polygon.corners[0] = a;
    polygon.corners[1] = b;
    polygon.corners[2] = c;
    polygon.count = 3;
    polygon.corners[0].corner_weights = {1.0, 0.0, 0.0};
    polygon.corners[1].corner_weights = {0.0, 1.0, 0.0};
    polygon.corners[2].corner_weights = {0.0, 0.0, 1.0};
    for (int plane = 0; plane < 6 && polygon.count > 0; ++plane) {
        bool inside = true;
        for (int i = 0; i < polygon.count; ++i) {
            inside = inside &&
                     distance(view, polygon.corners[static_cast<std::size_t>(i)], plane) >= 0.0;
        }
        if (!inside) polygon = clip_plane(view, polygon, plane);
    }
    return polygon;
}

SnappedVertex snap(const ViewProjection& view, const ClipVertex& v, int samples) {
    const double scale = static_cast<double>(samples) * static_cast<double>(kSubpixels);
    const double x = view.centre_x + view.scale_x * v.x / v.w;
    const double y = view.centre_y + view.scale_y * v.y / v.w;
    return {static_cast<std::int64_t>(std::floor(x * scale + 0.5)),
            static_cast<std::int64_t>(std::floor(y * scale + 0.5))};
}

}  // namespace repousse::host
