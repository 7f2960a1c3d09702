#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace repousse::reference {

/// The Summed Height Test by brute force: boxes are summed texel by texel, periodic maps by modulo
/// indexing, averages compared as exact fractions in 128 bits. It knows neither summed-area tables
/// nor widths, and shares no code with the device (adaptive-tessellation.md, section 2, items 2-4).
struct HeightOracle {
    int width = 0;                  ///< texels
    int height = 0;                 ///< texels
    std::vector<uint32_t> heights;  ///< width * height, row by row
    bool wrap = false;
    bool literal = false;
    bool sum = false;
    uint64_t threshold = 0;
    int frac = 0;  ///< fraction bits of the coordinates

    using Point = std::array<int64_t, 2>;

    /// A box: sum of heights and number of texels, both counted.
    struct Box {
        uint64_t total = 0;
        uint64_t texels = 0;
    };
    Box box(Point centre, Point half) const;

    /// The decision for an edge whose new vertex is u12.
    bool operator()(Point u1, Point u2, Point u12) const;
};

/// floor(a / b) for b > 0, and a modulo b in 0 .. b - 1.
int64_t floor_divide(int64_t a, int64_t b);
int64_t floor_modulo(int64_t a, int64_t b);

}  // namespace repousse::reference
