#include "datapath/units/displace.h"

namespace repousse {

template <class P>
Displace<P>::Displace(const Profile& profile)
    : uv_frac_(profile.uv.frac),
      filter_bits_(profile.filtered_height.frac - profile.height.frac),
      align_position_(profile.displacement.frac + profile.normal.frac - profile.position.frac),
      displacement_format_(profile.displacement),
      to_filtered_(profile.height.frac + 2 * profile.uv.frac, profile.filtered_height),
      add_bias_(profile.displacement.frac, profile.displacement),
      to_position_(profile.displacement.frac + profile.normal.frac, profile.position) {}

template <class P>
void Displace<P>::configure(const MapView<P>& map) {
    map_ = map;
    // Height LSB times mantissa times 2^-exponent is in world units.
    to_displacement_ = Cast(filter_bits_ + map.scale_exponent, displacement_format_);
}

template <class P>
int64_t Displace<P>::texel(int x, int y) const {
    const int column = texel_address(x, map_.width, map_.wrap);
    const int row = texel_address(y, map_.height, map_.wrap);
    return map_.heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(map_.width) +
                        static_cast<std::size_t>(column)];
}

// Texel centres lie at +1/2, so the cell is found half a texel lower. The weights have F bits
// each and sum to 2^F: 16 + 2 F <= 48 bits, exact.
template <class P>
typename P::Wide Displace<P>::bilinear(Uv u) {
    const int32_t one = int32_t(1) << uv_frac_;
    const int32_t half = one >> 1;
    const int x = (u.x - half) >> uv_frac_;
    const int y = (u.y - half) >> uv_frac_;
    const int64_t fx = (u.x - half) & (one - 1);
    const int64_t fy = (u.y - half) & (one - 1);
    const int64_t lower = texel(x, y) * (one - fx) + texel(x + 1, y) * fx;
    const int64_t upper = texel(x, y + 1) * (one - fx) + texel(x + 1, y + 1) * fx;
    counters_.reads += 4;
    return P::quantize(to_filtered_, P::exact(lower * (one - fy) + upper * fy, 2 * uv_frac_),
                       counters_.overflows);
}

template <class P>
typename P::Value Displace<P>::displacement(Uv u) {
    typename P::Wide height;
    if (map_.filter == HeightFilter::Bilinear) {
        height = bilinear(u);
    } else {
        ++counters_.reads;
        height = P::align(P::exact(texel(u.x >> uv_frac_, u.y >> uv_frac_), 0), filter_bits_);
    }
    const V scaled =
        P::quantize(to_displacement_, P::mul(height, map_.scale_mantissa), counters_.overflows);
    return P::quantize(add_bias_, typename P::Wide(scaled) + map_.bias, counters_.overflows);
}

template <class P>
Vec3<typename P::Value> Displace<P>::operator()(const Vec3<V>& p, const Vec3<V>& n, Uv u) {
    ++counters_.items;
    const V d = displacement(u);
    const auto displaced = [&](V position, V normal) {
        return P::quantize(to_position_, P::align(position, align_position_) + P::mul(d, normal),
                           counters_.overflows);
    };
    return {displaced(p.x, n.x), displaced(p.y, n.y), displaced(p.z, n.z)};
}

template <class P>
void Displace<P>::run(Span<Edge<P>> edges) {
    for (Edge<P>& edge : edges) {
        if (!edge.split) continue;
        edge.mid.displaced = (*this)(edge.mid.position, edge.mid.normal, edge.mid.uv);
    }
}

template class Displace<Fixed>;
template class Displace<Real>;

}  // namespace repousse
