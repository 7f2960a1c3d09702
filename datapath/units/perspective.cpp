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

template class Perspective<Fixed>;
template class Perspective<Real>;

}  // namespace repousse
