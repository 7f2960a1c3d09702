#pragma once

#include <string_view>
#include <vector>

#include "datapath/profile.h"

namespace repousse {

/// What one device is built from: the reduction of the scenes it has to run. Units that are not
/// needed are never constructed, their tables never made.
struct DeviceConfig {
    Profile profile;
    bool adaptive = false;     ///< adaptive tessellation
    bool view_test = false;    ///< adaptive; with it vertex_transform
    bool normal_test = false;  ///< adaptive; needs bump
    bool height_test = false;  ///< adaptive; with it the summed-area table
    bool direct = false;       ///< triangles that are not displaced
    bool sweep = false;      ///< sweep-line remeshing; with it vertex_transform, and all of direct
    bool view_clip = false;  ///< sweep: clipping of base triangles
    bool bump = false;       ///< with it the normal map
    bool levels = false;     ///< sweep: filter levels of the displacement map, and footprints
    bool shade = false;      ///< illumination of displaced vertices
    int contexts = 1;        ///< 1 to 32: triangles in flight; they set the time, not the values
    double clock_period_ns = 2.0;

    /// The smallest device that can do what both can; the profile and clock are this one's.
    void include(const DeviceConfig& other) {
        adaptive |= other.adaptive;
        view_test |= other.view_test;
        normal_test |= other.normal_test;
        height_test |= other.height_test;
        direct |= other.direct;
        sweep |= other.sweep;
        view_clip |= other.view_clip;
        bump |= other.bump | other.normal_test;
        levels |= other.levels;
        shade |= other.shade;
        contexts = contexts > other.contexts ? contexts : other.contexts;
    }

    /// Every unit, called for or not.
    void include_everything() {
        adaptive = view_test = normal_test = height_test = true;
        direct = sweep = view_clip = bump = levels = shade = true;
    }

    bool has_controller() const { return sweep || direct; }
    bool has_displace() const { return adaptive || sweep; }
    bool has_bump() const { return has_displace() && (bump || (adaptive && normal_test)); }
    bool has_vertex_transform() const { return sweep || (adaptive && view_test); }
};

/// The units that a device is built from, in pipeline order.
std::vector<std::string_view> elaborated_units(const DeviceConfig& config);

/// The units that it goes without.
std::vector<std::string_view> omitted_units(const DeviceConfig& config);

}  // namespace repousse
