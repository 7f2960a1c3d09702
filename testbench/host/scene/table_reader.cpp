#include "testbench/host/scene/table_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace repousse::host {
namespace {

/// Levenshtein distance, one row at a time.
std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

std::string quoted_list(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += "\"" + names[i] + "\"";
    }
    return text;
}

std::string range_text(double low, double high) {
    return number_text(low) + ".." + number_text(high);
}

}  // namespace

void ReadContext::fail(const SceneMark& at, std::string what, std::string expected,
                       std::string advice) {
    if (error) return;
    error =
        Error{ErrorKind::Input, at.text(), std::move(what), std::move(expected), std::move(advice)};
}

std::string nearest_word(const std::string& word, const std::vector<std::string>& names) {
    std::string best;
    std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string& name : names) {
        const std::size_t distance = edit_distance(word, name);
        if (distance < best_distance) {
            best_distance = distance;
            best = name;
        }
    }
    return best;
}

std::string number_text(double value) { return fmt::format("{}", value); }

TableReader::TableReader(const TomlValue& table, std::string name, ReadContext& context)
    : table_(table), name_(std::move(name)), context_(context) {}

std::string TableReader::label(const std::string& key) const {
    return name_.empty() ? key : name_ + "." + key;
}

const TomlValue* TableReader::value(const std::string& key) {
    known_.insert(key);
    return table_.find(key);
}

const TomlValue* TableReader::value(const std::string& key, TomlValue::Kind kind,
                                    const char* expected) {
    const TomlValue* found = value(key);
    if (found == nullptr || found->kind == kind) return found;
    fail(key, label(key) + " is " + found->kind_name(), expected);
    return nullptr;
}

bool TableReader::has(const std::string& key) { return value(key) != nullptr; }

void TableReader::require(const std::string& key, const std::string& expected) {
    if (value(key) == nullptr) missing_.push_back({key, expected});
}

bool TableReader::check(const std::string& key, const TomlValue& item, double low, double high) {
    const SceneMark at = context_.mark(item.line, item.column);
    const bool numeric =
        item.kind == TomlValue::Kind::Integer || item.kind == TomlValue::Kind::Float;
    if (!numeric) {
        context_.fail(at, label(key) + " holds " + item.kind_name(),
                      "a number in " + range_text(low, high));
        return false;
    }
    // Written so that NaN fails too.
    if (!(item.number >= low && item.number <= high)) {
        context_.fail(at, label(key) + " is " + number_text(item.number),
                      "a number in " + range_text(low, high));
        return false;
    }
    return true;
}

double TableReader::number(const std::string& key, double fallback, double low, double high) {
    return optional_number(key, low, high).value_or(fallback);
}

std::optional<double> TableReader::optional_number(const std::string& key, double low,
                                                   double high) {
    const TomlValue* found = value(key);
    if (found == nullptr || !check(key, *found, low, high)) return std::nullopt;
    return found->number;
}

int TableReader::integer(const std::string& key, int fallback, int low, int high) {
    const std::string expected = "an integer in " + range_text(low, high);
    const TomlValue* found = value(key, TomlValue::Kind::Integer, expected.c_str());
    if (found == nullptr) return fallback;
    if (found->integer < low || found->integer > high) {
        fail(key, label(key) + " is " + std::to_string(found->integer), expected);
        return fallback;
    }
    return static_cast<int>(found->integer);
}

bool TableReader::boolean(const std::string& key, bool fallback) {
    const TomlValue* found = value(key, TomlValue::Kind::Boolean, "true or false");
    return found != nullptr ? found->boolean : fallback;
}

std::string TableReader::text(const std::string& key, const std::string& fallback) {
    const TomlValue* found = value(key, TomlValue::Kind::String, "a string");
    return found != nullptr ? found->string : fallback;
}

int TableReader::choice(const std::string& key, const std::vector<std::string>& names,
                        int fallback) {
    const std::string expected = quoted_list(names);
    const TomlValue* found = value(key, TomlValue::Kind::String, expected.c_str());
    if (found == nullptr) return fallback;
    const auto place = std::find(names.begin(), names.end(), found->string);
    if (place != names.end()) return static_cast<int>(place - names.begin());
    const std::string near = nearest_word(found->string, names);
    fail(key, label(key) + " is \"" + found->string + "\"", expected,
         near.empty() ? "" : "did you mean \"" + near + "\"?");
    return fallback;
}

std::vector<double> TableReader::numbers(const std::string& key, std::size_t count, double low,
                                         double high) {
    const std::string expected =
        "an array of " + std::to_string(count) + " numbers in " + range_text(low, high);
    const TomlValue* found = value(key, TomlValue::Kind::Array, expected.c_str());
    if (found == nullptr) return {};
    if (found->items.size() != count) {
        fail(key, label(key) + " has " + std::to_string(found->items.size()) + " items", expected);
        return {};
    }
    std::vector<double> result;
    for (const TomlValue& item : found->items) {
        if (!check(key, item, low, high)) return {};
        result.push_back(item.number);
    }
    return result;
}

glm::dvec3 TableReader::vector3(const std::string& key, glm::dvec3 fallback, double low,
                                double high) {
    const std::vector<double> v = numbers(key, 3, low, high);
    return v.empty() ? fallback : glm::dvec3(v[0], v[1], v[2]);
}

glm::dvec2 TableReader::vector2(const std::string& key, glm::dvec2 fallback, double low,
                                double high) {
    const std::vector<double> v = numbers(key, 2, low, high);
    return v.empty() ? fallback : glm::dvec2(v[0], v[1]);
}

std::vector<int> TableReader::integers(const std::string& key, std::size_t count, int low,
                                       int high) {
    const std::vector<double> found = numbers(key, count, low, high);
    std::vector<int> result;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const TomlValue& item = table_.find(key)->items[i];
        if (item.kind != TomlValue::Kind::Integer) {
            context_.fail(context_.mark(item.line, item.column),
                          label(key) + " holds " + number_text(item.number),
                          "an integer in " + range_text(low, high));
            return {};
        }
        result.push_back(static_cast<int>(item.integer));
    }
    return result;
}

const TomlValue* TableReader::table(const std::string& key) {
    return value(key, TomlValue::Kind::Table, "a table");
}

std::vector<const TomlValue*> TableReader::tables(const std::string& key) {
    const std::string expected = "an array of tables, [[" + label(key) + "]]";
    const TomlValue* found = value(key, TomlValue::Kind::Array, expected.c_str());
    std::vector<const TomlValue*> result;
    if (found == nullptr) return result;
    for (const TomlValue& item : found->items) {
        if (item.kind != TomlValue::Kind::Table) {
            context_.fail(context_.mark(item.line, item.column),
                          label(key) + " holds " + item.kind_name(), expected);
            return {};
        }
        result.push_back(&item);
    }
    return result;
}

SceneMark TableReader::mark() const { return context_.mark(table_.line, table_.column); }

SceneMark TableReader::mark(const std::string& key) const {
    const TomlValue* found = table_.find(key);
    return found != nullptr ? context_.mark(found->line, found->column) : mark();
}

void TableReader::fail(const std::string& key, std::string what, std::string expected,
                       std::string advice) {
    context_.fail(mark(key), std::move(what), std::move(expected), std::move(advice));
}

void TableReader::finish() {
    const std::vector<std::string> names(known_.begin(), known_.end());
    for (const TomlEntry& entry : table_.entries) {
        if (known_.count(entry.key) > 0) continue;
        const std::string near = nearest_word(entry.key, names);
        std::string expected = "one of";
        for (const std::string& name : names) expected += (&name == &names[0] ? " " : ", ") + name;
        context_.fail(
            context_.mark(entry.line, entry.column),
            "unknown key \"" + entry.key + "\"" + (name_.empty() ? "" : " in [" + name_ + "]"),
            expected, near.empty() ? "" : "did you mean \"" + near + "\"?");
    }
    for (const auto& [key, expected] : missing_) {
        context_.fail(mark(), label(key) + " is missing", expected);
    }
}

}  // namespace repousse::host
