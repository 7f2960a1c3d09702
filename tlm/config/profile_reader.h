#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"

namespace repousse {

/// Reads a profile from TOML text: one `key = value` a line, values as strings (formats) or
/// integers. Errors carry `name:line:column`.
Result<Profile> parse_profile(std::string_view toml_text, const std::string& name);

/// Reads a profile from a file; a missing or unreadable file is an input error.
Result<Profile> read_profile(const std::string& path);

/// Names of the profiles that are compiled into the program, "default" first.
std::vector<std::string_view> shipped_profile_names();

/// A profile that is compiled into the program.
Result<Profile> shipped_profile(std::string_view name);

/// What `--profile` and a scene's `profile` key mean: a shipped name, else a file.
Result<Profile> find_profile(const std::string& name_or_path);

}  // namespace repousse
