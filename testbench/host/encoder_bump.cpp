// What bump reads, of each kind, from one map of heights.

#include <algorithm>
#include <cmath>

#include "datapath/units/bump_desc.h"
#include "testbench/host/encoder.h"
#include "testbench/host/map/normal_map.h"

namespace repousse::host {

// World units of height a stored LSB, over two texels' size.
template <class P>
SlopeScale<P> Encoder<P>::slope_scale(const HeightMap& map, double texel_size) {
    const double range = map.range_high - map.range_low;
    if constexpr (std::is_same_v<P, Real>) return {range / 65535.0 / (2.0 * texel_size), 0};
    const double scale =
        range / static_cast<double>(profile_.height.max_raw()) / (2.0 * texel_size);
    if (!(scale < std::ldexp(1.0, kScaleBits))) {
        refuse("a slope of " + std::to_string(scale) + " a height step is too steep");
        return {};
    }
    int exponent = 0;
    std::frexp(scale, &exponent);
    SlopeScale<P> registers;
    registers.exponent = std::clamp(kScaleBits - 1 - exponent, 0, 62);
    registers.mantissa =
        static_cast<typename P::Value>(std::lround(std::ldexp(scale, registers.exponent)));
    return registers;
}

// Kinds 0 and 2 hold the same normals, of the same differences that kind 1 forms of the heights.
template <class P>
void Encoder<P>::bump(const DrawInputs& inputs, MapView<P>& view, MapTables<P>& tables) {
    using Texel = typename P::Texel;
    const glm::dvec2 size = inputs.texel_size;
    const auto kind = static_cast<BumpKind>(profile_.bump_kind);
    if (kind == BumpKind::Slopes) {
        view.slope_u = slope_scale(*inputs.map, size.x);
        view.slope_v = slope_scale(*inputs.map, size.y);
        return;
    }
    for (const glm::dvec3& n : normal_map(*inputs.map, size.x, size.y)) {
        if (kind == BumpKind::Normals) {
            const auto v = vector(n, &Profile::map_normal, "map normal");
            tables.normals.push_back({Texel(v.x), Texel(v.y), Texel(v.z)});
        } else {
            const glm::dvec2 turn = turns_of(n);
            const auto angle = [&](double half_turns) {
                return Texel(value(half_turns, &Profile::angle, "angle of a map normal"));
            };
            tables.turns.push_back({angle(turn.x), angle(turn.y)});
        }
    }
}

template SlopeScale<Fixed> Encoder<Fixed>::slope_scale(const HeightMap&, double);
template SlopeScale<Real> Encoder<Real>::slope_scale(const HeightMap&, double);
template void Encoder<Fixed>::bump(const DrawInputs&, MapView<Fixed>&, MapTables<Fixed>&);
template void Encoder<Real>::bump(const DrawInputs&, MapView<Real>&, MapTables<Real>&);

}  // namespace repousse::host
