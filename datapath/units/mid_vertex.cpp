#include "datapath/units/mid_vertex.h"

#include <algorithm>

namespace repousse {

template <class P>
MidVertex<P>::MidVertex(const Profile& profile)
    : align_sum_(std::max(0, profile.unnormalised.frac - profile.normal.frac)),
      to_unnormalised_(profile.normal.frac + align_sum_, profile.unnormalised),
      normalise_(profile, profile.normal) {}

template <class P>
void MidVertex<P>::topology(const Vertex<P>& v1, const Vertex<P>& v2, Vertex<P>& mid) {
    ++counters_.items;
    // One bit more than uv for the sum; the arithmetic shift floors, whatever the order.
    mid.uv.x = static_cast<int32_t>((int64_t(v1.uv.x) + v2.uv.x) >> 1);
    mid.uv.y = static_cast<int32_t>((int64_t(v1.uv.y) + v2.uv.y) >> 1);
    mid.generation = static_cast<uint8_t>(std::max(v1.generation, v2.generation) + 1);
    // Both ends agree on every mesh the host lets through; the minimum keeps the result symmetric.
    mid.handedness = std::min(v1.handedness, v2.handedness);
}

template <class P>
Vec3<typename P::Value> MidVertex<P>::mean_direction(const Vec3<V>& a, const Vec3<V>& b) {
    const auto sum = [&](V x, V y) {
        return P::quantize(to_unnormalised_, P::align(typename P::Wide(x) + y, align_sum_),
                           counters_.overflows);
    };
    return normalise_({sum(a.x, b.x), sum(a.y, b.y), sum(a.z, b.z)}, counters_.degenerate);
}

template <class P>
void MidVertex<P>::attributes(const Vertex<P>& v1, const Vertex<P>& v2, Vertex<P>& mid) {
    ++counters_.attributes;
    const auto half = [](V a, V b) { return static_cast<V>(P::half(typename P::Wide(a) + b)); };
    mid.position = {half(v1.position.x, v2.position.x), half(v1.position.y, v2.position.y),
                    half(v1.position.z, v2.position.z)};
    mid.normal = mean_direction(v1.normal, v2.normal);
    mid.tangent = mean_direction(v1.tangent, v2.tangent);
}

template <class P>
MidVertexEnd MidVertex<P>::operator()(const MidVertexIn& in) {
    const auto vector = [](const Vec3<int32_t>& v) {
        return Vec3<V>{static_cast<V>(v.x), static_cast<V>(v.y), static_cast<V>(v.z)};
    };
    const auto words = [](const Vec3<V>& v) {
        return Vec3<int32_t>{static_cast<int32_t>(v.x), static_cast<int32_t>(v.y),
                             static_cast<int32_t>(v.z)};
    };
    std::array<Vertex<P>, 2> ends;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const MidVertexEnd& end = in.ends[i];
        ends[i].uv = end.u;
        ends[i].generation = end.generation;
        ends[i].position = vector(end.p);
        ends[i].normal = vector(end.n);
        ends[i].tangent = vector(end.t);
        ends[i].handedness = end.left ? -1 : 1;
    }
    Vertex<P> mid;
    topology(ends[0], ends[1], mid);
    attributes(ends[0], ends[1], mid);
    return {mid.uv,
            mid.generation,
            words(mid.position),
            words(mid.normal),
            words(mid.tangent),
            mid.handedness < 0};
}

template <class P>
void MidVertex<P>::run_topology(Span<Edge<P>> edges) {
    for (Edge<P>& edge : edges) topology(*edge.v1, *edge.v2, edge.mid);
}

template <class P>
void MidVertex<P>::run_attributes(Span<Edge<P>> edges, bool for_test, bool eager) {
    for (Edge<P>& edge : edges) {
        if (edge.wants_attributes(for_test, eager)) attributes(*edge.v1, *edge.v2, edge.mid);
    }
}

template class MidVertex<Fixed>;
template class MidVertex<Real>;

}  // namespace repousse
