#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/units/vertex_transform.h"
#include "tlm/platform/registers.h"

namespace repousse::shell {

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
    uint64_t address(Register low) const { return uint64_t(words_[low + 1]) << 32 | words_[low]; }
    bool has(Feature feature) const { return (words_[kFeatures] & feature) != 0; }

    ViewRegisters<Fixed> camera() const {
        return {vector(kEye),  vector(kRight), vector(kUp),    vector(kForward), word(kNear),
                word(kFocalX), word(kFocalY),  word(kCentreX), word(kCentreY)};
    }

    /// The map registers, without the tables.
    MapView<Fixed> map() const {
        MapView<Fixed> map;
        map.width = word(kMapWidth);
        map.height = word(kMapHeight);
        map.wrap = has(kWrap);
        map.filter = has(kBilinear) ? HeightFilter::Bilinear : HeightFilter::Nearest;
        map.scale_mantissa = word(kScaleMantissa);
        map.scale_exponent = word(kScaleExponent);
        map.bias = word(kBias);
        return map;
    }

    /// What frames of both kinds need.
    bool plausible() const {
        return words_[kOutputCapacity] != 0 && words_[kMapWidth] != 0 && words_[kMapHeight] != 0;
    }

private:
    std::array<uint32_t, kFrameEnd> words_{};
};

}  // namespace repousse::shell
