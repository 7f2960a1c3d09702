#include "datapath/units/grid_transform.h"

#include <algorithm>
#include <type_traits>

#include "datapath/units/triangle_setup_desc.h"

namespace repousse {
namespace {

constexpr Format kGridPosition = {kGridPositionBits,    kGridFractionBits, true,
                                  Quantization::SC_RND, Overflow::SC_SAT,  0};

/// Vertex data are rounded to nearest and saturate, whatever the format's own modes are.
Format to_nearest(Format format) {
    format.quantization = Quantization::SC_RND;
    format.overflow = Overflow::SC_SAT;
    return format;
}

/// A table of which nothing is used is as small as can be.
OctaveLog2 octave_table(const Profile& profile) {
    const auto kind = static_cast<ZTableKind>(profile.z_table_kind);
    return {
        kind == ZTableKind::Quadratic ? OctaveLog2::Pieces::Quadratic : OctaveLog2::Pieces::Linear,
        kind == ZTableKind::Uniform ? 1 : profile.z_table_index_bits};
}

}  // namespace

template <class P>
GridTransform<P>::GridTransform(const Profile& profile)
    : kind_(static_cast<ZTableKind>(profile.z_table_kind)),
      index_bits_(profile.z_table_index_bits),
      clip_frac_(profile.clip.frac),
      uv_frac_(profile.uv.frac),
      one_(P::exact(int64_t{1} << profile.inverse_w.frac, profile.inverse_w.frac)),
      reciprocal_(profile.reciprocal_index_bits, profile.reciprocal_newton_steps,
                  profile.reciprocal_bits),
      log2_(octave_table(profile)),
      to_ndc_(profile.clip.frac, profile.clip.frac, profile.ndc),
      to_c_(profile.clip.frac, profile.clip.frac, profile.inverse_w),
      pixels_to_grid_(profile.ndc.frac + profile.focal.frac, kGridPosition),
      steps_to_grid_(profile.steps_per_octave.frac + OctaveLog2::kFractionBits, kGridPosition),
      table_to_grid_(kUniformTableFraction + kUniformFractionBits, kGridPosition),
      position_data_(profile.position.frac + profile.inverse_w.frac,
                     to_nearest(profile.sweep_data)),
      normal_data_(profile.normal.frac + profile.inverse_w.frac, to_nearest(profile.sweep_data)),
      uv_data_(profile.uv.frac + profile.inverse_w.frac, to_nearest(profile.sweep_data)),
      sign_data_(profile.inverse_w.frac, to_nearest(profile.sweep_data)) {}

template <class P>
GridPoint<P> GridTransform<P>::operator()(const EyePoint<P>& eye) {
    const GridRegisters<P>& r = registers_;
    ++counters_.items;
    counters_.w_clamped += eye.w < r.w_min;
    const V w = std::max(eye.w, r.w_min);
    const typename P::Inverse inverse = P::invert(reciprocal_, w);

    // 32 + 25 bits; and ratios times pixels, 31 + 22 bits in the shipped profiles.
    const V ratio_x = to_ndc_(eye.x, inverse, counters_.ratio_saturated);
    const V ratio_y = to_ndc_(eye.y, inverse, counters_.ratio_saturated);

    // The dividend is never above the inverse, so that the product needs no more bits than one;
    // the reciprocal's rounding may still leave c an LSB or so above 1.
    uint64_t unused = 0;
    counters_.c_saturated += w < r.w_scale;
    const V c = to_c_(std::min(r.w_scale, w), inverse, unused);

    GridPoint<P> point;
    point.position = {
        P::round(pixels_to_grid_, P::mul(ratio_x, r.focal_x), counters_.grid_saturated),
        P::round(pixels_to_grid_, P::mul(ratio_y, r.focal_y), counters_.grid_saturated), depth(w)};
    point.c = static_cast<V>(std::min<Wide>(c, one_));
    return point;
}

template <class P>
int32_t GridTransform<P>::depth(V w) {
    if constexpr (std::is_same_v<P, Fixed>) {
        if (kind_ == ZTableKind::Uniform) return uniform_depth(w);
    }
    // K has 30 bits at most, the difference 28: both logarithms lie within -64 .. 64.
    const Wide octaves = P::log2(log2_, w, clip_frac_) - registers_.log2_near;
    return P::round(steps_to_grid_, P::mul(registers_.steps_per_octave, octaves),
                    counters_.grid_saturated);
}

template <class P>
int32_t GridTransform<P>::uniform_depth(V w) {
    // 32 + 20 bits, cut to the table: below its first word and above its last one z stands still.
    const int64_t last = (int64_t{1} << (index_bits_ + kUniformFractionBits)) - 1;
    int64_t place = static_cast<int64_t>(w) - static_cast<int64_t>(registers_.table_near);
    place = place * registers_.table_scale >> registers_.table_shift;
    place = place > last ? last : place;
    place = place < 0 ? 0 : place;

    const auto index = static_cast<std::size_t>(place >> kUniformFractionBits);
    const int64_t fraction = place & ((int64_t{1} << kUniformFractionBits) - 1);
    const int64_t low = registers_.table[index];
    const int64_t rise = int64_t{registers_.table[index + 1]} - low;  // >= 0: 22 bits
    return static_cast<int32_t>(
        table_to_grid_((low << kUniformFractionBits) + rise * fraction, counters_.grid_saturated));
}

template <class P>
typename P::Value GridTransform<P>::scaled(const Cast& to_data, Wide component, V c) {
    return P::quantize(to_data, P::mul(component, c), counters_.data_saturated);
}

template <class P>
void GridTransform<P>::scale(const Vertex<P>& vertex, V c, bool tangents,
                             std::array<V, kSweepComponents>& data) {
    const auto vector = [&](const Vec3<V>& v, const Cast& cast, std::size_t at) {
        data[at] = scaled(cast, v.x, c);
        data[at + 1] = scaled(cast, v.y, c);
        data[at + 2] = scaled(cast, v.z, c);
    };
    vector(vertex.position, position_data_, 0);
    vector(vertex.normal, normal_data_, 3);
    data[6] = scaled(uv_data_, P::exact(vertex.uv.x, uv_frac_), c);
    data[7] = scaled(uv_data_, P::exact(vertex.uv.y, uv_frac_), c);
    data[kInverseWComponent] = c;
    if (tangents) {
        vector(vertex.tangent, normal_data_, kPlainComponents);
        data[12] = scaled(sign_data_, P::exact(vertex.handedness, 0), c);
    } else {
        std::fill(data.begin() + kPlainComponents, data.end(), V{});
    }
}

template class GridTransform<Fixed>;
template class GridTransform<Real>;

}  // namespace repousse
