#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace repousse::host {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float;  ///< of the value, or of a list's items
    bool list = false;
    PlyType count_type = PlyType::Uint8;
};

struct PlyElement {
    std::string name;
    std::int64_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of the first property with one of these names, -1 without one.
    int find(const std::vector<std::string>& names) const;
    /// The fewest bytes that one element can take in the body.
    std::size_t least_bytes(PlyFormat format) const;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size_bytes = 0;  ///< the body starts here
    int lines = 0;               ///< lines of the header, for messages about an ascii body
};

/// Parses the header and checks that each element's count can be held by the rest of the file.
/// Errors: file:line:column.
Result<PlyHeader> read_ply_header(const std::string& bytes, const std::string& name);

}  // namespace repousse::host
