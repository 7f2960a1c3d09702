#include "testbench/host/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "testbench/host/mesh/text_reader.h"

namespace repousse::host {
namespace {

constexpr std::int64_t kMostElements = 0x7FFFFFFF;
constexpr const char* kTypes = "char, uchar, short, ushort, int, uint, float or double";

std::optional<PlyType> type_named(std::string_view word) {
    static const std::array<std::pair<const char*, PlyType>, 16> kNames{
        {{"char", PlyType::Int8},
         {"int8", PlyType::Int8},
         {"uchar", PlyType::Uint8},
         {"uint8", PlyType::Uint8},
         {"short", PlyType::Int16},
         {"int16", PlyType::Int16},
         {"ushort", PlyType::Uint16},
         {"uint16", PlyType::Uint16},
         {"int", PlyType::Int32},
         {"int32", PlyType::Int32},
         {"uint", PlyType::Uint32},
         {"uint32", PlyType::Uint32},
         {"float", PlyType::Float},
         {"float32", PlyType::Float},
         {"double", PlyType::Double},
         {"float64", PlyType::Double}}};
    for (const auto& [name, type] : kNames) {
        if (word == name) return type;
    }
    return std::nullopt;
}

Result<PlyFormat> read_format(TextReader& text) {
    const std::string_view word = text.in_line();
    if (word == "ascii") return PlyFormat::Ascii;
    if (word == "binary_little_endian") return PlyFormat::LittleEndian;
    if (word == "binary_big_endian") return PlyFormat::BigEndian;
    return text.error("unknown format \"" + std::string(word) + "\"",
                      "ascii, binary_little_endian or binary_big_endian");
}

Result<PlyElement> read_element(TextReader& text) {
    PlyElement element;
    element.name = std::string(text.in_line());
    if (element.name.empty()) return text.error("an element without a name", "vertex or face");
    const Result<std::int64_t> count = text.integer("an element count", 0, kMostElements);
    if (!count.ok()) return count.error();
    element.count = *count;
    return element;
}

Result<PlyProperty> read_property(TextReader& text) {
    PlyProperty property;
    std::string word(text.in_line());
    property.list = word == "list";
    if (property.list) {
        const std::string count(text.in_line());
        const auto type = type_named(count);
        if (!type || *type == PlyType::Float || *type == PlyType::Double) {
            return text.error("unknown list count type \"" + count + "\"", "an integer type");
        }
        property.count_type = *type;
        word = std::string(text.in_line());
    }
    const auto type = type_named(word);
    if (!type) return text.error("unknown property type \"" + word + "\"", kTypes);
    property.type = *type;
    property.name = std::string(text.in_line());
    if (property.name.empty()) return text.error("a property without a name", "a name");
    return property;
}

/// Total of the smallest sizes; an element that claims more than the file can hold is named here,
/// before anything of that size is allocated.
Status check_sizes(const PlyHeader& header, std::size_t file_bytes, const std::string& name) {
    std::size_t left = file_bytes - header.size_bytes + 1;  // a last line may lack its end
    for (const PlyElement& element : header.elements) {
        const std::size_t each = element.least_bytes(header.format);
        const auto count = static_cast<std::size_t>(element.count);
        if (each > 0 && count > left / each) {
            return Error{ErrorKind::Input, name + ": offset " + std::to_string(header.size_bytes),
                         "the header claims " + std::to_string(count) + " " + element.name +
                             " elements of at least " + std::to_string(each) + " bytes, but " +
                             std::to_string(left - 1) + " bytes follow",
                         "a complete file", ""};
        }
        left -= each * count;
    }
    return done();
}

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::Uint8:
            return 1;
        case PlyType::Int16:
        case PlyType::Uint16:
            return 2;
        case PlyType::Int32:
        case PlyType::Uint32:
        case PlyType::Float:
            return 4;
        case PlyType::Double:
            return 8;
    }
    return 1;
}

int PlyElement::find(const std::vector<std::string>& names) const {
    for (std::size_t i = 0; i < properties.size(); ++i) {
        if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

std::size_t PlyElement::least_bytes(PlyFormat format) const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties) {
        // In text a value is one digit and one separator.
        if (format == PlyFormat::Ascii) {
            bytes += 2;
        } else {
            bytes += size_of(property.list ? property.count_type : property.type);
        }
    }
    return bytes;
}

Result<PlyHeader> read_ply_header(const std::string& bytes, const std::string& name) {
    TextReader text(bytes, name);
    PlyHeader header;
    if (text.in_line() != "ply") return text.error("this is no PLY file", "\"ply\" on line 1");
    bool has_format = false;
    int line = 1;
    while (text.skip_line()) {
        ++line;
        const std::string word(text.in_line());
        if (word == "format") {
            const Result<PlyFormat> format = read_format(text);
            if (!format.ok()) return format.error();
            header.format = *format;
            has_format = true;
        } else if (word == "element") {
            const Result<PlyElement> element = read_element(text);
            if (!element.ok()) return element.error();
            header.elements.push_back(*element);
        } else if (word == "property") {
            if (header.elements.empty())
                return text.error("a property before any element", "element");
            const Result<PlyProperty> property = read_property(text);
            if (!property.ok()) return property.error();
            header.elements.back().properties.push_back(*property);
        } else if (word == "end_header") {
            if (!has_format) return text.error("the header names no format", "a format line");
            text.skip_line();
            header.size_bytes = text.offset();
            header.lines = line;
            const Status status = check_sizes(header, bytes.size(), name);
            if (!status.ok()) return status.error();
            return header;
        } else if (!word.empty() && word != "comment" && word != "obj_info") {
            return text.error("unknown header word \"" + word.substr(0, 32) + "\"",
                              "format, element, property, comment or end_header");
        }
    }
    return text.error("the header does not end", "end_header");
}

}  // namespace repousse::host
