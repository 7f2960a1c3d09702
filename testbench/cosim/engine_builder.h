#pragma once

#include <filesystem>
#include <string>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/unit_desc.h"

namespace repousse::cosim {

/// Where this checkout is: the folder with rtl/, vectors/ and testbench/. $REPOUSSE_SOURCE_DIR, or
/// where the program was built.
std::filesystem::path source_folder();

/// Where engines are kept: $REPOUSSE_CACHE_DIR, or ~/.cache/repousse.
std::filesystem::path cache_folder();

/// Where a unit's RTL lies: rtl/units, or rtl/tops for a top made of units.
std::string rtl_folder(const UnitDesc& desc);

/// The RTL files of a unit below `root`, as paths relative to it: rtl/common, and every file of
/// rtl/units whose name begins with the unit's; for a top, that of its units, and its own.
Result<std::vector<std::string>> rtl_files(const std::filesystem::path& root, const UnitDesc& desc);

/// Makes a unit's RTL below `root` into an engine for a profile, with Verilator and a C++ compiler
/// ($CXX, else clang++ if it is there, else c++), unless the cache has it already: engines are
/// found again by a hash of all sources, parameters, flags and tool versions. Returns the shared
/// object's path. Takes 5 to 20 seconds when it builds. Missing tools and failing builds are
/// Environment errors.
Result<std::filesystem::path> build_engine(const UnitDesc& desc, const Profile& profile,
                                           const std::filesystem::path& root);

}  // namespace repousse::cosim
