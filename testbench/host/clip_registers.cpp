#include "testbench/host/clip_registers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include <glm/trigonometric.hpp>

namespace repousse::host {
namespace {

double lsb(const Format& format) { return std::ldexp(1.0, -format.frac); }

/// A scaled value, already rounded, cut to what the format holds.
int32_t saturated(double scaled, const Format& format) {
    return static_cast<int32_t>(std::clamp(scaled, static_cast<double>(format.min_raw()),
                                           static_cast<double>(format.max_raw())));
}

/// A plane x cosine = w sine with sine / cosine >= slope, both within 0 .. 1 and of a length of at
/// most 1: a distance from it is never exaggerated.
struct Plane {
    int32_t cosine = 0;
    int32_t sine = 0;
};

Plane outward(double slope, const Format& row) {
    const double one = std::ldexp(1.0, row.frac);
    const double angle = std::atan(slope);
    // One unit less of cosine makes room for the sine's rounding up; the loop is for the doubles'.
    for (double cosine = std::floor(std::cos(angle) * one) - 1; cosine > 0; --cosine) {
        const double sine = std::ceil(cosine * slope);
        if (cosine * cosine + sine * sine <= one * one) {
            return {saturated(cosine, row), saturated(sine, row)};
        }
    }
    return {};  // a view of 180 degrees: nothing is beyond
}

}  // namespace

template <class P>
ClipRegisters<P> make_clip_registers(const Profile& profile, const CameraSettings& camera,
                                     const Viewport& viewport) {
    const double slope_y = std::tan(0.5 * glm::radians(camera.fov_deg));
    const double slope_x = slope_y * viewport.width_px / viewport.height_px;
    ClipRegisters<P> r;
    if constexpr (std::is_same_v<P, Real>) {
        r.near = camera.near;
        r.far = camera.far;
        r.cosine_x = std::cos(std::atan(slope_x));
        r.sine_x = std::sin(std::atan(slope_x));
        r.cosine_y = std::cos(std::atan(slope_y));
        r.sine_y = std::sin(std::atan(slope_y));
    } else {
        // Half a unit in each of three components of a row moves a coordinate of a visible point,
        // which is w sqrt(1 + slopes^2) away at most, by `turn` * w.
        const double turn = 0.5 * lsb(profile.view_row) *
                            std::sqrt(3.0 * (1.0 + slope_x * slope_x + slope_y * slope_y));
        const auto turned = [turn](double slope) {
            return turn < 1.0 ? (slope + turn) / (1.0 - turn) : HUGE_VAL;
        };
        const Plane x = outward(turned(slope_x), profile.view_row);
        const Plane y = outward(turned(slope_y), profile.view_row);
        r.cosine_x = x.cosine;
        r.sine_x = x.sine;
        r.cosine_y = y.cosine;
        r.sine_y = y.sine;
        const double unit = lsb(profile.clip);
        r.near = saturated(std::floor(camera.near * (1.0 - turn) / unit), profile.clip);
        r.far = saturated(std::ceil(camera.far * (1.0 + turn) / unit), profile.clip);
        // Half a unit in each of two eye coordinates along a plane's normal, and in each of the
        // three of the eye and of a base vertex. (The last term is what doubles lack.)
        const double moved = std::sqrt(0.5) + std::sqrt(3.0) * lsb(profile.position) / unit + 1e-3;
        r.margin = saturated(std::ceil(moved), profile.clip);
    }
    return r;
}

template <class P>
Result<typename P::Value> max_displacement_register(const Profile& profile, double d) {
    if constexpr (std::is_same_v<P, Real>) {
        return d;
    } else {
        // |N| of a rounded normal exceeds 1 by less than its LSB, and a rounded camera stretches by
        // less than two of its own; D itself is rounded by half a unit.
        // CORDIC adds up to a quarter of an LSB in each component before the rounding.
        const double by_cordic = profile.normalise_kind == 0 ? 0.0 : 0.5 * lsb(profile.normal);
        const double stretch = 1.0 + lsb(profile.normal) + 2.0 * lsb(profile.view_row) +
                               std::ldexp(1.0, 1 - profile.inverse_sqrt_bits) + by_cordic;
        const double raw = std::ceil(std::abs(d) * stretch / lsb(profile.displacement)) + 1.0;
        if (raw > static_cast<double>(profile.displacement.max_raw())) {
            return Error{ErrorKind::Input,
                         {},
                         "a displacement of " + std::to_string(d) +
                             " with its rounding does not "
                             "fit " +
                             to_string(profile.displacement),
                         {},
                         "scale the scene or choose a wider profile"};
        }
        return static_cast<int32_t>(raw);
    }
}

template ClipRegisters<Fixed> make_clip_registers(const Profile&, const CameraSettings&,
                                                  const Viewport&);
template ClipRegisters<Real> make_clip_registers(const Profile&, const CameraSettings&,
                                                 const Viewport&);
template Result<int32_t> max_displacement_register<Fixed>(const Profile&, double);
template Result<double> max_displacement_register<Real>(const Profile&, double);

}  // namespace repousse::host
