#include "datapath/units/bump.h"

namespace repousse {

template <class P>
Bump<P>::Bump(const Profile& profile)
    : uv_frac_(profile.uv.frac),
      to_normal_(2 * profile.normal.frac, profile.normal),
      to_unnormalised_(profile.normal.frac + profile.map_normal.frac, profile.unnormalised),
      normalise_(profile, profile.displaced_normal) {}

template <class P>
void Bump<P>::configure(const MapView<P>& map) {
    map_ = map;
}

template <class P>
Vec3<typename P::Value> Bump<P>::read(Uv u) {
    ++counters_.reads;
    const int x = texel_address(u.x >> uv_frac_, map_.width, map_.wrap);
    const int y = texel_address(u.y >> uv_frac_, map_.height, map_.wrap);
    const auto& stored =
        map_.normals[static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
                     static_cast<std::size_t>(x)];
    return {V(stored.x), V(stored.y), V(stored.z)};
}

// Components of unit vectors: products of 16 bits each, their difference 33.
template <class P>
template <class AnyVertex>
Vec3<typename P::Value> Bump<P>::bitangent(const AnyVertex& vertex) {
    const Vec3<V>& n = vertex.normal;
    const Vec3<V>& t = vertex.tangent;
    const auto cross = [&](V a, V b, V c, V d) {
        const typename P::Wide difference = P::mul(a, b) - P::mul(c, d);
        return P::quantize(to_normal_, vertex.handedness < 0 ? -difference : difference,
                           counters_.overflows);
    };
    return {cross(n.y, t.z, n.z, t.y), cross(n.z, t.x, n.x, t.z), cross(n.x, t.y, n.y, t.x)};
}

template <class P>
template <class AnyVertex>
Vec3<typename P::Value> Bump<P>::rotate(const AnyVertex& vertex, const Vec3<V>& d) {
    const Vec3<V>& t = vertex.tangent;
    const Vec3<V>& n = vertex.normal;
    const Vec3<V> b = bitangent(vertex);
    // Three products of 16 and 13 bits: 31 bits.
    const auto rotated = [&](V tc, V bc, V nc) {
        return P::quantize(to_unnormalised_, P::mul(tc, d.x) + P::mul(bc, d.y) + P::mul(nc, d.z),
                           counters_.overflows);
    };
    return normalise_({rotated(t.x, b.x, n.x), rotated(t.y, b.y, n.y), rotated(t.z, b.z, n.z)},
                      counters_.degenerate);
}

template <class P>
void Bump<P>::operator()(Vertex<P>& vertex) {
    ++counters_.items;
    vertex.map_normal = read(vertex.uv);
    vertex.displaced_normal = rotate(vertex, vertex.map_normal);
}

template <class P>
void Bump<P>::operator()(FineVertex<P>& vertex) {
    ++counters_.items;
    vertex.displaced_normal = rotate(vertex, read(vertex.uv));
}

template <class P>
void Bump<P>::run(Span<Edge<P>> edges, bool for_test, bool eager) {
    for (Edge<P>& edge : edges) {
        if (edge.wants_attributes(for_test, eager)) (*this)(edge.mid);
    }
}

template class Bump<Fixed>;
template class Bump<Real>;

}  // namespace repousse
