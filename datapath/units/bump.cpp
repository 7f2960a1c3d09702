#include "datapath/units/bump.h"

namespace repousse {
namespace {

int fraction_of(BumpKind kind, const Profile& profile) {
    return kind == BumpKind::Slopes  ? profile.slope.frac
           : kind == BumpKind::Turns ? profile.normal.frac
                                     : profile.map_normal.frac;
}

// A component of handedness * (N x T) of unit vectors: products of 16 bits each, their difference
// 33.
template <class P, class V>
inline typename P::Wide bitangent_component(V a, V b, V c, V d, int handedness) {
    const typename P::Wide difference = P::mul(a, b) - P::mul(c, d);
    return handedness < 0 ? -difference : difference;
}

// Three products of 16 bits and those of D, 13 to 20: 38 bits.
template <class P, class V>
inline typename P::Wide rotated_component(V t, V b, V n, const Vec3<V>& d) {
    return P::mul(t, d.x) + P::mul(b, d.y) + P::mul(n, d.z);
}

}  // namespace

template <class P>
Bump<P>::Bump(const Profile& profile)
    : kind_(static_cast<BumpKind>(profile.bump_kind)),
      uv_frac_(profile.uv.frac),
      d_frac_(fraction_of(kind_, profile)),
      unnormalised_bits_(profile.unnormalised.width),
      one_(static_cast<V>(P::exact(int64_t{1} << d_frac_, d_frac_))),
      slope_(profile.slope),
      to_normal_(2 * profile.normal.frac, profile.normal),
      to_unnormalised_(profile.normal.frac + d_frac_, profile.unnormalised),
      product_to_normal_(2 * profile.normal.frac, profile.normal),
      normal_to_map_(profile.normal.frac, profile.map_normal),
      sin_cos_(profile.sine_index_bits, profile.angle.frac, profile.normal),
      normalise_(profile, profile.displaced_normal) {}

template <class P>
void Bump<P>::configure(const MapView<P>& map) {
    map_ = map;
    to_slope_u_ = Cast(map.slope_u.exponent, slope_);
    to_slope_v_ = Cast(map.slope_v.exponent, slope_);
}

template <class P>
template <class AnyVertex>
Vec3<typename P::Value> Bump<P>::rotate(const AnyVertex& vertex, Vec3<V> d) {
    const Vec3<V>& t = vertex.tangent;
    const Vec3<V>& n = vertex.normal;
    const auto cross = [&](V e, V f, V g, V h) {
        return P::quantize(to_normal_, bitangent_component<P>(e, f, g, h, vertex.handedness),
                           counters_.overflows);
    };
    const Vec3<V> b{cross(n.y, t.z, n.z, t.y), cross(n.z, t.x, n.x, t.z),
                    cross(n.x, t.y, n.y, t.x)};
    if (b == Vec3<V>{}) {
        ++counters_.degenerate_frames;
        d = {V{}, V{}, one_};
    }
    const Vec3<typename P::Wide> v{rotated_component<P>(t.x, b.x, n.x, d),
                                   rotated_component<P>(t.y, b.y, n.y, d),
                                   rotated_component<P>(t.z, b.z, n.z, d)};
    // Slopes make vectors of any length; of the others only those of odd frames are far from one.
    if (kind_ == BumpKind::Slopes) {
        return normalise_(P::scaled(v, unnormalised_bits_), counters_.degenerate);
    }
    const auto cast = [&](typename P::Wide component) {
        return P::quantize(to_unnormalised_, component, counters_.overflows);
    };
    return normalise_({cast(v.x), cast(v.y), cast(v.z)}, counters_.degenerate);
}

template <class P>
void Bump<P>::operator()(Vertex<P>& vertex) {
    ++counters_.items;
    const Vec3<V> d = map_vector(vertex.uv);
    const auto as_map_normal = [&](V component) {
        return P::quantize(normal_to_map_, component, counters_.overflows);
    };
    vertex.map_normal = kind_ == BumpKind::Normals ? d
                        : kind_ == BumpKind::Turns
                            ? Vec3<V>{as_map_normal(d.x), as_map_normal(d.y), as_map_normal(d.z)}
                            : Vec3<V>{};
    vertex.displaced_normal = rotate(vertex, d);
}

template <class P>
void Bump<P>::operator()(FineVertex<P>& vertex) {
    ++counters_.items;
    vertex.displaced_normal = rotate(vertex, map_vector(vertex.uv));
}

template <class P>
BumpOut Bump<P>::operator()(const BumpIn& in) {
    const auto vector = [](const Vec3<int32_t>& v) {
        return Vec3<V>{static_cast<V>(v.x), static_cast<V>(v.y), static_cast<V>(v.z)};
    };
    const auto words = [](const Vec3<V>& v) {
        return Vec3<int32_t>{static_cast<int32_t>(v.x), static_cast<int32_t>(v.y),
                             static_cast<int32_t>(v.z)};
    };
    Vertex<P> vertex;
    vertex.uv = in.u;
    vertex.normal = vector(in.n);
    vertex.tangent = vector(in.t);
    vertex.handedness = in.left ? -1 : 1;
    (*this)(vertex);
    return {words(vertex.map_normal), words(vertex.displaced_normal)};
}

template <class P>
void Bump<P>::run(Span<Edge<P>> edges, bool for_test, bool eager) {
    for (Edge<P>& edge : edges) {
        if (edge.wants_attributes(for_test, eager)) (*this)(edge.mid);
    }
}

// ---- batches of fine vertices -------------------------------------------------------------------

template <class P>
void Bump<P>::run(FineVertices<P>& b) {
    counters_.items += b.size;
    FineVectors<V> d, unnormalised;
    map_vectors(b, d);
    rotate(b, d, unnormalised);
    normalise_(columns<P>(unnormalised, b.displaced_normal), b.size, counters_.degenerate);
}

namespace {

/// What the rotation of a batch needs of the unit.
template <class P>
struct BatchCasts {
    const Cast& to_normal;
    const Cast& to_unnormalised;
    typename P::Value one;  // in the format of D
    int scaled_bits;        // of `unnormalised`, or 0: cast
};

template <class P>
inline void rotate_all(const FineVertices<P>& v, FineVectors<typename P::Value>& d,
                       const BatchCasts<P>& casts, BumpCounters& counters,
                       FineVectors<typename P::Value>& out) {
    using V = typename P::Value;
    using Array = FineArray<V>;
    const auto &n = v.normal, &t = v.tangent;
    const auto cross = [&](const Array& a, const Array& b, const Array& c, const Array& e,
                           Array& to) {
        P::quantize(casts.to_normal, v.size, to.data(), counters.overflows, [&](std::size_t i) {
            return bitangent_component<P>(a[i], b[i], c[i], e[i], v.handedness[i]);
        });
    };
    FineVectors<V> b;
    cross(n.y, t.z, n.z, t.y, b.x);
    cross(n.z, t.x, n.x, t.z, b.y);
    cross(n.x, t.y, n.y, t.x, b.z);
    for (std::size_t i = 0; i < v.size; ++i) {
        if (!(b[i] == Vec3<V>{})) continue;
        ++counters.degenerate_frames;
        d.set(i, {V{}, V{}, casts.one});
    }
    const auto rotated = [&](const Array& tc, const Array& bc, const Array& nc, std::size_t i) {
        return rotated_component<P>(tc[i], bc[i], nc[i], d[i]);
    };
    if (casts.scaled_bits != 0) {
        for (std::size_t i = 0; i < v.size; ++i) {
            out.set(i, P::scaled({rotated(t.x, b.x, n.x, i), rotated(t.y, b.y, n.y, i),
                                  rotated(t.z, b.z, n.z, i)},
                                 casts.scaled_bits));
        }
        return;
    }
    const auto component = [&](const Array& tc, const Array& bc, const Array& nc, Array& to) {
        P::quantize(casts.to_unnormalised, v.size, to.data(), counters.overflows,
                    [&](std::size_t i) { return rotated(tc, bc, nc, i); });
    };
    component(t.x, b.x, n.x, out.x);
    component(t.y, b.y, n.y, out.y);
    component(t.z, b.z, n.z, out.z);
}

}  // namespace

template <>
REPOUSSE_VECTOR_CLONES void Bump<Fixed>::rotate(const FineVertices<Fixed>& b, FineVectors<V>& d,
                                                FineVectors<V>& unnormalised) {
    const int bits = kind_ == BumpKind::Slopes ? unnormalised_bits_ : 0;
    rotate_all<Fixed>(b, d, {to_normal_, to_unnormalised_, one_, bits}, counters_, unnormalised);
}

template <>
void Bump<Real>::rotate(const FineVertices<Real>& b, FineVectors<V>& d,
                        FineVectors<V>& unnormalised) {
    const int bits = kind_ == BumpKind::Slopes ? unnormalised_bits_ : 0;
    rotate_all<Real>(b, d, {to_normal_, to_unnormalised_, one_, bits}, counters_, unnormalised);
}

template class Bump<Fixed>;
template class Bump<Real>;

}  // namespace repousse
