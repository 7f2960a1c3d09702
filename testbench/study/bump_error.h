#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/profile.h"

namespace repousse::study {

/// The angle between N' of the device and the same in double, by the kind of bump.
struct BumpError {
    std::string profile;
    int normalise_kind = 0;
    int bump_kind = 0;
    double max_deg = 0;  ///< of the unit itself: against double, of the same texel
    double rms_deg = 0;
    double map_max_deg = 0;  ///< against the normal of the heights: a stored texel's rounding too
    double map_rms_deg = 0;
    double square_length = 0;  ///< most that |v| differs from 1 in frames at right angles
    double mean_length = 0;    ///< the same half-way between two frames up to 30 degrees apart
};

/// `count` vertices with frames at right angles and slopes of up to 60 degrees, on heights of the
/// profile's format; the profile says both kinds.
BumpError bump_error(const char* name, const Profile& profile, int count, uint64_t seed);

/// The section of docs/normalise.md.
std::string bump_markdown(const std::vector<BumpError>& errors);

}  // namespace repousse::study
