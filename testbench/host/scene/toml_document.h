#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace repousse::host {

struct TomlEntry;

/// A TOML value with its place in the file. Our own plain tree, so that toml++ (40,000 lines of
/// templates) is compiled in one place and its exceptions and node types stay there.
struct TomlValue {
    enum class Kind { Table, Array, String, Integer, Float, Boolean, Date };

    Kind kind = Kind::Table;
    int line = 0;
    int column = 0;
    std::string string;              ///< Kind::String
    std::int64_t integer = 0;        ///< Kind::Integer
    double number = 0.0;             ///< Kind::Float and Kind::Integer
    bool boolean = false;            ///< Kind::Boolean
    std::vector<TomlValue> items;    ///< Kind::Array
    std::vector<TomlEntry> entries;  ///< Kind::Table, in the order of the file

    /// The value of a key of a table; null when it is absent.
    const TomlValue* find(const std::string& key) const;
    /// "a table", "a string", ...: the kind in the words of a message.
    const char* kind_name() const;
};

struct TomlEntry {
    std::string key;
    int line = 0;  ///< of the key
    int column = 0;
    TomlValue value;
};

/// Parses TOML 1.0 text. Errors: `name:line:column: ...`.
Result<TomlValue> parse_toml(const std::string& text, const std::string& name);

}  // namespace repousse::host
