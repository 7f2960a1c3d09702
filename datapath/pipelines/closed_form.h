#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "datapath/sweep_items.h"

namespace repousse {

/// Vertex data times c.
template <class V>
using SweepData = std::array<V, kSweepComponents>;

/// Steps of the edge between two corners: the largest difference of their slots, at least 1.
inline int32_t edge_steps(const SweepTriangle& triangle, std::size_t from, std::size_t to) {
    int32_t steps = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int32_t d = triangle.corners[to].slot[axis] - triangle.corners[from].slot[axis];
        steps = d > steps ? d : -d > steps ? -d : steps;
    }
    return steps;
}

/// A vertex's data from its name and the three corners' data, without accumulation: what level
/// `ref` has in place of adders. `triangle` gives slots, ids and remeshing plane.
///
/// The point of an edge is a mean of its ends in the order of their ids: the same bits from both
/// sides. Inside, weights are ratios of integers; the determinant is not 0, or nothing would lie
/// there. Differences have 14 bits, determinants 28.
template <class V>
SweepData<V> closed_form(const SweepTriangle& triangle, const VertexName& name,
                         const SweepData<V>& data0, const SweepData<V>& data1,
                         const SweepData<V>& data2) {
    const std::array<const SweepData<V>*, 3> data = {&data0, &data1, &data2};
    if (name.kind == NameKind::Corner) return *data[name.part];
    SweepData<V> out;
    if (name.kind == NameKind::Edge) {
        std::size_t from = name.part, to = (from + 1) % 3;
        const int32_t steps = edge_steps(triangle, from, to);
        if (triangle.corners[to].id < triangle.corners[from].id) std::swap(from, to);
        const SweepData<V>&low = *data[from], &high = *data[to];
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = (low[i] * V(steps - name.a) + high[i] * V(name.a)) / V(steps);
        }
        return out;
    }
    const std::size_t sweep = triangle.sweep_axis, side = triangle.side_axis;
    const auto& [c0, c1, c2] = triangle.corners;
    const auto cross = [](int32_t s1, int32_t y1, int32_t s2, int32_t y2) {
        return V(s1 * y2 - y1 * s2);
    };
    const int32_t s1 = c1.slot[sweep] - c0.slot[sweep], y1 = c1.slot[side] - c0.slot[side];
    const int32_t s2 = c2.slot[sweep] - c0.slot[sweep], y2 = c2.slot[side] - c0.slot[side];
    const int32_t s = name.a - c0.slot[sweep], y = name.b - c0.slot[side];
    const V area = cross(s1, y1, s2, y2), w1 = cross(s, y, s2, y2), w2 = cross(s1, y1, s, y);
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = (data0[i] * (area - w1 - w2) + data1[i] * w1 + data2[i] * w2) / area;
    }
    return out;
}

/// Half steps of texture coordinates and c, likewise: what level `ref` has in place of quotients.
/// Which way round a step inside is counted does not matter to a footprint.
template <class V>
TexelSteps<V> closed_form_steps(const SweepTriangle& triangle, const SweepData<V>& data0,
                                const SweepData<V>& data1, const SweepData<V>& data2) {
    constexpr std::size_t kTexture = 6;
    const std::array<const SweepData<V>*, 3> data = {&data0, &data1, &data2};
    const auto difference = [&data](std::size_t from, std::size_t to) -> TexelStep<V> {
        const SweepData<V>&a = *data[from], &b = *data[to];
        return {b[kTexture] - a[kTexture], b[kTexture + 1] - a[kTexture + 1],
                b[kInverseWComponent] - a[kInverseWComponent]};
    };
    const auto half = [](const TexelStep<V>& p, V weight_p, const TexelStep<V>& q, V weight_q,
                         V divisor) -> TexelStep<V> {
        const V d = 2 * divisor;
        return {(p.u * weight_p - q.u * weight_q) / d, (p.v * weight_p - q.v * weight_q) / d,
                (p.c * weight_p - q.c * weight_q) / d};
    };
    TexelSteps<V> steps;
    for (std::size_t e = 0; e < 3; ++e) {
        std::size_t from = e, to = (e + 1) % 3;
        if (triangle.corners[to].id < triangle.corners[from].id) std::swap(from, to);
        const V n(edge_steps(triangle, from, to));
        steps.edges[e] = half(difference(from, to), V(1), {}, V(0), n);
    }
    const std::size_t sweep = triangle.sweep_axis, side = triangle.side_axis;
    const auto& [c0, c1, c2] = triangle.corners;
    const int32_t s1 = c1.slot[sweep] - c0.slot[sweep], y1 = c1.slot[side] - c0.slot[side];
    const int32_t s2 = c2.slot[sweep] - c0.slot[sweep], y2 = c2.slot[side] - c0.slot[side];
    if (s1 * y2 == s2 * y1) return steps;
    const V area(s1 * y2 - s2 * y1);
    const TexelStep<V> to1 = difference(0, 1), to2 = difference(0, 2);
    steps.sweep = half(to1, V(y2), to2, V(y1), area);
    steps.side = half(to2, V(s1), to1, V(s2), area);
    return steps;
}

}  // namespace repousse
