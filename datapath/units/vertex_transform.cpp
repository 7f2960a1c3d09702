#include "datapath/units/vertex_transform.h"

namespace repousse {

template <class P>
VertexTransform<P>::VertexTransform(const Profile& profile)
    : ndc_frac_(profile.ndc.frac),
      to_clip_(profile.position.frac + profile.view_row.frac, profile.clip),
      to_screen_(profile.ndc.frac + profile.focal.frac, profile.screen),
      reciprocal_(profile.reciprocal_index_bits, profile.reciprocal_newton_steps,
                  profile.reciprocal_bits),
      divide_(reciprocal_, profile.ndc) {}

// 33-bit differences times 24-bit rows, three of them: 59 bits.
template <class P>
typename P::Value VertexTransform<P>::clip_coordinate(const Vec3<V>& row,
                                                      const Vec3<typename P::Wide>& e) {
    return P::quantize(to_clip_, P::mul(row.x, e.x) + P::mul(row.y, e.y) + P::mul(row.z, e.z),
                       counters_.overflows);
}

template <class P>
EyePoint<P> VertexTransform<P>::eye(const Vec3<V>& position) {
    using Wide = typename P::Wide;
    ++counters_.items;
    const Vec3<Wide> e{Wide(position.x) - view_.eye.x, Wide(position.y) - view_.eye.y,
                       Wide(position.z) - view_.eye.z};
    return {clip_coordinate(view_.right, e), clip_coordinate(view_.up, e),
            clip_coordinate(view_.forward, e)};
}

template <class P>
ScreenPoint<typename P::Value> VertexTransform<P>::operator()(const Vec3<V>& displaced) {
    const EyePoint<P> e = eye(displaced);
    if (e.w <= view_.near) {
        ++counters_.behind;
        return {V{}, V{}, true};
    }
    const auto ndc = divide_(e.x, e.y, e.w, counters_.overflows);
    const auto pixel = [&](V ratio, V focal, V centre) {
        return P::quantize(to_screen_, P::mul(ratio, focal) + P::align(centre, ndc_frac_),
                           counters_.overflows);
    };
    return {pixel(ndc[0], view_.focal_x, view_.centre_x),
            pixel(ndc[1], view_.focal_y, view_.centre_y), false};
}

template <class P>
void VertexTransform<P>::run(Span<Edge<P>> edges) {
    for (Edge<P>& edge : edges) {
        if (edge.split) edge.mid.screen = (*this)(edge.mid.displaced);
    }
}

template class VertexTransform<Fixed>;
template class VertexTransform<Real>;

}  // namespace repousse
