#pragma once

#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/span.h"

namespace repousse {

/// How a height is read between texels.
enum class HeightFilter : uint8_t {
    Nearest,   ///< the texel that U lies in, floor(U): as printed
    Bilinear,  ///< between the four texel centres around U
    Maximum,   ///< of the filter level's texels under the footprint; seen from the back the minimum
    Average,   ///< of the same texels
};

/// Whether heights come from the filter level that the footprint asks for.
inline constexpr bool reads_levels(HeightFilter filter) {
    return filter == HeightFilter::Maximum || filter == HeightFilter::Average;
}

/// Filter levels of a map beyond itself: the last one of 16384 texels a side is 1 x 1.
inline constexpr int kMostLevels = 14;

/// Levels below the one that a footprint asks for, at most (register `finer`): up to
/// kMostPlaces ^ 2 = 25 reads a vertex instead of four.
inline constexpr int kMostFiner = 2;
inline constexpr int kMostPlaces = (1 << kMostFiner) + 1;

/// Texels of filter level `level` along a side of `size` texels.
inline constexpr int level_side(int size, int level) { return (size + (1 << level) - 1) >> level; }

/// What a vertex reads of the filter levels (unit `footprint`): the texels of `level` under the
/// rectangle U +- reach. Of the map itself, its own texel: the default.
struct LevelRead {
    int32_t reach_x = 0;  ///< 0 and up, with the fraction bits of the profile's `uv`
    int32_t reach_y = 0;
    uint8_t level = 0;
    bool back = false;  ///< the surface is seen from the back here
};

/// The two rotations that take N to the displaced surface's normal (see bump), in half turns.
template <class V>
struct Turn {
    V about_b{};  ///< first, towards T
    V about_t{};  ///< then, towards B
};

/// A slope: rise in height LSB over two texels * mantissa * 2^-exponent, in world units a world
/// unit. Fixed: the mantissa has at most kScaleBits bits, the exponent is at most 62. Real: the
/// mantissa is the scale itself.
template <class P>
struct SlopeScale {
    typename P::Value mantissa{};
    int exponent = 0;
};

/// A displacement map as the device sees it: the descriptor registers and the tables they point
/// to. Row 0 is v = 0; texel (x, y) covers [x, x+1) x [y, y+1) and has its centre at +0.5.
template <class P>
struct MapView {
    int width = 0;      ///< texels
    int height = 0;     ///< texels
    bool wrap = false;  ///< periodic in both directions; otherwise clamped at the border
    HeightFilter filter = HeightFilter::Nearest;
    int finer =
        0;  ///< levels below that of the footprint, 0..kMostFiner; above 0 for Maximum alone
    int last_level = 0;       ///< filter levels that the table holds behind the map, 0..kMostLevels
    bool has_minima = false;  ///< of its own for vertices seen from the back, from level 1 on

    /// D = h * scale_mantissa * 2^-scale_exponent + bias with h in height LSB. Fixed: the mantissa
    /// has at most kScaleBits bits, the bias the profile's `displacement` format. Real: the
    /// mantissa is the scale itself.
    typename P::Value scale_mantissa{};
    int scale_exponent = 0;
    typename P::Value bias{};

    SlopeScale<P> slope_u;  ///< for bump of kind 1 alone
    SlopeScale<P> slope_v;

    Span<const uint16_t> heights;                 ///< row by row, level_start(*this, ...)
    Span<const Vec3<typename P::Texel>> normals;  ///< width * height; empty unless bump needs it
    Span<const Turn<typename P::Texel>> turns;    ///< width * height; for bump of kind 2 alone
    Span<const uint64_t> sums;                    ///< (width+1) * (height+1); see height_test
};

/// The place of a filter level's first texel in the table of heights: the map, levels 1 to
/// last_level, then, if there are any, the minima of levels 1 to last_level. One behind the last
/// level is the size of the table without minima. Below 2^30.
template <class P>
std::size_t level_start(const MapView<P>& map, int level, bool minima = false) {
    const auto size = [&map](int l) {
        return static_cast<std::size_t>(level_side(map.width, l)) *
               static_cast<std::size_t>(level_side(map.height, l));
    };
    std::size_t start = 0;
    for (int l = 0; l < level; ++l) start += size(l);
    if (!minima || level == 0) return start;
    for (int l = 1; l <= map.last_level; ++l) start += size(l);
    return start;
}

/// Texels in the table of heights.
template <class P>
std::size_t height_table_size(const MapView<P>& map) {
    return level_start(map, map.last_level + 1, map.has_minima);
}

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

/// The same for a batch: to[i] = texel_address((u[i] - offset) >> frac, size, wrap).
void texel_addresses(const int32_t* u, std::size_t n, int32_t offset, int frac, int size, bool wrap,
                     int32_t* to);

}  // namespace repousse
