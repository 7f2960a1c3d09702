#include "testbench/host/map/json_reader.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

namespace repousse::host {
namespace {

using Json = nlohmann::json;

Error bad(const std::string& where, std::string what, std::string expected) {
    return {ErrorKind::Input, where, std::move(what), std::move(expected), ""};
}

/// Line and column of the byte before which a parser stopped (it counts from 1).
std::string place(const std::string& text, std::size_t byte) {
    const std::size_t end = std::min(byte > 0 ? byte - 1 : 0, text.size());
    const auto head = text.begin() + static_cast<std::ptrdiff_t>(end);
    const std::size_t start = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
    return std::to_string(1 + std::count(text.begin(), head, '\n')) + ":" +
           std::to_string(start == std::string::npos ? end + 1 : end - start);
}

/// A side of the grid, if the member is one.
std::optional<int> side(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_integer()) return std::nullopt;
    const auto value = found->get<std::int64_t>();
    if (value < 1 || value > kMaxMapSide) return std::nullopt;
    return static_cast<int>(value);
}

}  // namespace

Result<ElevationGrid> read_json_grid(const std::string& text, const std::string& name) {
    Json json;
    try {
        json = Json::parse(text);
    } catch (const Json::parse_error& error) {
        return bad(name + ":" + place(text, error.byte), "this is no JSON", "an elevation grid");
    } catch (const Json::exception&) {  // a number beyond double's range
        return bad(name, "a number in the JSON cannot be read", "an elevation grid");
    }
    if (!json.is_object()) {
        return bad(name, "the JSON is no object",
                   R"({"width": ..., "height": ..., "values": ...})");
    }
    ElevationGrid grid;
    for (const auto& [key, size] : {std::pair{"width", &grid.width}, {"height", &grid.height}}) {
        const std::optional<int> value = side(json, key);
        if (!value) {
            return bad(name, std::string("\"") + key + "\" is no size",
                       "an integer of 1.." + std::to_string(kMaxMapSide));
        }
        *size = *value;
    }
    const auto count = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    const auto values = json.find("values");
    if (values == json.end() || !values->is_array() || values->size() != count) {
        return bad(name, "\"values\" is no array of width x height",
                   std::to_string(count) + " numbers");
    }
    grid.samples.reserve(count);
    for (const Json& value : *values) {
        if (!value.is_number() && !value.is_null()) {
            return bad(name, "values[" + std::to_string(grid.samples.size()) + "] is no number",
                       "a number, or null for a void");
        }
        grid.samples.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                               : value.get<double>());
    }
    grid.metres = true;
    measure_range(grid);
    return grid;
}

}  // namespace repousse::host
