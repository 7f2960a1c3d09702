#include "testbench/cosim/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace repousse::cosim {
namespace {

const ProfileEntry* find_entry(std::string_view key) {
    for (const ProfileEntry& entry : profile_entries()) {
        if (entry.key == key) return &entry;
    }
    return nullptr;
}

int integer_value(std::string_view key, const Profile& profile, int without) {
    const ProfileEntry* entry = key.empty() ? nullptr : find_entry(key);
    return entry == nullptr || entry->integer == nullptr ? without : profile.*entry->integer;
}

std::string upper_case(std::string_view key) {
    std::string name;
    for (const char c : key) {
        name += c == '.' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
    return name;
}

}  // namespace

std::vector<Parameter> parameters(const UnitDesc& desc, const Profile& profile) {
    std::vector<Parameter> list;
    for (const std::string_view key : desc.keys) {
        const ProfileEntry* entry = find_entry(key);
        if (entry == nullptr) continue;
        const std::string name = upper_case(key);
        if (entry->format != nullptr) {
            const Format& format = profile.*entry->format;
            list.push_back({name + "_WIDTH", format.width, entry->doc});
            list.push_back({name + "_FRAC", format.frac, "of which fraction bits"});
        } else {
            list.push_back({name, profile.*entry->integer, entry->doc});
        }
    }
    return list;
}

Format port_format(const Port& port, const Profile& profile) {
    Format format;
    format.width = port.extra_bits + integer_value(port.growth_key, profile, 0);
    format.frac = 0;
    format.is_signed = !port.is_unsigned;
    const ProfileEntry* entry = port.key.empty() ? nullptr : find_entry(port.key);
    if (entry == nullptr) return format;
    if (entry->format != nullptr) {
        const Format& of_key = profile.*entry->format;
        const ProfileEntry* other = port.other_key.empty() ? nullptr : find_entry(port.other_key);
        const int other_width = other == nullptr ? 0 : (profile.*other->format).width;
        format.width += std::max(of_key.width, other_width);
        format.frac = of_key.frac;
        format.is_signed = of_key.is_signed && !port.is_unsigned;
    } else {
        format.width += profile.*entry->integer;
    }
    return format;
}

uint64_t field_bits(int64_t word, const Format& format) {
    return static_cast<uint64_t>(word) & (~uint64_t(0) >> (64 - format.width));
}

int64_t field_word(uint64_t bits, const Format& format) {
    const int spare = 64 - format.width;
    return format.is_signed ? static_cast<int64_t>(bits << spare) >> spare
                            : static_cast<int64_t>(bits << spare >> spare);
}

std::string field_text(int64_t word, const Format& format) {
    const double value = std::ldexp(static_cast<double>(word), -format.frac);
    return fmt::format("{:#x} ({})", field_bits(word, format), value);
}

int port_elements(const Port& port, const Profile& profile) {
    return integer_value(port.count_key, profile, 1);
}

std::vector<PortWord> port_words(const UnitDesc& desc, PortKind kind, const Profile& profile) {
    std::vector<PortWord> list;
    for (const Port& port : desc.ports) {
        if (port.kind != kind) continue;
        const std::string name(port.name);
        const Format format = port_format(port, profile);
        if (port.count_key.empty()) {
            list.push_back({name, format});
            continue;
        }
        for (int i = port_elements(port, profile); i-- > 0;) {
            list.push_back({fmt::format("{}[{}]", name, i), format});
        }
    }
    return list;
}

int last_word(const UnitDesc& desc, const Profile& profile) {
    const std::vector<PortWord> words = port_words(desc, PortKind::Output, profile);
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (!desc.last_beat.empty() && words[i].name == desc.last_beat) return static_cast<int>(i);
    }
    return -1;
}

}  // namespace repousse::cosim
