#include "testbench/host/map/zip_archive.h"

#include <algorithm>
#include <optional>

#include <zlib.h>

namespace repousse::host {
namespace {

constexpr std::uint32_t kEndSignature = 0x06054B50;
constexpr std::uint32_t kEntrySignature = 0x02014B50;
constexpr std::uint32_t kLocalSignature = 0x04034B50;
constexpr std::size_t kEndSize = 22;
constexpr std::size_t kEntrySize = 46;
constexpr std::size_t kLocalSize = 30;
constexpr std::size_t kLongestComment = 65535;

/// A little-endian number of 2 or 4 bytes; the caller has checked that it is inside.
std::uint32_t little(const std::string& bytes, std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = count - 1; i >= 0; --i) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
    }
    return value;
}

struct Reader {
    const std::string& bytes;
    const std::string& name;

    bool inside(std::size_t at, std::size_t count) const {
        return at <= bytes.size() && count <= bytes.size() - at;
    }
    Error error(std::size_t at, std::string what, std::string expected) const {
        return {ErrorKind::Input, name + ": offset " + std::to_string(at), std::move(what),
                std::move(expected), ""};
    }
};

/// What the central directory says of a member.
struct Entry {
    std::uint32_t flags = 0;
    std::uint32_t method = 0;
    std::uint32_t crc = 0;
    std::uint32_t packed = 0;
    std::uint32_t unpacked = 0;
    std::uint32_t local = 0;
};

/// The end record is the last thing in the file but for a comment of at most 65535 bytes.
std::optional<std::size_t> find_end(const std::string& bytes) {
    if (bytes.size() < kEndSize) return std::nullopt;
    const std::size_t last = bytes.size() - kEndSize;
    const std::size_t first = last > kLongestComment ? last - kLongestComment : 0;
    for (std::size_t at = last + 1; at-- > first;) {
        if (little(bytes, at, 4) == kEndSignature) return at;
    }
    return std::nullopt;
}

Result<Entry> find_entry(const Reader& in, const std::string& member) {
    const std::optional<std::size_t> end = find_end(in.bytes);
    if (!end) {
        return in.error(in.bytes.size(), "this is no ZIP archive, or a truncated one",
                        "an end-of-directory record");
    }
    const std::uint32_t count = little(in.bytes, *end + 10, 2);
    std::size_t at = little(in.bytes, *end + 16, 4);
    std::string members;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!in.inside(at, kEntrySize) || little(in.bytes, at, 4) != kEntrySignature) {
            return in.error(at, "the ZIP directory is damaged", "a directory entry");
        }
        const std::size_t name_size = little(in.bytes, at + 28, 2);
        const std::size_t skip =
            name_size + little(in.bytes, at + 30, 2) + little(in.bytes, at + 32, 2);
        if (!in.inside(at + kEntrySize, skip)) {
            return in.error(at, "the ZIP directory is damaged", "a complete directory entry");
        }
        const std::string found = in.bytes.substr(at + kEntrySize, name_size);
        if (found == member) {
            return Entry{little(in.bytes, at + 8, 2),  little(in.bytes, at + 10, 2),
                         little(in.bytes, at + 16, 4), little(in.bytes, at + 20, 4),
                         little(in.bytes, at + 24, 4), little(in.bytes, at + 42, 4)};
        }
        members += (members.empty() ? "" : ", ") + found;
        at += kEntrySize + skip;
    }
    return in.error(at, "the archive has no member \"" + member + "\"",
                    "it among: " + (members.empty() ? "(none)" : members));
}

/// Raw deflate, into a buffer of exactly the size that the directory claims.
bool inflate_to(const char* from, std::uint32_t packed, std::string& to) {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return false;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from));
    stream.avail_in = packed;
    stream.next_out = reinterpret_cast<Bytef*>(&to[0]);
    stream.avail_out = static_cast<uInt>(to.size());
    const int state = inflate(&stream, Z_FINISH);
    const bool whole = state == Z_STREAM_END && stream.total_out == to.size();
    inflateEnd(&stream);
    return whole;
}

}  // namespace

Result<std::string> read_zip_member(const std::string& archive, const std::string& member,
                                    std::uint64_t limit_bytes, const std::string& name) {
    const Reader in{archive, name};
    const Result<Entry> entry = find_entry(in, member);
    if (!entry.ok()) return entry.error();
    const std::size_t local = entry->local;
    if (!in.inside(local, kLocalSize) || little(archive, local, 4) != kLocalSignature) {
        return in.error(local, "the ZIP member's own header is missing", "a local header");
    }
    if ((entry->flags & 1u) != 0)
        return in.error(local, "the ZIP member is encrypted", "plain data");
    if (entry->method != 0 && entry->method != 8) {
        return in.error(local, "ZIP method " + std::to_string(entry->method) + " is not read",
                        "stored (0) or deflated (8)");
    }
    if (entry->unpacked > limit_bytes) {
        return in.error(local,
                        "the ZIP member claims " + std::to_string(entry->unpacked) + " bytes",
                        "at most " + std::to_string(limit_bytes));
    }
    const std::size_t data =
        local + kLocalSize + little(archive, local + 26, 2) + little(archive, local + 28, 2);
    // Deflate shrinks to no less than 1/1032, so a larger claim is false.
    const bool possible = entry->method == 0 ? entry->packed == entry->unpacked
                                             : entry->unpacked / 1033 <= entry->packed;
    if (!in.inside(data, entry->packed) || !possible) {
        return in.error(data, "the ZIP member is truncated or its size is wrong",
                        std::to_string(entry->packed) + " bytes of data");
    }
    std::string bytes(entry->unpacked, '\0');
    if (entry->method == 0) {
        bytes.assign(archive, data, entry->packed);
    } else if (!bytes.empty() && !inflate_to(archive.data() + data, entry->packed, bytes)) {
        return in.error(data, "the ZIP member's compressed data is damaged", "a deflate stream");
    }
    const auto crc = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), entry->unpacked);
    if (crc != entry->crc) return in.error(data, "the ZIP member's CRC is wrong", "intact data");
    return bytes;
}

}  // namespace repousse::host
