#include <fmt/format.h>

#include <fstream>
#include <map>

#include "testbench/cosim/vector_file.h"
#include "testbench/cosim/vector_line.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;

/// Puts a vector file together in memory.
class Writer {
public:
    Writer(const UnitModel& model, uint64_t seed) : model_(model), fields_(line_fields(model)) {
        // What a line holds: all fields, or all but the outputs.
        const int outputs = line_width(fields_of(fields_, FieldKind::Output));
        beat_width_ = outputs;
        width_ = line_width(fields_) - (model.last() < 0 ? 0 : outputs);
        header_ = "// repousse vectors\n";
        header_ += fmt::format("// unit {}\n// schema 1\n// seed {}\n", model.desc().name, seed);
        header_ += fmt::format("// parameters {:016x}\n", parameter_hash(model));
        for (const Field& field : fields_) header_ += field.header() + '\n';
        entry_.width = model.entry_bits();
        entry_.is_signed = false;
    }

    void add(const Recorded& recorded) {
        const Scenario& s = recorded.scenario;
        if (s.name != case_) lines_ += fmt::format("// case {}\n", s.name);
        case_ = s.name;
        std::vector<int64_t> registers = s.config;
        if (model_.reads_table()) registers.push_back(static_cast<int64_t>(place(*s.table)));
        const int64_t* in = s.inputs.data();
        const int64_t* out = recorded.outputs.data();
        for (std::size_t i = 0; i < model_.count(s); ++i) {
            LinePacker line(width_);
            auto field = fields_.cbegin();
            for (const int64_t word : registers) line.add(word, (field++)->format);
            for (std::size_t k = 0; k < model_.inputs(); ++k) line.add(*in++, (field++)->format);
            if (model_.last() < 0) {
                for (; field != fields_.end(); ++field) line.add(*out++, field->format);
            } else {
                add_beats(out, field);
            }
            lines_ += line.text() + '\n';
            ++sizes_.lines;
        }
    }

    std::string text() const { return header_ + lines_; }
    const std::string& tables() const { return tables_; }
    const std::string& beats() const { return beats_; }
    const VectorSizes& sizes() const { return sizes_; }

private:
    /// The beats of one item; `outputs` is the first output field.
    void add_beats(const int64_t*& out, std::vector<Field>::const_iterator outputs) {
        for (bool ends = false; !ends;) {
            ends = model_.ends_item(out);
            LinePacker line(beat_width_);
            for (auto field = outputs; field != fields_.end(); ++field) {
                line.add(*out++, field->format);
            }
            beats_ += line.short_text() + '\n';
            ++sizes_.beats;
        }
    }

    /// Where a table's first entry stands; tables are written once, when they are first used.
    uint64_t place(const Table& table) {
        const auto [found, is_new] = places_.try_emplace(&table, sizes_.entries);
        if (is_new) {
            header_ +=
                fmt::format("// table {} {} {}\n", sizes_.entries, table.width, table.height);
            for (const uint64_t entry : table.entries) {
                LinePacker line(entry_.width);
                line.add(static_cast<int64_t>(entry), entry_);
                tables_ += line.text() + '\n';
            }
            sizes_.entries += table.entries.size();
        }
        return found->second;
    }

    const UnitModel& model_;
    std::vector<Field> fields_;
    int width_ = 0;
    int beat_width_ = 0;
    Format entry_;
    std::string header_, lines_, tables_, beats_, case_;
    std::map<const Table*, uint64_t> places_;
    VectorSizes sizes_;
};

/// Writes beside and renames, so that a failed run leaves the old file whole.
Status write_whole(const fs::path& path, const std::string& text) {
    std::error_code error;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
    const fs::path beside = path.string() + ".new";
    std::ofstream file(beside, std::ios::binary);
    file << text;
    file.close();
    if (file) fs::rename(beside, path, error);
    if (file && !error) return done();
    return Error{ErrorKind::Environment, path.string(), "cannot be written", {}, {}};
}

}  // namespace

uint64_t parameter_hash(const UnitModel& model) {
    return profile_hash(model.profile(), model.desc().keys);
}

fs::path tables_path(fs::path path) { return path.replace_extension(".tables"); }

fs::path beats_path(fs::path path) { return path.replace_extension(".beats"); }

std::vector<Recorded> record(UnitModel& model, std::vector<Scenario> scenarios) {
    std::vector<Recorded> recorded;
    for (Scenario& scenario : scenarios) {
        recorded.push_back({std::move(scenario), {}, 0});
        model.evaluate(recorded.back().scenario, recorded.back().outputs);
    }
    return recorded;
}

Result<VectorSizes> write_vectors(const fs::path& path, const UnitModel& model,
                                  const std::vector<Recorded>& recorded, uint64_t seed) {
    Writer writer(model, seed);
    for (const Recorded& r : recorded) writer.add(r);
    if (writer.sizes().entries >> kTablePlaceBits != 0) {
        return Error{ErrorKind::Input, path.string(), "too many table entries", {}, {}};
    }
    if (model.reads_table()) {
        const Status written = write_whole(tables_path(path), writer.tables());
        if (!written) return written.error();
    }
    if (model.last() >= 0) {
        const Status written = write_whole(beats_path(path), writer.beats());
        if (!written) return written.error();
    }
    const Status written = write_whole(path, writer.text());
    if (!written) return written.error();
    return writer.sizes();
}

}  // namespace repousse::cosim
