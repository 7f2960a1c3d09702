// Step 1 of bump: what a texel says of the displaced surface, in the map's frame.

#include "datapath/units/bump.h"

namespace repousse {

/// The place of texel (x, y), brought onto the map, in the table of the kind.
template <class P>
std::size_t Bump<P>::texel_index(int x, int y) {
    ++counters_.reads;
    const std::size_t place = static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
                              static_cast<std::size_t>(x);
    if (port_ != nullptr) port_->read(static_cast<uint32_t>(place));
    return place;
}

template <class P>
Vec3<typename P::Value> Bump<P>::map_vector(Uv u) {
    const int x = texel_address(u.x >> uv_frac_, map_.width, map_.wrap);
    const int y = texel_address(u.y >> uv_frac_, map_.height, map_.wrap);
    if (kind_ == BumpKind::Slopes) return slopes(x, y);
    if (kind_ == BumpKind::Turns) return turned(map_.turns[texel_index(x, y)]);
    const auto& stored = map_.normals[texel_index(x, y)];
    return {V(stored.x), V(stored.y), V(stored.z)};
}

// Texels are read in the order of the vertices.
template <class P>
void Bump<P>::map_vectors(const FineVertices<P>& b, FineVectors<V>& d) {
    if (kind_ != BumpKind::Normals) {
        for (std::size_t i = 0; i < b.size; ++i) d.set(i, map_vector(b.uv(i)));
        return;
    }
    FineArray<int32_t> x, y;
    texel_addresses(b.u.data(), b.size, 0, uv_frac_, map_.width, map_.wrap, x.data());
    texel_addresses(b.v.data(), b.size, 0, uv_frac_, map_.height, map_.wrap, y.data());
    for (std::size_t i = 0; i < b.size; ++i) {
        const auto& stored = map_.normals[texel_index(x[i], y[i])];
        d.set(i, {V(stored.x), V(stored.y), V(stored.z)});
    }
}

// Central differences over two texels; beside a border that is not periodic over one, which counts
// twice. A map of one texel across has slope 0: both neighbours are the texel itself. A rise has
// 16 bits and a sign, doubled 18; times a mantissa of 24 bits 42.
template <class P>
Vec3<typename P::Value> Bump<P>::slopes(int x, int y) {
    const auto height = [&](int i, int j) {
        return int32_t{map_.heights[texel_index(texel_address(i, map_.width, map_.wrap),
                                                texel_address(j, map_.height, map_.wrap))]};
    };
    const auto over_two_texels = [&](int32_t rise, int i, int size) {
        const bool at_border = !map_.wrap && (i == 0 || i == size - 1);
        return P::exact(at_border ? 2 * rise : rise, 0);
    };
    // One after the other, in the order of the read port.
    const int32_t left = height(x - 1, y);
    const int32_t right = height(x + 1, y);
    const int32_t below = height(x, y - 1);
    const int32_t above = height(x, y + 1);
    const int32_t rise_x = right - left;
    const int32_t rise_y = above - below;
    const auto slope = [&](const Cast& cast, const SlopeScale<P>& scale, typename P::Wide rise) {
        return P::quantize(cast, P::mul(rise, scale.mantissa), counters_.overflows);
    };
    const V s_u = slope(to_slope_u_, map_.slope_u, over_two_texels(rise_x, x, map_.width));
    const V s_v = slope(to_slope_v_, map_.slope_v, over_two_texels(rise_y, y, map_.height));
    return {-s_u, -s_v, one_};
}

// Rotations by a quarter turn at most from N; no root is needed for a vector of length one.
template <class P>
Vec3<typename P::Value> Bump<P>::turned(const Turn<typename P::Texel>& turn) {
    const auto [sin_a, cos_a] = sin_cos_(V(turn.about_b), counters_.overflows);
    const auto [sin_b, cos_b] = sin_cos_(V(turn.about_t), counters_.overflows);
    return {sin_a, P::quantize(product_to_normal_, P::mul(cos_a, sin_b), counters_.overflows),
            P::quantize(product_to_normal_, P::mul(cos_a, cos_b), counters_.overflows)};
}

template std::size_t Bump<Fixed>::texel_index(int, int);
template std::size_t Bump<Real>::texel_index(int, int);
template Vec3<Fixed::Value> Bump<Fixed>::map_vector(Uv);
template Vec3<Real::Value> Bump<Real>::map_vector(Uv);
template void Bump<Fixed>::map_vectors(const FineVertices<Fixed>&, FineVectors<Fixed::Value>&);
template void Bump<Real>::map_vectors(const FineVertices<Real>&, FineVectors<Real::Value>&);

}  // namespace repousse
