#include "datapath/units/perspective.h"

namespace repousse {
namespace {

/// Components of vertex data, in their order.
enum Component : std::size_t { X, Nx = 3, U = 6, C = kInverseWComponent, Tx = 9, Handedness = 12 };

}  // namespace

template <class P>
Perspective<P>::Perspective(const Profile& profile)
    : uv_frac_(profile.uv.frac),
      has_tangents_(profile.components > kPlainComponents),
      reciprocal_(profile.reciprocal_index_bits, profile.reciprocal_newton_steps,
                  profile.reciprocal_bits),
      to_position_(profile.sweep_data.frac, profile.inverse_w.frac, profile.position),
      to_unnormalised_(profile.sweep_data.frac, profile.inverse_w.frac, profile.unnormalised),
      to_uv_(profile.sweep_data.frac, profile.inverse_w.frac, profile.uv),
      normalise_(profile) {}

template <class P>
CorrectedVertex<P> Perspective<P>::correct(const Data& data) {
    ++counters_.items;
    CorrectedVertex<P> out;
    out.clamped = data[C] <= 0;
    counters_.clamped += out.clamped;
    // One raw unit; with Real, where no rounding can bring c to zero, any positive number.
    const auto r = P::invert(reciprocal_, out.clamped ? V{1} : data[C]);

    const auto divided = [&](const typename P::Quotient& to, std::size_t component) {
        return to(data[component], r, counters_.overflows);
    };
    const auto vector = [&](const typename P::Quotient& to, std::size_t first) -> Vec3<V> {
        return {divided(to, first), divided(to, first + 1), divided(to, first + 2)};
    };
    out.position = vector(to_position_, X);
    out.normal = vector(to_unnormalised_, Nx);
    out.uv = {P::raw(divided(to_uv_, U), uv_frac_), P::raw(divided(to_uv_, U + 1), uv_frac_)};
    if (tangents_) {
        out.tangent = vector(to_unnormalised_, Tx);
        out.left_handed = data[Handedness] < 0;
    }
    return out;
}

template <class P>
void Perspective<P>::operator()(const Data& data, const VertexName& name, FineVertex<P>& out) {
    const CorrectedVertex<P> corrected = correct(data);
    out.name = name;
    out.uv = corrected.uv;
    out.position = corrected.position;
    out.normal = normalise_(corrected.normal);
    if (tangents_) out.tangent = normalise_(corrected.tangent);
    out.handedness = corrected.left_handed ? -1 : 1;
}

// ---- batches ------------------------------------------------------------------------------------

template <class P>
void Perspective<P>::run(FineVertices<P>& b) {
    const std::size_t n = b.size;
    counters_.items += n;
    FineArray<V> c;
    for (std::size_t i = 0; i < n; ++i) {
        const bool clamped = b.data[C][i] <= 0;
        counters_.clamped += clamped;
        c[i] = clamped ? V{1} : b.data[C][i];
    }
    typename P::Inverses inverses;
    P::invert(reciprocal_, c.data(), n, inverses);

    const auto divide = [&](const typename P::Quotient& to, std::size_t first, auto... results) {
        const V* from[sizeof...(results)];
        for (std::size_t k = 0; k < sizeof...(results); ++k) from[k] = b.data[first + k].data();
        V* const all[] = {results->data()...};
        to(from, all, sizeof...(results), inverses, n, counters_.overflows);
    };
    FineVectors<V>& raw = unnormalised_;
    divide(to_position_, X, &b.position.x, &b.position.y, &b.position.z);
    divide(to_unnormalised_, Nx, &raw.x, &raw.y, &raw.z);
    normalise_(columns<P>(raw, b.normal), n);
    FineArray<V> u, v;
    divide(to_uv_, U, &u, &v);
    for (std::size_t i = 0; i < n; ++i) {
        b.u[i] = P::raw(u[i], uv_frac_);
        b.v[i] = P::raw(v[i], uv_frac_);
    }
    if (tangents_) {
        divide(to_unnormalised_, Tx, &raw.x, &raw.y, &raw.z);
        normalise_(columns<P>(raw, b.tangent), n);
    }
    for (std::size_t i = 0; i < n; ++i) {
        b.handedness[i] = tangents_ && b.data[Handedness][i] < 0 ? -1 : 1;
    }
}

template class Perspective<Fixed>;
template class Perspective<Real>;

}  // namespace repousse
