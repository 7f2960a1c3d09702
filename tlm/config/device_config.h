#pragma once

#include <string_view>
#include <vector>

#include "datapath/profile.h"

namespace repousse {

/// What one device is built from: the reduction of the scenes it has to run. Units that are not
/// needed are never constructed, their tables never made.
struct DeviceConfig {
    Profile profile;
    bool view_test = false;    ///< with it vertex_transform
    bool normal_test = false;  ///< needs bump
    bool height_test = false;  ///< with it the summed-area table
    bool bump = false;         ///< with it the normal map
    int contexts = 1;          ///< 1 to 32: triangles in flight; they set the time, not the values
    double clock_period_ns = 2.0;

    /// The smallest device that can do what both can; the profile and clock are this one's.
    void include(const DeviceConfig& other) {
        view_test |= other.view_test;
        normal_test |= other.normal_test;
        height_test |= other.height_test;
        bump |= other.bump | other.normal_test;
        contexts = contexts > other.contexts ? contexts : other.contexts;
    }

    /// Every optional unit, called for or not.
    void include_everything() { view_test = normal_test = height_test = bump = true; }
};

/// The units that a device is built from, in pipeline order.
std::vector<std::string_view> elaborated_units(const DeviceConfig& config);

/// The units of adaptive tessellation that it goes without.
std::vector<std::string_view> omitted_units(const DeviceConfig& config);

}  // namespace repousse
