#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/span.h"

namespace repousse {

/// How a height is read between texels.
enum class HeightFilter : uint8_t {
    Nearest,   ///< the texel that U lies in, floor(U): as printed
    Bilinear,  ///< between the four texel centres around U
};

/// A displacement map as the device sees it: the descriptor registers and the tables they point
/// to. Row 0 is v = 0; texel (x, y) covers [x, x+1) x [y, y+1) and has its centre at +0.5.
template <class P>
struct MapView {
    int width = 0;      ///< texels
    int height = 0;     ///< texels
    bool wrap = false;  ///< periodic in both directions; otherwise clamped at the border
    HeightFilter filter = HeightFilter::Nearest;

    /// D = h * scale_mantissa * 2^-scale_exponent + bias with h in height LSB. Fixed: the mantissa
    /// has at most kScaleBits bits, the bias the profile's `displacement` format. Real: the
    /// mantissa is the scale itself.
    typename P::Value scale_mantissa{};
    int scale_exponent = 0;
    typename P::Value bias{};

    Span<const uint16_t> heights;                 ///< width * height, row by row
    Span<const Vec3<typename P::Texel>> normals;  ///< width * height; empty unless bump needs it
    Span<const uint64_t> sums;                    ///< (width+1) * (height+1); see height_test
};

/// A texel coordinate brought into [0, size): periodic by one compare-and-add a side, so `i` must
/// lie within one period of the map, or clamped to the border.
inline int texel_address(int i, int size, bool wrap) {
    if (wrap) {
        i += i < 0 ? size : 0;
        i -= i >= size ? size : 0;
        return i;
    }
    i = i < 0 ? 0 : i;
    i = i > size - 1 ? size - 1 : i;
    return i;
}

}  // namespace repousse
