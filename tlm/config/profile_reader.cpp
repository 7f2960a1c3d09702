#include "tlm/config/profile_reader.h"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <fstream>
#include <sstream>
#include <utility>

#include "tlm/config/shipped_profiles.h"

namespace repousse {
namespace {

std::string place(const std::string& name, const toml::source_region& region) {
    return name + ":" + std::to_string(region.begin.line) + ":" +
           std::to_string(region.begin.column);
}

std::string known_keys() {
    std::string text;
    for (const ProfileEntry& entry : profile_entries()) {
        if (!text.empty()) text += ", ";
        text += entry.key;
    }
    return text;
}

}  // namespace

Result<Profile> parse_profile(std::string_view toml_text, const std::string& name) {
    const toml::parse_result parsed = toml::parse(toml_text, name);
    if (!parsed) {
        const toml::parse_error& error = parsed.error();
        return Error{ErrorKind::Input,
                     place(name, error.source()),
                     std::string(error.description()),
                     "a TOML file",
                     {}};
    }
    const toml::table& table = parsed.table();
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& [key, node] : table) {
        std::string key_text(key.str());
        if (const auto text = node.value_exact<std::string>()) {
            pairs.emplace_back(std::move(key_text), *text);
        } else if (const auto number = node.value_exact<int64_t>()) {
            pairs.emplace_back(std::move(key_text), std::to_string(*number));
        } else {
            return Error{ErrorKind::Input,
                         place(name, node.source()),
                         "\"" + key_text + "\" has a value of the wrong kind",
                         "a format in quotes or an integer",
                         {}};
        }
    }
    Result<Profile> profile = make_profile(pairs);
    if (profile) return profile;
    // make_profile names the key; the file says where that key stands.
    Error error = profile.error();
    const toml::node* node = table.get(error.where);
    if (error.what == "unknown key") error.expected = "one of " + known_keys();
    error.what = "\"" + error.where + "\": " + error.what;
    error.where = node != nullptr ? place(name, node->source()) : name + ":1:1";
    return error;
}

Result<Profile> read_profile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) {
        std::string names;
        for (const std::string_view name : shipped_profile_names()) {
            names += (names.empty() ? "" : ", ") + std::string(name);
        }
        return Error{ErrorKind::Input,
                     path,
                     "cannot be read as a profile",
                     "a TOML file or one of: " + names,
                     {}};
    }
    return parse_profile(text.str(), path);
}

std::vector<std::string_view> shipped_profile_names() {
    std::vector<std::string_view> names;
    for (const ShippedProfile& profile : shipped_profiles()) names.push_back(profile.name);
    return names;
}

Result<Profile> shipped_profile(std::string_view name) {
    for (const ShippedProfile& profile : shipped_profiles()) {
        if (profile.name == name) return parse_profile(profile.toml, std::string(name));
    }
    return Error{ErrorKind::Input, std::string(name), "no such profile is shipped", {}, {}};
}

Result<Profile> find_profile(const std::string& name_or_path) {
    for (const ShippedProfile& profile : shipped_profiles()) {
        if (profile.name == name_or_path) return shipped_profile(name_or_path);
    }
    return read_profile(name_or_path);
}

}  // namespace repousse
