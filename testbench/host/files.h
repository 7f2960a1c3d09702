#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace repousse::host {

/// The whole content of a file. Errors: kind Input when it is missing, a folder or unreadable.
/// `limit_bytes` bounds what is read into memory; a larger file is an Input error.
Result<std::string> read_file(const std::string& path, std::uint64_t limit_bytes = 1ull << 32);

/// Writes `bytes` to `path` by way of `path` + ".part" and a rename, so that a reader (or a run
/// that fails) never sees half a file. Errors: kind Environment (disk full, no such folder).
Status write_file(const std::string& path, const std::string& bytes);

/// True when `path` names an existing regular file.
bool is_file(const std::string& path);

/// The file that a scene means by `path`: an absolute path as it is, a relative one beside the
/// scene first (`folder`), then below the working directory. Empty when neither exists.
std::string resolve_file(const std::string& path, const std::string& folder);

/// Lower-case extension with its dot (".ply"), empty without one.
std::string extension_of(const std::string& path);

/// Folder part of a path, "." without one.
std::string folder_of(const std::string& path);

}  // namespace repousse::host
