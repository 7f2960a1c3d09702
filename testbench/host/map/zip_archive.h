#pragma once

#include <cstdint>
#include <string>

#include "datapath/error.h"

namespace repousse::host {

/// One member of a ZIP archive, unpacked. Reads stored and deflated members by way of the central
/// directory (APPNOTE 6.3.9), checks the CRC, and refuses encrypted, ZIP64 and split archives.
/// `limit_bytes` bounds the unpacked size before anything is allocated.
/// Errors: `name: offset N: ...`; an absent member is an error that lists the members.
Result<std::string> read_zip_member(const std::string& archive, const std::string& member,
                                    std::uint64_t limit_bytes, const std::string& name);

}  // namespace repousse::host
