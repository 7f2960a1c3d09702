#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/unit_desc.h"

namespace repousse::cosim {

/// The descriptions of all units.
std::vector<const UnitDesc*> unit_descriptions();

/// The Verilog parameters of a unit with a profile's values as defaults: what
/// rtl/units/NAME_params.svh holds.
std::string verilog_parameters(const UnitDesc& desc, const Profile& profile);

/// The tables of a unit's sheet, in Markdown: its ports with their formats, the profile entries
/// that it uses, its timing.
std::string sheet_tables(const UnitDesc& desc, const Profile& profile);

/// A file that is made from a description, wholly or between markers.
struct PrintedFile {
    std::filesystem::path path;  ///< relative to the repository's root
    std::string text;
    bool is_stale = false;  ///< what is on disk differs
};

/// Everything that descriptions are printed into, below `root`: the parameters of units that have
/// RTL, and the tables between the two marker lines of the sheets that exist.
Result<std::vector<PrintedFile>> print_descriptions(const std::filesystem::path& root,
                                                    const Profile& profile);

/// The lines between which a sheet's tables stand.
inline constexpr const char* kTablesBegin = "<!-- printed from the description -->";
inline constexpr const char* kTablesEnd = "<!-- end of what is printed -->";

}  // namespace repousse::cosim
