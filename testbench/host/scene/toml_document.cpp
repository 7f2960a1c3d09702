#include "testbench/host/scene/toml_document.h"

#include <algorithm>

#include <toml++/toml.h>

namespace repousse::host {
namespace {

TomlValue convert(const toml::node& node);

TomlValue convert_table(const toml::table& table) {
    TomlValue value;
    for (const auto& [key, child] : table) {
        TomlEntry entry;
        entry.key = std::string(key.str());
        entry.line = static_cast<int>(key.source().begin.line);
        entry.column = static_cast<int>(key.source().begin.column);
        entry.value = convert(child);
        value.entries.push_back(std::move(entry));
    }
    // toml++ sorts by name; messages should follow the file.
    std::stable_sort(value.entries.begin(), value.entries.end(),
                     [](const TomlEntry& a, const TomlEntry& b) {
                         return a.line != b.line ? a.line < b.line : a.column < b.column;
                     });
    return value;
}

TomlValue convert(const toml::node& node) {
    TomlValue value;
    if (const toml::table* table = node.as_table()) {
        value = convert_table(*table);
    } else if (const toml::array* array = node.as_array()) {
        value.kind = TomlValue::Kind::Array;
        for (const toml::node& item : *array) value.items.push_back(convert(item));
    } else if (const auto* text = node.as_string()) {
        value.kind = TomlValue::Kind::String;
        value.string = text->get();
    } else if (const auto* integer = node.as_integer()) {
        value.kind = TomlValue::Kind::Integer;
        value.integer = integer->get();
        value.number = static_cast<double>(integer->get());
    } else if (const auto* number = node.as_floating_point()) {
        value.kind = TomlValue::Kind::Float;
        value.number = number->get();
    } else if (const auto* boolean = node.as_boolean()) {
        value.kind = TomlValue::Kind::Boolean;
        value.boolean = boolean->get();
    } else {
        value.kind = TomlValue::Kind::Date;
    }
    value.line = static_cast<int>(node.source().begin.line);
    value.column = static_cast<int>(node.source().begin.column);
    return value;
}

}  // namespace

const TomlValue* TomlValue::find(const std::string& key) const {
    for (const TomlEntry& entry : entries) {
        if (entry.key == key) return &entry.value;
    }
    return nullptr;
}

const char* TomlValue::kind_name() const {
    switch (kind) {
        case Kind::Table:
            return "a table";
        case Kind::Array:
            return "an array";
        case Kind::String:
            return "a string";
        case Kind::Integer:
            return "an integer";
        case Kind::Float:
            return "a number";
        case Kind::Boolean:
            return "a boolean";
        case Kind::Date:
            return "a date or time";
    }
    return "a value";
}

Result<TomlValue> parse_toml(const std::string& text, const std::string& name) {
    const toml::parse_result result = toml::parse(text, name);
    if (!result) {
        const toml::parse_error& error = result.error();
        const auto& at = error.source().begin;
        const std::string where =
            name + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
        return Error{ErrorKind::Input, where, std::string(error.description()), "TOML 1.0", ""};
    }
    return convert_table(result.table());
}

}  // namespace repousse::host
