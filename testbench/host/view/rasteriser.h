#pragma once

#include <algorithm>
#include <cstdint>

namespace repousse::host {

/// Fraction bits of a screen position. All triangles at a vertex see the same snapped position.
constexpr int kSubpixelBits = 8;
constexpr std::int64_t kSubpixels = std::int64_t{1} << kSubpixelBits;

/// A vertex on the screen, in 1/256 pixel. |x|, |y| < 2^28, so that edge functions stay below 2^59.
struct SnappedVertex {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// Screen barycentrics of a pixel's centre: weights of the three vertices, adding up to 1.
struct Weights {
    double a = 0.0;
    double b = 0.0;
    double c = 0.0;
};

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct PixelBox {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// One edge as a function that is positive on the inner side: e(x, y) = a * x + b * y + c at pixel
/// centres, in integers, with the fill rule folded into c.
struct EdgeFunction {
    std::int64_t step_x = 0;
    std::int64_t step_y = 0;
    std::int64_t at_start = 0;
    std::int64_t bias = 0;  // 0 on a top or left edge, else -1: a centre on it is outside

    /// Edge p -> q of a triangle that is clockwise on a screen whose y runs down, evaluated at the
    /// centre of pixel (x, y).
    EdgeFunction(const SnappedVertex& p, const SnappedVertex& q, int x, int y) {
        const std::int64_t dx = q.x - p.x;
        const std::int64_t dy = q.y - p.y;
        const std::int64_t cx = x * kSubpixels + kSubpixels / 2;
        const std::int64_t cy = y * kSubpixels + kSubpixels / 2;
        at_start = dx * (cy - p.y) - dy * (cx - p.x);
        step_x = -dy * kSubpixels;
        step_y = dx * kSubpixels;
        // With the inside to the right of p -> q, a left edge goes up and a top edge goes right.
        const bool top_left = dy < 0 || (dy == 0 && dx > 0);
        bias = top_left ? 0 : -1;
    }
};

/// Twice the area of a triangle, positive if it is clockwise on a screen whose y runs down.
inline std::int64_t doubled_area(const SnappedVertex& a, const SnappedVertex& b,
                                 const SnappedVertex& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Visits every pixel of `box` whose centre is inside the triangle (a, b, c), of either
/// orientation: visit(x, y, weights). Centres on an edge belong to the triangle of which it is a
/// top or left edge, so triangles that share an edge cover each centre once and leave none out.
template <class Visit>
void rasterise(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& c,
               const PixelBox& box, Visit&& visit) {
    const std::int64_t area = doubled_area(a, b, c);
    if (area == 0) return;
    const bool flipped = area < 0;
    const SnappedVertex& p = flipped ? c : b;
    const SnappedVertex& q = flipped ? b : c;
    const std::int64_t low_x = std::min({a.x, b.x, c.x}) >> kSubpixelBits;
    const std::int64_t high_x = std::max({a.x, b.x, c.x}) >> kSubpixelBits;
    const std::int64_t low_y = std::min({a.y, b.y, c.y}) >> kSubpixelBits;
    const std::int64_t high_y = std::max({a.y, b.y, c.y}) >> kSubpixelBits;
    const int x0 = static_cast<int>(std::max<std::int64_t>(low_x, box.x0));
    const int y0 = static_cast<int>(std::max<std::int64_t>(low_y, box.y0));
    const int x1 = static_cast<int>(std::min<std::int64_t>(high_x + 1, box.x1));
    const int y1 = static_cast<int>(std::min<std::int64_t>(high_y + 1, box.y1));
    if (x0 >= x1 || y0 >= y1) return;

    // Opposite to a, p and q; with y down, a positive area is clockwise to the eye.
    EdgeFunction at_a(p, q, x0, y0);
    EdgeFunction at_p(q, a, x0, y0);
    EdgeFunction at_q(a, p, x0, y0);
    const double scale = 1.0 / static_cast<double>(flipped ? -area : area);
    for (int y = y0; y < y1; ++y) {
        std::int64_t ea = at_a.at_start;
        std::int64_t ep = at_p.at_start;
        std::int64_t eq = at_q.at_start;
        for (int x = x0; x < x1; ++x) {
            if (((ea + at_a.bias) | (ep + at_p.bias) | (eq + at_q.bias)) >= 0) {
                const double wa = static_cast<double>(ea) * scale;
                const double wp = static_cast<double>(ep) * scale;
                const double wq = static_cast<double>(eq) * scale;
                visit(x, y, flipped ? Weights{wa, wq, wp} : Weights{wa, wp, wq});
            }
            ea += at_a.step_x;
            ep += at_p.step_x;
            eq += at_q.step_x;
        }
        at_a.at_start += at_a.step_y;
        at_p.at_start += at_p.step_y;
        at_q.at_start += at_q.step_y;
    }
}

}  // namespace repousse::host
