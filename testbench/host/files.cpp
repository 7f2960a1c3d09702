#include "testbench/host/files.h"

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace repousse::host {
namespace {

namespace fs = std::filesystem;

Error environment(const std::string& path, const std::string& what) {
    return {ErrorKind::Environment, path, what, "", ""};
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::uint64_t limit_bytes) {
    std::error_code code;
    const auto kind = fs::status(path, code).type();
    if (kind == fs::file_type::not_found) {
        return Error{ErrorKind::Input, path, "no such file", "a readable file", ""};
    }
    if (kind == fs::file_type::directory) {
        return Error{ErrorKind::Input, path, "is a folder", "a file", ""};
    }
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        return Error{ErrorKind::Input, path, std::string("cannot be read: ") + std::strerror(errno),
                     "a readable file", ""};
    }
    // Read in chunks instead of trusting a size: pipes and special files have none.
    std::string bytes;
    char chunk[1 << 16];
    std::size_t count = 0;
    bool too_large = false;
    while (!too_large && (count = std::fread(chunk, 1, sizeof chunk, file)) > 0) {
        too_large = bytes.size() + count > limit_bytes;
        if (!too_large) bytes.append(chunk, count);
    }
    const bool failed = std::ferror(file) != 0;
    std::fclose(file);
    if (too_large) {
        return Error{ErrorKind::Input, path, "the file is too large",
                     "at most " + std::to_string(limit_bytes) + " bytes", ""};
    }
    if (failed) return environment(path, "reading failed before the end of the file");
    return bytes;
}

Status write_file(const std::string& path, const std::string& bytes) {
    const std::string part = path + ".part";
    std::FILE* file = std::fopen(part.c_str(), "wb");
    if (file == nullptr) {
        return environment(part, std::string("cannot be written: ") + std::strerror(errno));
    }
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const bool closed = std::fclose(file) == 0;
    std::error_code code;
    if (written && closed) fs::rename(part, path, code);
    if (!written || !closed || code) {
        std::error_code ignored;
        fs::remove(part, ignored);
        return environment(path, code ? "cannot be replaced: " + code.message()
                                      : "writing failed (is the disk full?)");
    }
    return done();
}

bool is_file(const std::string& path) {
    std::error_code code;
    return fs::is_regular_file(path, code);
}

std::string resolve_file(const std::string& path, const std::string& folder) {
    const fs::path given(path);
    if (given.is_absolute()) return is_file(path) ? path : std::string();
    const std::string beside = (fs::path(folder) / given).lexically_normal().string();
    if (is_file(beside)) return beside;
    return is_file(path) ? path : std::string();
}

std::string extension_of(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

std::string folder_of(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace repousse::host
