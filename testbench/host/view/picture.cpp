#include "testbench/host/view/picture.h"

#include <algorithm>
#include <cmath>

namespace repousse::host {

double srgb_to_linear(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double linear_to_srgb(double value) {
    return value <= 0.0031308 ? value * 12.92 : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

std::uint8_t to_srgb8(double linear) {
    const double code = linear_to_srgb(std::clamp(linear, 0.0, 1.0)) * 255.0;
    return static_cast<std::uint8_t>(std::floor(code + 0.5));
}

std::vector<std::uint8_t> to_srgb8(const Picture& picture) {
    std::vector<std::uint8_t> bytes(picture.rgb.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] = to_srgb8(static_cast<double>(picture.rgb[i]));
    }
    return bytes;
}

}  // namespace repousse::host
