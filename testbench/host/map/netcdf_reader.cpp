#include "testbench/host/map/netcdf_reader.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace repousse::host {
namespace {

// Tags and types of the format. A list is its tag and count, or two zeros when it is absent.
constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
enum Type : std::uint32_t { kByte = 1, kChar, kShort, kInt, kFloat, kDouble };

/// Bytes of a value; 0 for a type that there is not.
std::size_t size_of(std::uint32_t type) {
    constexpr std::size_t kSizes[] = {0, 1, 1, 2, 4, 4, 8};
    return type <= kDouble ? kSizes[type] : 0;
}

/// A big-endian value of a type, at a place that has been checked.
double value_at(const std::string& bytes, std::size_t at, std::uint32_t type) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < size_of(type); ++i) {
        word = word << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    switch (type) {
        case kShort:
            return static_cast<std::int16_t>(word);
        case kInt:
            return static_cast<std::int32_t>(word);
        case kFloat: {
            const auto half = static_cast<std::uint32_t>(word);
            float value = 0.0f;
            std::memcpy(&value, &half, sizeof value);
            return static_cast<double>(value);
        }
        case kDouble: {
            double value = 0.0;
            std::memcpy(&value, &word, sizeof value);
            return value;
        }
        default:
            return static_cast<std::int8_t>(word);
    }
}

struct Dimension {
    std::string name;
    std::uint64_t length = 0;  // 0: the record dimension
};

struct Variable {
    std::string name;
    std::vector<std::uint32_t> dimensions;
    std::vector<double> missing;  // values of missing_value and _FillValue
    bool packed = false;
    bool metres = false;
    std::uint32_t type = 0;
    std::uint64_t begin = 0;
};

/// Reads the header from front to back. The first thing that is wrong is kept; after it, reads
/// give zeros and lists are empty, so that callers check once.
class HeaderReader {
public:
    HeaderReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Error bad(std::size_t offset, std::string what, std::string expected) const {
        return {ErrorKind::Input, name_ + ": offset " + std::to_string(offset), std::move(what),
                std::move(expected), ""};
    }
    const std::optional<Error>& error() const { return error_; }
    std::size_t at() const { return at_; }
    void fail(std::string what, std::string expected) {
        if (!error_) error_ = bad(at_, std::move(what), std::move(expected));
    }

    std::uint64_t word(std::size_t size = 4) {
        if (!has(size)) return 0;
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            value = value << 8 | static_cast<unsigned char>(bytes_[at_++]);
        }
        return value;
    }
    std::uint32_t word32() { return static_cast<std::uint32_t>(word()); }

    /// Text or values: `size` bytes, filled up to a multiple of four. Returns where they start.
    std::size_t skip(std::uint64_t size) {
        const std::size_t start = at_;
        if (size > bytes_.size() || !has((static_cast<std::size_t>(size) + 3) / 4 * 4)) return 0;
        at_ += (static_cast<std::size_t>(size) + 3) / 4 * 4;
        return start;
    }
    std::string text() {
        const std::uint32_t size = word32();
        const std::size_t start = skip(size);
        return error_ ? std::string() : bytes_.substr(start, size);
    }

    /// The count of a list with this tag. Every element takes at least eight bytes, so a count
    /// that the file cannot hold is refused before anything is allocated.
    std::uint32_t list(std::uint32_t tag, const char* what) {
        const std::size_t start = at_;
        const std::uint32_t found = word32();
        const std::uint32_t count = word32();
        if (error_ || (found == 0 && count == 0)) return 0;
        if (found == tag && count <= bytes_.size() / 8) return count;
        error_ = bad(start, std::string("the list of ") + what + " is damaged",
                     "tag " + std::to_string(tag) + " and a count");
        return 0;
    }

private:
    bool has(std::size_t size) {
        if (!error_ && size > bytes_.size() - at_) fail("the header is truncated", "more bytes");
        return !error_;
    }

    const std::string& bytes_;
    const std::string& name_;
    std::size_t at_ = 4;  // after the magic bytes
    std::optional<Error> error_;
};

/// Reads a list of attributes; what matters of them goes to `variable`, if there is one.
void read_attributes(HeaderReader& reader, const std::string& bytes, Variable* variable) {
    const std::uint32_t count = reader.list(kAttributes, "attributes");
    for (std::uint32_t i = 0; i < count && !reader.error(); ++i) {
        const std::string name = reader.text();
        const std::uint32_t type = reader.word32();
        const std::uint64_t values = reader.word32();
        const std::size_t each = size_of(type);
        if (each == 0) reader.fail("an attribute of type " + std::to_string(type), "1..6");
        const std::size_t start = reader.skip(values * each);
        if (reader.error() || variable == nullptr) continue;
        if (name == "scale_factor" || name == "add_offset") variable->packed = true;
        if ((name == "missing_value" || name == "_FillValue") && type != kChar && values == 1) {
            variable->missing.push_back(value_at(bytes, start, type));
        }
        if (name == "units" && type == kChar) {
            std::string units = bytes.substr(start, static_cast<std::size_t>(values));
            units.erase(units.find_last_not_of(std::string(" \0", 2)) + 1);
            variable->metres =
                units == "m" || units == "meters" || units == "metres" || units == "meter";
        }
    }
}

Variable read_variable(HeaderReader& reader, const std::string& bytes, std::size_t offset_size) {
    Variable variable;
    variable.name = reader.text();
    const std::uint32_t rank = reader.word32();
    for (std::uint32_t i = 0; i < rank && !reader.error(); ++i) {
        variable.dimensions.push_back(reader.word32());
    }
    read_attributes(reader, bytes, &variable);
    variable.type = reader.word32();
    reader.word();  // vsize: what follows from type and dimensions
    variable.begin = reader.word(offset_size);
    return variable;
}

/// The first variable with two dimensions of fixed length.
const Variable* choose(const std::vector<Variable>& variables,
                       const std::vector<Dimension>& dimensions) {
    for (const Variable& variable : variables) {
        bool fixed = variable.dimensions.size() == 2;
        for (const std::uint32_t d : variable.dimensions) {
            fixed = fixed && d < dimensions.size() && dimensions[d].length > 0;
        }
        if (fixed) return &variable;
    }
    return nullptr;
}

}  // namespace

Result<ElevationGrid> read_netcdf(const std::string& bytes, const std::string& name) {
    HeaderReader reader(bytes, name);
    const bool classic = bytes.compare(0, 3, "CDF") == 0 && bytes.size() > 3;
    const int version = classic ? bytes[3] : 0;
    if (version != 1 && version != 2) {
        return reader.bad(0, "this is no classic netCDF file", "\"CDF\" and version 1 or 2");
    }
    reader.word();  // the number of records: none is read
    std::vector<Dimension> dimensions(reader.list(kDimensions, "dimensions"));
    for (Dimension& dimension : dimensions) {
        dimension.name = reader.text();
        dimension.length = reader.word();
    }
    read_attributes(reader, bytes, nullptr);
    std::vector<Variable> variables;
    const std::uint32_t count = reader.list(kVariables, "variables");
    for (std::uint32_t i = 0; i < count && !reader.error(); ++i) {
        variables.push_back(read_variable(reader, bytes, version == 1 ? 4 : 8));
    }
    if (reader.error()) return *reader.error();
    const std::size_t header = reader.at();

    const Variable* variable = choose(variables, dimensions);
    if (variable == nullptr) {
        return reader.bad(header, "no variable has two dimensions of fixed length",
                          "an elevation grid");
    }
    const std::size_t each = size_of(variable->type);
    if (each == 0 || variable->type == kChar || variable->packed) {
        return reader.bad(header, "variable \"" + variable->name + "\" is packed or not of numbers",
                          "byte, short, int, float or double without scale_factor");
    }
    const std::uint64_t rows = dimensions[variable->dimensions[0]].length;
    const std::uint64_t columns = dimensions[variable->dimensions[1]].length;
    if (rows > kMaxMapSide || columns > kMaxMapSide) {
        return reader.bad(header,
                          "variable \"" + variable->name + "\" has " + std::to_string(rows) +
                              " x " + std::to_string(columns) + " samples",
                          "1.." + std::to_string(kMaxMapSide) + " rows and columns");
    }
    const std::uint64_t data = rows * columns * each;
    if (variable->begin > bytes.size() || data > bytes.size() - variable->begin) {
        return reader.bad(
            bytes.size(), "the data of variable \"" + variable->name + "\" is truncated",
            std::to_string(data) + " bytes from offset " + std::to_string(variable->begin));
    }
    ElevationGrid grid;
    grid.width = static_cast<int>(columns);
    grid.height = static_cast<int>(rows);
    grid.samples.reserve(static_cast<std::size_t>(rows * columns));
    for (std::uint64_t at = variable->begin; at < variable->begin + data; at += each) {
        double value = value_at(bytes, static_cast<std::size_t>(at), variable->type);
        for (const double missing : variable->missing) {
            if (value == missing) value = std::numeric_limits<double>::quiet_NaN();
        }
        grid.samples.push_back(value);
    }
    grid.metres = variable->metres;
    measure_range(grid);
    return grid;
}

}  // namespace repousse::host
