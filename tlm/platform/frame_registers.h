#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/units/shade.h"
#include "datapath/units/shade_desc.h"
#include "datapath/units/vertex_transform.h"
#include "tlm/platform/registers.h"

namespace repousse::shell {

/// Registers of a light: direction, diffuse and specular colour.
inline constexpr uint32_t kLightWords = 9;
static_assert(kFrameEnd == kLights + kLightWords * kMaxLights);

/// A frame's registers, latched when it starts, as the units want them.
class FrameRegisters {
public:
    void latch(const std::array<uint32_t, kRegisterCount>& file) {
        std::copy(file.begin(), file.begin() + kFrameEnd, words_.begin());
    }
    void clear() { words_ = {}; }

    uint32_t operator[](uint32_t index) const { return words_[index]; }
    int32_t word(uint32_t index) const { return static_cast<int32_t>(words_[index]); }
    Vec3<int32_t> vector(uint32_t index) const {
        return {word(index), word(index + 1), word(index + 2)};
    }
    Colour<int32_t> colour(uint32_t index) const {
        return {word(index), word(index + 1), word(index + 2)};
    }
    uint64_t address(Register low) const { return uint64_t(words_[low + 1]) << 32 | words_[low]; }
    bool has(Feature feature) const { return (words_[kFeatures] & feature) != 0; }

    ViewRegisters<Fixed> camera() const {
        return {vector(kEye),  vector(kRight), vector(kUp),    vector(kForward), word(kNear),
                word(kFocalX), word(kFocalY),  word(kCentreX), word(kCentreY)};
    }

    ShadeRegisters<Fixed> shade() const {
        ShadeRegisters<Fixed> r;
        r.eye = vector(kEye);
        r.ambient = colour(kAmbient);
        r.shininess = word(kShininess);
        r.two_sided = has(kTwoSided);
        uint32_t at = kLights;
        for (Light<Fixed>& light : r.lights) {
            light = {vector(at), colour(at + 3), colour(at + 6)};
            at += kLightWords;
        }
        return r;
    }

    /// The map registers, without the tables.
    MapView<Fixed> map() const {
        MapView<Fixed> map;
        map.width = word(kMapWidth);
        map.height = word(kMapHeight);
        map.wrap = has(kWrap);
        map.filter = has(kMaximum)    ? HeightFilter::Maximum
                     : has(kAverage)  ? HeightFilter::Average
                     : has(kBilinear) ? HeightFilter::Bilinear
                                      : HeightFilter::Nearest;
        map.finer = word(kFiner);
        map.last_level = word(kLastLevel);
        map.has_minima = has(kMinima);
        map.scale_mantissa = word(kScaleMantissa);
        map.scale_exponent = word(kScaleExponent);
        map.bias = word(kBias);
        map.slope_u = {word(kSlopeUMantissa), word(kSlopeUExponent) & 63};
        map.slope_v = {word(kSlopeVMantissa), word(kSlopeVExponent) & 63};
        return map;
    }

    /// What frames of both kinds need.
    bool plausible() const {
        const bool shines = words_[kShininess] >= 1 && words_[kShininess] < 1U << kShininessBits;
        return words_[kOutputCapacity] != 0 && words_[kMapWidth] != 0 && words_[kMapHeight] != 0 &&
               (shines || !has(kUseShade)) && (words_[kOutputVertexCapacity] != 0 || !has(kSweep));
    }

private:
    std::array<uint32_t, kFrameEnd> words_{};
};

}  // namespace repousse::shell
