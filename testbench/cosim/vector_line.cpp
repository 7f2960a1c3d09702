#include "testbench/cosim/vector_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "testbench/cosim/parameters.h"

namespace repousse::cosim {
namespace {

/// Bits above the first field that fill up its digit.
std::size_t padding(int width) { return static_cast<std::size_t>((4 - width % 4) % 4); }

}  // namespace

std::string Field::header() const {
    constexpr const char* kNames[] = {"config", "table", "input", "output"};
    return fmt::format("// field {} {} {}", kNames[static_cast<int>(kind)], name,
                       to_string(format));
}

std::vector<Field> line_fields(const UnitModel& model) {
    std::vector<Field> fields;
    const auto add = [&](FieldKind kind, PortKind ports) {
        for (const PortWord& word : port_words(model.desc(), ports, model.profile())) {
            // Modes do not matter to an integer that is written and read.
            Format format = word.format;
            format.quantization = {};
            format.overflow = {};
            fields.push_back({kind, word.name, format});
        }
    };
    add(FieldKind::Config, PortKind::Config);
    if (model.reads_table()) {
        Format place;
        place.width = kTablePlaceBits;
        place.is_signed = false;
        fields.push_back({FieldKind::Table, "first_entry", place});
    }
    add(FieldKind::Input, PortKind::Input);
    add(FieldKind::Output, PortKind::Output);
    return fields;
}

int line_width(const std::vector<Field>& fields) {
    int width = 0;
    for (const Field& field : fields) width += field.format.width;
    return width;
}

std::vector<Field> fields_of(const std::vector<Field>& fields, FieldKind kind) {
    std::vector<Field> list;
    for (const Field& field : fields) {
        if (field.kind == kind) list.push_back(field);
    }
    return list;
}

std::size_t line_digits(int width) { return static_cast<std::size_t>((width + 3) / 4); }

LinePacker::LinePacker(int width) : bits_(padding(width), false) {}

void LinePacker::add(int64_t word, const Format& format) {
    for (int i = format.width - 1; i >= 0; --i) bits_.push_back((word >> i & 1) != 0);
}

std::string LinePacker::text() const {
    std::string digits;
    for (std::size_t i = 0; i < bits_.size(); i += 4) {
        const int digit = 8 * bits_[i] + 4 * bits_[i + 1] + 2 * bits_[i + 2] + bits_[i + 3];
        digits += "0123456789abcdef"[digit];
    }
    return digits;
}

std::string LinePacker::short_text() const {
    const std::string digits = text();
    return digits.substr(std::min(digits.find_first_not_of('0'), digits.size() - 1));
}

LineUnpacker::LineUnpacker(const std::string& digits, int width)
    : digits_(digits), bit_(padding(width)) {}

int64_t LineUnpacker::take(const Format& format) {
    uint64_t bits = 0;
    for (int i = 0; i < format.width; ++i, ++bit_) {
        const char c = digits_[bit_ / 4];
        const int digit = c <= '9' ? c - '0' : c - 'a' + 10;
        bits = bits << 1 | (static_cast<unsigned>(digit) >> (3 - bit_ % 4) & 1);
    }
    return field_word(bits, format);
}

}  // namespace repousse::cosim
