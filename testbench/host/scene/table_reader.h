#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "datapath/error.h"
#include "testbench/host/scene/scene.h"
#include "testbench/host/scene/toml_document.h"

namespace repousse::host {

/// What all readers of one scene share: its name, and the first error. After an error the
/// readers go on with fallback values and change nothing, so callers check once at the end.
struct ReadContext {
    std::string file;
    std::string folder;
    std::optional<Error> error;
    std::vector<std::string> notes;

    SceneMark mark(int line, int column) const { return {file, line, column}; }
    void fail(const SceneMark& at, std::string what, std::string expected, std::string advice = "");
};

/// Reads the keys of one table with their types and ranges, remembers which were asked for, and
/// refuses the others. A missing key gives the fallback; a wrong one records an error that says
/// what was found and what was expected.
class TableReader {
public:
    /// `name` is the table as a person writes it, e.g. "object.map".
    TableReader(const TomlValue& table, std::string name, ReadContext& context);

    bool has(const std::string& key);
    /// Asks for a key that must be there. Its absence is reported by `finish`, after unknown keys:
    /// a misspelt key is better news than a missing one.
    void require(const std::string& key, const std::string& expected);

    /// Numbers: low <= value <= high; NaN and infinity are refused.
    double number(const std::string& key, double fallback, double low, double high);
    std::optional<double> optional_number(const std::string& key, double low, double high);
    int integer(const std::string& key, int fallback, int low, int high);
    bool boolean(const std::string& key, bool fallback);
    std::string text(const std::string& key, const std::string& fallback);
    /// One of `names`; the result is its index.
    int choice(const std::string& key, const std::vector<std::string>& names, int fallback);

    /// Arrays of exactly `count` numbers, each within low..high; empty when absent or wrong.
    std::vector<double> numbers(const std::string& key, std::size_t count, double low, double high);
    glm::dvec3 vector3(const std::string& key, glm::dvec3 fallback, double low, double high);
    glm::dvec2 vector2(const std::string& key, glm::dvec2 fallback, double low, double high);
    std::vector<int> integers(const std::string& key, std::size_t count, int low, int high);

    /// A table below this one; null when absent.
    const TomlValue* table(const std::string& key);
    /// The tables of an array of tables ([[key]]); empty when absent.
    std::vector<const TomlValue*> tables(const std::string& key);

    /// The place of a key's value, or of the table when the key is absent.
    SceneMark mark(const std::string& key) const;
    SceneMark mark() const;
    /// Records an error at a key's value.
    void fail(const std::string& key, std::string what, std::string expected,
              std::string advice = "");

    /// Refuses every key that nobody asked for, with the nearest known one as a suggestion, then
    /// every required key that is missing.
    void finish();

private:
    const TomlValue* value(const std::string& key);
    const TomlValue* value(const std::string& key, TomlValue::Kind kind, const char* expected);
    bool check(const std::string& key, const TomlValue& item, double low, double high);
    std::string label(const std::string& key) const;

    const TomlValue& table_;
    std::string name_;
    ReadContext& context_;
    std::set<std::string> known_;
    std::vector<std::pair<std::string, std::string>> missing_;  // key, what was expected
};

/// The member of `names` that is nearest to `word` by edit distance, empty when none is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& names);

/// Shortest decimal text of a number that reads back the same ("0.2", "4096").
std::string number_text(double value);

}  // namespace repousse::host
