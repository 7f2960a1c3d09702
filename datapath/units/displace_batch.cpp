// The displacement of batches of fine vertices. Texels are read in the order of the vertices.

#include "datapath/units/displace.h"

namespace repousse {

template <class P>
void Displace<P>::run(FineVertices<P>& b) {
    counters_.items += b.size;
    FineArray<V> h;
    heights(b, h);
    move(b, h);
}

// ---- heights ------------------------------------------------------------------------------------

/// The four texels around each vertex.
template <class P>
struct Displace<P>::Cells {
    FineArray<uint32_t> left_low, right_low, left_high, right_high;
};

template <class P>
void Displace<P>::heights(const FineVertices<P>& b, FineArray<V>& to) {
    if (map_.filter == HeightFilter::Bilinear) {
        Cells cells;
        read(b, cells);
        interpolate(b, cells, to);
        return;
    }
    const bool levels = reads_levels(map_.filter);
    for (std::size_t i = 0; i < b.size; ++i) {
        to[i] = static_cast<V>(height(b.uv(i), levels ? b.reads[i] : LevelRead{}));
    }
}

template <class P>
void Displace<P>::read(const FineVertices<P>& b, Cells& cells) {
    const int32_t one = int32_t{1} << uv_frac_, half = one >> 1;
    FineArray<int32_t> left, right, low, high;
    const auto addresses = [&](const FineArray<int32_t>& u, int32_t offset, int size,
                               FineArray<int32_t>& to) {
        texel_addresses(u.data(), b.size, offset, uv_frac_, size, map_.wrap, to.data());
    };
    addresses(b.u, half, map_.width, left);
    addresses(b.u, half - one, map_.width, right);
    addresses(b.v, half, map_.height, low);
    addresses(b.v, half - one, map_.height, high);
    for (std::size_t i = 0; i < b.size; ++i) {
        cells.left_low[i] = texel(left[i], low[i]);
        cells.right_low[i] = texel(right[i], low[i]);
        cells.left_high[i] = texel(left[i], high[i]);
        cells.right_high[i] = texel(right[i], high[i]);
    }
}

template <>
REPOUSSE_VECTOR_CLONES void Displace<Fixed>::interpolate(const FineVertices<Fixed>& b,
                                                         const Cells& c, FineArray<V>& to) {
    const int32_t half = int32_t{1} << uv_frac_ >> 1;
    Fixed::quantize(to_filtered_, b.size, to.data(), counters_.overflows, [&](std::size_t i) {
        return between(c.left_low[i], c.right_low[i], c.left_high[i], c.right_high[i],
                       b.u[i] - half, b.v[i] - half);
    });
}

template <>
void Displace<Real>::interpolate(const FineVertices<Real>& b, const Cells& c, FineArray<V>& to) {
    const int32_t half = int32_t{1} << uv_frac_ >> 1;
    for (std::size_t i = 0; i < b.size; ++i) {
        to[i] = Real::exact(between(c.left_low[i], c.right_low[i], c.left_high[i], c.right_high[i],
                                    b.u[i] - half, b.v[i] - half),
                            2 * uv_frac_);
    }
}

// ---- movements ----------------------------------------------------------------------------------

namespace {

template <class P>
struct DisplaceCasts {
    const Cast &to_displacement, &add_bias, &to_position;
    typename P::Value mantissa, bias;
    int align_position;
};

template <class P>
inline void move_all(FineVertices<P>& b, const FineArray<typename P::Value>& heights,
                     const DisplaceCasts<P>& c, uint64_t& overflows) {
    using Wide = typename P::Wide;
    const Wide mantissa = c.mantissa, bias = c.bias;
    const int align = c.align_position;
    FineArray<typename P::Value> scaled, d;
    P::quantize(c.to_displacement, b.size, scaled.data(), overflows,
                [&](std::size_t i) { return P::mul(heights[i], mantissa); });
    P::quantize(c.add_bias, b.size, d.data(), overflows,
                [&](std::size_t i) { return Wide(scaled[i]) + bias; });
    const auto component = [&](const auto& position, const auto& normal, auto& to) {
        P::quantize(c.to_position, b.size, to.data(), overflows, [&](std::size_t i) {
            return P::align(position[i], align) + P::mul(d[i], normal[i]);
        });
    };
    component(b.position.x, b.normal.x, b.displaced.x);
    component(b.position.y, b.normal.y, b.displaced.y);
    component(b.position.z, b.normal.z, b.displaced.z);
}

}  // namespace

template <>
REPOUSSE_VECTOR_CLONES void Displace<Fixed>::move(FineVertices<Fixed>& b,
                                                  const FineArray<V>& heights) {
    move_all<Fixed>(b, heights,
                    {to_displacement_, add_bias_, to_position_, map_.scale_mantissa, map_.bias,
                     align_position_},
                    counters_.overflows);
}

template <>
void Displace<Real>::move(FineVertices<Real>& b, const FineArray<V>& heights) {
    move_all<Real>(b, heights,
                   {to_displacement_, add_bias_, to_position_, map_.scale_mantissa, map_.bias,
                    align_position_},
                   counters_.overflows);
}

template void Displace<Fixed>::run(FineVertices<Fixed>&);
template void Displace<Real>::run(FineVertices<Real>&);

}  // namespace repousse
