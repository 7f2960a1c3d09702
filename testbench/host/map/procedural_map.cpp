#include "testbench/host/map/procedural_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace repousse::host {
namespace {

HeightMap empty_map(int width, int height) {
    HeightMap map;
    map.width = width;
    map.height = height;
    map.texels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    return map;
}

std::uint16_t saturate(std::int64_t value) {
    return static_cast<std::uint16_t>(std::clamp<std::int64_t>(value, 0, 65535));
}

/// SplitMix64's finaliser: a bijection of 64 bits in which every input bit reaches every output
/// bit.
std::uint64_t mix(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

constexpr int kFraction = 16;  // of lattice coordinates and weights
constexpr std::int64_t kOne = std::int64_t{1} << kFraction;

/// 6t^5 - 15t^4 + 10t^3 of a 16-bit fraction; 16 fraction bits again. Each product stays below
/// 2^16 * 2^21, far inside 64 bits.
std::int64_t fade(std::int64_t t) {
    const std::int64_t inner = ((6 * t - 15 * kOne) * t >> kFraction) + 10 * kOne;
    const std::int64_t square = t * t >> kFraction;
    return (square * t >> kFraction) * inner >> kFraction;
}

/// Gradient of a lattice point times the offset from it (16 fraction bits). The sixteen gradients
/// are the points of a circle of radius 256 at odd multiples of 11.25 degrees, so that no
/// gradient is along an axis and the noise shows no grid.
std::int64_t slope(std::uint64_t hash, std::int64_t dx, std::int64_t dy) {
    constexpr std::array<std::array<int, 2>, 16> kGradients{{{251, 50},
                                                             {213, 142},
                                                             {142, 213},
                                                             {50, 251},
                                                             {-50, 251},
                                                             {-142, 213},
                                                             {-213, 142},
                                                             {-251, 50},
                                                             {-251, -50},
                                                             {-213, -142},
                                                             {-142, -213},
                                                             {-50, -251},
                                                             {50, -251},
                                                             {142, -213},
                                                             {213, -142},
                                                             {251, -50}}};
    const auto& g = kGradients[hash >> 60];
    return (g[0] * dx + g[1] * dy) >> 8;
}

/// One octave of gradient noise over a lattice of cells_x x cells_y cells.
struct Octave {
    std::uint64_t seed;
    std::int64_t cells_x;
    std::int64_t cells_y;
    bool wrap;

    std::uint64_t hash(std::int64_t i, std::int64_t j) const {
        if (wrap) i %= cells_x, j %= cells_y;
        const auto key = static_cast<std::uint64_t>(i) << 32 | static_cast<std::uint64_t>(j);
        return mix(seed ^ mix(key + 0x9E3779B97F4A7C15ull));
    }

    /// About -0.7..0.7 with 16 fraction bits, at (x, y) in cells with 16 fraction bits.
    std::int64_t at(std::int64_t x, std::int64_t y) const {
        const std::int64_t i = x >> kFraction;
        const std::int64_t j = y >> kFraction;
        const std::int64_t fx = x & (kOne - 1);
        const std::int64_t fy = y & (kOne - 1);
        const std::int64_t wx = fade(fx);
        const std::int64_t a = slope(hash(i, j), fx, fy);
        const std::int64_t b = slope(hash(i + 1, j), fx - kOne, fy);
        const std::int64_t c = slope(hash(i, j + 1), fx, fy - kOne);
        const std::int64_t d = slope(hash(i + 1, j + 1), fx - kOne, fy - kOne);
        const std::int64_t low = a + ((b - a) * wx >> kFraction);
        const std::int64_t high = c + ((d - c) * wx >> kFraction);
        return low + ((high - low) * fade(fy) >> kFraction);
    }
};

/// Lattice coordinate of a texel's centre: (2 i + 1) / (2 size) of the map, 16 fraction bits.
std::int64_t lattice(int i, int size, std::int64_t cells) {
    return ((2 * std::int64_t{i} + 1) * cells << kFraction) / (2 * std::int64_t{size});
}

}  // namespace

HeightMap make_donut_map(int width, int height) {
    HeightMap map = empty_map(width, height);
    map.range_high = 0.12;
    std::size_t at = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++at) {
            const double px = (x + 0.5) / width - 0.5;
            const double py = (y + 0.5) / height - 0.5;
            const double rho = std::sqrt(px * px + py * py) - 0.3;
            const double square = 0.12 * 0.12 - rho * rho;
            const double d = square > 0.0 ? std::sqrt(square) : 0.0;
            map.texels[at] =
                saturate(static_cast<std::int64_t>(std::floor(d / 0.12 * 65535.0 + 0.5)));
        }
    }
    return map;
}

HeightMap make_constant_map(int width, int height, std::uint16_t value) {
    HeightMap map = empty_map(width, height);
    std::fill(map.texels.begin(), map.texels.end(), value);
    return map;
}

HeightMap make_ramp_map(int width, int height, int start, int slope_x, int slope_y) {
    HeightMap map = empty_map(width, height);
    std::size_t at = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++at) {
            map.texels[at] =
                saturate(start + std::int64_t{slope_x} * x + std::int64_t{slope_y} * y);
        }
    }
    return map;
}

HeightMap make_checker_map(int width, int height, int square, std::uint16_t low,
                           std::uint16_t high) {
    HeightMap map = empty_map(width, height);
    std::size_t at = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x, ++at) {
            map.texels[at] = (x / square + y / square) % 2 == 0 ? low : high;
        }
    }
    return map;
}

HeightMap make_fbm_map(int width, int height, const FbmSettings& settings) {
    HeightMap map = empty_map(width, height);
    map.wrap = settings.wrap;
    std::vector<std::int64_t> sums(map.texels.size(), 0);
    std::int64_t amplitude = kOne;
    for (int k = 0; k < settings.octaves; ++k) {
        const Octave octave{mix(settings.seed + static_cast<std::uint64_t>(k)),
                            std::int64_t{settings.cells_x} << k,
                            std::int64_t{settings.cells_y} << k, settings.wrap};
        std::size_t at = 0;
        for (int y = 0; y < height; ++y) {
            const std::int64_t ly = lattice(y, height, octave.cells_y);
            for (int x = 0; x < width; ++x, ++at) {
                std::int64_t noise = octave.at(lattice(x, width, octave.cells_x), ly);
                if (settings.ridged) noise = kOne / 2 - (noise < 0 ? -noise : noise);
                sums[at] += noise * amplitude >> kFraction;
            }
        }
        amplitude = amplitude * settings.gain_percent / 100;
    }
    const auto [low, high] = std::minmax_element(sums.begin(), sums.end());
    const std::int64_t span = std::max<std::int64_t>(*high - *low, 1);
    const std::int64_t base = *low;
    for (std::size_t at = 0; at < sums.size(); ++at) {
        map.texels[at] = saturate(((sums[at] - base) * 65535 + span / 2) / span);
    }
    return map;
}

}  // namespace repousse::host
