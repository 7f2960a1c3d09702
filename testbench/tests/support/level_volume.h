#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "testbench/host/map/height_map.h"
#include "testbench/host/map/procedural_map.h"

namespace repousse::test {

/// A map of fractal noise.
inline host::HeightMap noise(int width, int height, std::uint64_t seed, bool wrap) {
    host::FbmSettings settings;
    settings.seed = seed;
    settings.wrap = wrap;
    host::HeightMap map = host::make_fbm_map(width, height, settings);
    map.wrap = wrap;
    return map;
}

/// The volume as it is defined: every texel centre, its four vertices found by floor, in double.
inline double volume_by_definition(const host::HeightMap& map, const host::HeightMap& level,
                                   int k) {
    const auto vertex = [&](int i, int j) {
        const auto place = [&](int v, int size) {
            return map.wrap ? (v % size + size) % size : std::clamp(v, 0, size - 1);
        };
        return static_cast<double>(level.at(place(i, level.width), place(j, level.height)));
    };
    double volume = 0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const double u = std::ldexp(x + 0.5, -k) - 0.5;
            const double v = std::ldexp(y + 0.5, -k) - 0.5;
            const int i = static_cast<int>(std::floor(u));
            const int j = static_cast<int>(std::floor(v));
            const double s = u - i;
            const double t = v - j;
            volume += std::abs((1 - t) * ((1 - s) * vertex(i, j) + s * vertex(i + 1, j)) +
                               t * ((1 - s) * vertex(i, j + 1) + s * vertex(i + 1, j + 1)) -
                               map.at(x, y));
        }
    }
    return volume;
}

}  // namespace repousse::test
