#include "testbench/host/z_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "testbench/host/encoder.h"

namespace repousse::host {
namespace {

/// The paper's lookup array, uniform in w from near to far. Its scale has 20 bits, so the last
/// interval may end up to 2^-19 of the range beyond far; words stand where the device looks.
void set_uniform_table(const Profile& profile, const GridCamera& camera,
                       GridRegisters<Fixed>& registers, std::vector<uint32_t>& table) {
    const auto raw = [&profile](double w) {
        const double most = static_cast<double>(profile.clip.max_raw());
        return std::clamp(std::floor(std::ldexp(w, profile.clip.frac) + 0.5), 1.0, most);
    };
    const double near = raw(camera.view.near);
    const double range = std::max(1.0, raw(camera.far) - near);
    const int place_bits = profile.z_table_index_bits + kUniformFractionBits;
    const double places_per_lsb = std::ldexp(1.0, place_bits) / range;

    // A table finer than the LSB of w is of no use: shift 0 then.
    const int shift = std::clamp(kUniformScaleBits - 1 - std::ilogb(places_per_lsb), 0, 63);
    const double scale = std::min(std::floor(std::ldexp(places_per_lsb, shift)),
                                  std::ldexp(1.0, kUniformScaleBits) - 1.0);
    registers.table_near = static_cast<int32_t>(near);
    registers.table_scale = static_cast<uint32_t>(scale);
    registers.table_shift = static_cast<uint8_t>(shift);

    const double most = std::ldexp(1.0, kUniformTableBits) - 1.0;
    table.clear();
    for (uint32_t i = 0; i <= uint32_t{1} << profile.z_table_index_bits; ++i) {
        const double w = near + std::ldexp(i / scale, kUniformFractionBits + shift);
        const double z = grid_depth(camera, std::ldexp(w, -profile.clip.frac));
        const double word = std::floor(std::ldexp(z, kUniformTableFraction) + 0.5);
        table.push_back(static_cast<uint32_t>(std::clamp(word, 0.0, most)));
    }
    registers.table = table;
}

}  // namespace

double steps_per_octave(const GridCamera& camera) {
    return std::log(2.0) / std::log1p(1.0 / std::abs(camera.view.focal.y)) / camera.coarseness;
}

double grid_depth(const GridCamera& camera, double w) {
    return steps_per_octave(camera) * std::log2(w / camera.view.near);
}

template <class P>
Result<GridRegisters<P>> make_grid_registers(const Profile& profile, const GridCamera& camera,
                                             std::vector<uint32_t>& table) {
    Encoder<P> encode(profile);
    const ViewFrame& view = camera.view;
    GridRegisters<P> r;
    r.w_min = encode.value(camera.w_min, &Profile::clip, "the least w");
    r.w_scale = encode.value(std::max(camera.w_scale, camera.w_min), &Profile::clip, "w_scale");
    r.focal_x = encode.value(view.focal.x / camera.coarseness, &Profile::focal, "focal length");
    r.focal_y = encode.value(view.focal.y / camera.coarseness, &Profile::focal, "focal length");
    r.steps_per_octave =
        encode.value(steps_per_octave(camera), &Profile::steps_per_octave, "grid steps per octave");
    table.clear();
    if constexpr (std::is_same_v<P, Real>) {
        r.log2_near = std::log2(view.near);
    } else {
        r.w_min = std::max(r.w_min, 1);
        r.w_scale = std::max(r.w_scale, r.w_min);
        r.log2_near = static_cast<int32_t>(
            std::floor(std::ldexp(std::log2(view.near), OctaveLog2::kFractionBits) + 0.5));
        if (static_cast<ZTableKind>(profile.z_table_kind) == ZTableKind::Uniform) {
            set_uniform_table(profile, camera, r, table);
        }
    }
    const Status fits = encode.status();
    if (!fits) return fits.error();
    return r;
}

template Result<GridRegisters<Fixed>> make_grid_registers(const Profile&, const GridCamera&,
                                                          std::vector<uint32_t>&);
template Result<GridRegisters<Real>> make_grid_registers(const Profile&, const GridCamera&,
                                                         std::vector<uint32_t>&);

}  // namespace repousse::host
