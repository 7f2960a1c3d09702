#include "testbench/study/skyline.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace repousse::study {
namespace {

/// The highest of a curve's columns around one.
double highest(const std::vector<double>& curve, int column, int reach) {
    const auto first = curve.begin() + std::max(0, column - reach);
    const auto last = curve.begin() + std::min(column + reach + 1, static_cast<int>(curve.size()));
    return *std::max_element(first, last);
}

std::vector<Peak> highest_of(std::vector<Peak> peaks, std::size_t most) {
    // Stable, so that equal heights stay in the order of their places.
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const Peak& a, const Peak& b) { return a.height > b.height; });
    if (peaks.size() > most) peaks.resize(most);
    return peaks;
}

double highest_vertex(const host::RenderMesh& surface, double x, double y, glm::dvec2 within,
                      double z_low) {
    double most = 0.0;
    for (const glm::dvec3& p : surface.positions) {
        if (std::fabs(p.x - x) > within.x || std::fabs(p.y - y) > within.y) continue;
        most = std::max(most, p.z - z_low);
    }
    return most;
}

PeaksKept summary(const std::vector<double>& parts) {
    PeaksKept kept;
    if (parts.empty()) return kept;
    const double share = 1.0 / static_cast<double>(parts.size());
    for (const double part : parts) {
        kept.mean += part * share;
        kept.lost += std::max(0.0, 1.0 - part) * share;
    }
    const auto [least, most] = std::minmax_element(parts.begin(), parts.end());
    kept.least = *least;
    kept.most = *most;
    return kept;
}

}  // namespace

std::vector<double> skyline(const host::RenderMesh& surface, const host::ViewProjection& view,
                            const host::Viewport& viewport) {
    std::vector<host::ScreenPoint> points;
    points.reserve(surface.positions.size());
    for (const glm::dvec3& p : surface.positions) points.push_back(view.project(p));
    std::vector<double> curve(static_cast<std::size_t>(viewport.width_px), 0.0);
    const auto column = [&curve](double x) {
        return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(curve.size())));
    };
    for (const auto& t : surface.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const host::ScreenPoint* p = &points[t[k]];
            const host::ScreenPoint* q = &points[t[(k + 1) % 3]];
            if (p->x > q->x) std::swap(p, q);
            const double slope = q->x > p->x ? (q->y - p->y) / (q->x - p->x) : 0.0;
            const auto row = [&](double x) {
                return x >= q->x ? q->y : p->y + std::max(0.0, x - p->x) * slope;
            };
            const std::size_t end = column(std::floor(q->x) + 1.0);
            for (std::size_t x = column(std::floor(p->x)); x < end; ++x) {
                // A straight edge is highest at one of its two ends within the column.
                const auto left = static_cast<double>(x);
                const double top = std::min(row(left), row(left + 1.0));
                curve[x] = std::max(curve[x], viewport.height_px - top);
            }
        }
    }
    return curve;
}

std::vector<Peak> peaks_of(const std::vector<double>& curve, const std::vector<double>& ground,
                           int reach, std::size_t most) {
    std::vector<double> heights(curve.size());
    std::transform(curve.begin(), curve.end(), ground.begin(), heights.begin(), std::minus<>());
    std::vector<Peak> peaks;
    for (int x = 0; x < static_cast<int>(heights.size()); ++x) {
        const auto at = heights.begin() + x;
        const auto first = heights.begin() + std::max(0, x - reach);
        const auto last =
            heights.begin() + std::min(x + reach + 1, static_cast<int>(heights.size()));
        // Of equal ones the first counts.
        const bool is_peak = *at > 0.0 &&
                             std::all_of(first, at, [&](double h) { return h < *at; }) &&
                             std::all_of(at, last, [&](double h) { return h <= *at; });
        if (is_peak) peaks.push_back({x, 0, *at});
    }
    return highest_of(std::move(peaks), most);
}

std::vector<Peak> peaks_of(const host::HeightMap& map, int reach, std::size_t most) {
    std::vector<Peak> peaks;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const int top = map.at(x, y);
            bool is_peak = top > 0;
            for (int b = std::max(0, y - reach);
                 is_peak && b <= std::min(map.height - 1, y + reach); ++b) {
                for (int a = std::max(0, x - reach); a <= std::min(map.width - 1, x + reach); ++a) {
                    // Of equal ones the first counts.
                    const bool earlier = b < y || (b == y && a < x);
                    is_peak = is_peak && (map.at(a, b) < top || (map.at(a, b) == top && !earlier));
                }
            }
            if (is_peak) peaks.push_back({x, y, static_cast<double>(top)});
        }
    }
    return highest_of(std::move(peaks), most);
}

PeaksKept kept(const std::vector<Peak>& peaks, const std::vector<double>& curve,
               const std::vector<double>& ground, int reach) {
    std::vector<double> parts;
    for (const Peak& peak : peaks) {
        const double above =
            highest(curve, peak.x, reach) - ground[static_cast<std::size_t>(peak.x)];
        parts.push_back(above / peak.height);
    }
    return summary(parts);
}

PeaksKept kept(const std::vector<Peak>& peaks, const host::RenderMesh& surface, glm::dvec2 texel,
               const host::HeightMap& map, int reach) {
    const glm::dvec2 within = texel * static_cast<double>(reach);
    std::vector<double> parts;
    for (const Peak& peak : peaks) {
        const double most =
            highest_vertex(surface, peak.x * texel.x, peak.y * texel.y, within, map.range_low);
        parts.push_back(most / (peak.height * map.world_per_lsb()));
    }
    return summary(parts);
}

void draw_skyline(host::Picture& picture, const std::vector<double>& curve,
                  const glm::dvec3& colour) {
    double before = curve.front();
    for (int x = 0; x < picture.width; ++x) {
        // From where the line was to where it is, so that it has no gaps where it is steep.
        const double here = curve[static_cast<std::size_t>(x)];
        if (before <= 0.0 || here <= 0.0) {  // beside the surface
            before = here;
            continue;
        }
        const double top = picture.height - std::max(before, here) - 1.0;
        const double bottom = picture.height - std::min(before, here) + 1.0;
        for (int y = std::max(0, static_cast<int>(top));
             y < std::min(picture.height, static_cast<int>(bottom) + 1); ++y) {
            for (int k = 0; k < 3; ++k) picture.pixel(x, y)[k] = static_cast<float>(colour[k]);
        }
        before = here;
    }
}

}  // namespace repousse::study
