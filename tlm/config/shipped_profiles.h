#pragma once

#include <string_view>

#include "datapath/span.h"

namespace repousse {

/// A profile's TOML text, embedded by the build from tlm/config/profiles/NAME.toml.
struct ShippedProfile {
    std::string_view name;
    std::string_view toml;
};

/// All embedded profiles, "default" first, then by name.
Span<const ShippedProfile> shipped_profiles();

}  // namespace repousse
