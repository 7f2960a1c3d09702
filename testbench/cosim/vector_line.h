#pragma once

#include <string>
#include <vector>

#include "datapath/numbers/format.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// What a field of a vector file's line is.
enum class FieldKind { Config, Table, Input, Output };

/// One field of a line.
struct Field {
    FieldKind kind = FieldKind::Input;
    std::string name;
    Format format;

    /// `// field input u1_x s14.8`, as it stands in the header.
    std::string header() const;
};

/// The fields of a unit's lines, most significant first: registers, the place of the table (units
/// with a read port), inputs, outputs. An element of a vector port is a field.
std::vector<Field> line_fields(const UnitModel& model);

/// Bits of all fields together, those of a kind, and hexadecimal digits of a line.
int line_width(const std::vector<Field>& fields);
std::vector<Field> fields_of(const std::vector<Field>& fields, FieldKind kind);
std::size_t line_digits(int width);

/// The largest place of a table's first entry.
inline constexpr int kTablePlaceBits = 21;

/// A line under construction, most significant bit first.
class LinePacker {
public:
    explicit LinePacker(int width);
    void add(int64_t word, const Format& format);
    std::string text() const;
    std::string short_text() const;  ///< without leading zeros, but for one digit

private:
    std::vector<bool> bits_;
};

/// A line taken apart again; it must have the right number of lower-case hexadecimal digits.
class LineUnpacker {
public:
    LineUnpacker(const std::string& digits, int width);
    int64_t take(const Format& format);

private:
    const std::string& digits_;
    std::size_t bit_;
};

}  // namespace repousse::cosim
