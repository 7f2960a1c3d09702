#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <map>

#include "testbench/cosim/vector_file.h"
#include "testbench/cosim/vector_line.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHowToMake = "make it with: repousse vectors generate";

/// Reads one .vec file and the tables beside it.
class Reader {
public:
    Reader(const fs::path& path, const UnitModel& model)
        : path_(path),
          model_(model),
          fields_(line_fields(model)),
          outputs_(fields_of(fields_, FieldKind::Output)),
          width_(line_width(fields_) - (model.last() < 0 ? 0 : line_width(outputs_))),
          digits_(line_digits(width_)) {}

    Result<std::vector<Recorded>> read() {
        std::ifstream file(path_);
        if (!file) return missing(path_);
        if (model_.reads_table()) {
            const Status entries = read_entries();
            if (!entries) return entries.error();
        }
        if (model_.last() >= 0) {
            beats_.open(beats_path(path_));
            if (!beats_) return missing(beats_path(path_));
        }
        for (std::string line; std::getline(file, line);) {
            ++number_;
            const Status taken = line.rfind("//", 0) == 0 ? comment(line) : transaction(line);
            if (!taken) return taken.error();
        }
        if (next_field_ != fields_.size()) return wrong("the file ends", "the unit's fields");
        return std::move(recorded_);
    }

private:
    static Error missing(const fs::path& path) {
        return {ErrorKind::Input, path.string(), "cannot be read", {}, kHowToMake};
    }

    Error wrong(std::string what, std::string expected) const {
        return {ErrorKind::Input, fmt::format("{}:{}:1", path_.string(), std::max(number_, 1)),
                std::move(what), std::move(expected), kHowToMake};
    }

    Status expect(const std::string& line, const std::string& expected) const {
        if (line != expected) return wrong("\"" + line + "\"", "\"" + expected + "\"");
        return done();
    }

    Status comment(const std::string& line) {
        const auto starts = [&line](const char* prefix) { return line.rfind(prefix, 0) == 0; };
        if (starts("// unit ")) return expect(line, fmt::format("// unit {}", model_.desc().name));
        if (starts("// schema ")) return expect(line, "// schema 1");
        if (starts("// parameters ")) {
            return expect(line, fmt::format("// parameters {:016x}", parameter_hash(model_)));
        }
        if (starts("// field ")) {
            if (next_field_ == fields_.size()) return wrong("\"" + line + "\"", "no more fields");
            return expect(line, fields_[next_field_++].header());
        }
        if (starts("// case ")) case_ = line.substr(8);
        if (starts("// table ")) return table(line);
        return done();
    }

    Status read_entries() {
        const fs::path path = tables_path(path_);
        std::ifstream file(path);
        for (std::string line; std::getline(file, line);) {
            uint64_t entry = 0;
            const char* end = line.data() + line.size();
            const auto [stop, code] = std::from_chars(line.data(), end, entry, 16);
            if (code != std::errc{} || stop != end) {
                return Error{ErrorKind::Input,
                             fmt::format("{}:{}:1", path.string(), entries_.size() + 1),
                             "\"" + line + "\"", "a hexadecimal number", kHowToMake};
            }
            entries_.push_back(entry);
        }
        return done();
    }

    Status table(const std::string& line) {
        unsigned long first = 0;
        int width = 0;
        int height = 0;
        if (std::sscanf(line.c_str(), "// table %lu %d %d", &first, &width, &height) != 3 ||
            width < 1 || height < 1 || width > 4096 || height > 4096) {
            return wrong("\"" + line + "\"", "// table FIRST WIDTH HEIGHT");
        }
        const std::size_t count = std::size_t(width + 1) * std::size_t(height + 1);
        if (first > entries_.size() || count > entries_.size() - first) {
            return wrong("\"" + line + "\"",
                         fmt::format("{} entries in {}", count, tables_path(path_).string()));
        }
        const auto from = entries_.begin() + static_cast<std::ptrdiff_t>(first);
        tables_[static_cast<int64_t>(first)] = std::make_shared<Table>(
            Table{width, height, {from, from + static_cast<std::ptrdiff_t>(count)}});
        return done();
    }

    Status transaction(const std::string& line) {
        if (next_field_ != fields_.size()) return wrong("a transaction", "the fields before it");
        if (line.size() != digits_ ||
            line.find_first_not_of("0123456789abcdef") != std::string::npos) {
            return wrong("\"" + line + "\"", fmt::format("{} hexadecimal digits", digits_));
        }
        LineUnpacker unpacker(line, width_);
        Scenario now{case_, {}, nullptr, {}};
        std::vector<int64_t> outputs;
        for (const Field& field : fields_) {
            if (field.kind == FieldKind::Output) break;
            const int64_t word = unpacker.take(field.format);
            if (field.kind == FieldKind::Config) now.config.push_back(word);
            if (field.kind == FieldKind::Input) now.inputs.push_back(word);
            if (field.kind == FieldKind::Table) {
                const auto found = tables_.find(word);
                if (found == tables_.end()) return wrong("an unknown table", "one of the header's");
                now.table = found->second;
            }
        }
        if (model_.last() < 0) {
            for (const Field& field : outputs_) outputs.push_back(unpacker.take(field.format));
        } else {
            const Status taken = read_beats(outputs);
            if (!taken) return taken.error();
        }
        append(std::move(now), outputs);
        return done();
    }

    /// The beats of one item.
    Status read_beats(std::vector<int64_t>& outputs) {
        const int width = line_width(outputs_);
        const std::size_t digits = line_digits(width);
        for (std::string line; std::getline(beats_, line);) {
            ++beat_number_;
            if (line.empty() || line.size() > digits ||
                line.find_first_not_of("0123456789abcdef") != std::string::npos) {
                return Error{ErrorKind::Input,
                             fmt::format("{}:{}:1", beats_path(path_).string(), beat_number_),
                             "\"" + line + "\"",
                             fmt::format("at most {} hexadecimal digits", digits), kHowToMake};
            }
            line.insert(0, digits - line.size(), '0');
            LineUnpacker unpacker(line, width);
            const std::size_t beat = outputs.size();
            for (const Field& field : outputs_) outputs.push_back(unpacker.take(field.format));
            if (model_.ends_item(&outputs[beat])) return done();
        }
        return wrong("no more beats", "a beat that ends the item in the .beats file");
    }

    /// Transactions under one setting of the registers stay together.
    void append(Scenario now, const std::vector<int64_t>& outputs) {
        const bool goes_on = !recorded_.empty() && recorded_.back().scenario.name == now.name &&
                             recorded_.back().scenario.config == now.config &&
                             recorded_.back().scenario.table == now.table;
        if (!goes_on) {
            recorded_.push_back({{now.name, now.config, now.table, {}}, {}, number_});
        }
        Recorded& place = recorded_.back();
        place.scenario.inputs.insert(place.scenario.inputs.end(), now.inputs.begin(),
                                     now.inputs.end());
        place.outputs.insert(place.outputs.end(), outputs.begin(), outputs.end());
    }

    fs::path path_;
    const UnitModel& model_;
    std::vector<Field> fields_, outputs_;
    int width_;
    std::size_t digits_;
    int number_ = 0;  // of the line being read
    std::ifstream beats_;
    int beat_number_ = 0;
    std::size_t next_field_ = 0;  // of the header
    std::string case_;
    std::vector<uint64_t> entries_;
    std::map<int64_t, std::shared_ptr<const Table>> tables_;
    std::vector<Recorded> recorded_;
};

}  // namespace

Result<std::vector<Recorded>> read_vectors(const fs::path& path, const UnitModel& model) {
    return Reader(path, model).read();
}

}  // namespace repousse::cosim
