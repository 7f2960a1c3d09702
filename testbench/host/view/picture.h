#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace repousse::host {

/// A finished picture: row 0 at the top, three floats a pixel in linear light.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;  ///< 3 * width * height

    float* pixel(int x, int y) { return &rgb[3 * (static_cast<std::size_t>(y) * width + x)]; }
    const float* pixel(int x, int y) const {
        return &rgb[3 * (static_cast<std::size_t>(y) * width + x)];
    }
};

/// One channel from sRGB (0..1) to linear light and back (IEC 61966-2-1).
double srgb_to_linear(double value);
double linear_to_srgb(double value);

/// A channel of linear light as an 8-bit sRGB code; what is beyond 0..1 saturates.
std::uint8_t to_srgb8(double linear);

/// The picture as 8-bit sRGB, 3 bytes a pixel.
std::vector<std::uint8_t> to_srgb8(const Picture& picture);

}  // namespace repousse::host
