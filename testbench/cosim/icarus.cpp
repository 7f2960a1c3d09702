#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <sstream>

#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/parameters.h"
#include "testbench/cosim/process.h"
#include "testbench/cosim/scoreboard.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/vector_file.h"
#include "testbench/cosim/vector_line.h"

namespace repousse::cosim {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::size_t kPortion = 128;  // transactions under one setting of the registers

/// A folder below the system's temporary one, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::error_code error;
        std::string pattern = (fs::temp_directory_path(error) / "repousse-XXXXXX").string();
        if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// What the replay printed.
struct Transcript {
    struct Line {
        uint64_t index, cycle;  // of a beat
        std::string expected, got;
    };
    std::vector<Line> mismatches;  // the first hundred
    uint64_t cases = 0;
    uint64_t mismatch_count = 0;
    bool finished = false;
};

/// A line's digits; where bits are unknown (x), others than expected, so that they show.
std::string known_digits(const Transcript::Line& line, std::size_t digits) {
    std::string got = line.got, expected = line.expected;
    got.insert(0, digits - std::min(digits, got.size()), '0');
    expected.insert(0, digits - std::min(digits, expected.size()), '0');
    for (std::size_t i = 0; i < digits; ++i) {
        const bool known = std::string("0123456789abcdef").find(got[i]) != std::string::npos;
        if (!known) got[i] = expected[i] == '0' ? 'f' : '0';
    }
    return got;
}

Transcript parse(const std::string& output) {
    Transcript transcript;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "mismatch") {
            Transcript::Line m{};
            words >> m.index >> m.cycle >> m.expected >> m.got;
            transcript.mismatches.push_back(m);
        } else if (kind == "done") {
            uint64_t cycles = 0;
            words >> transcript.cases >> transcript.mismatch_count >> cycles;
            transcript.finished = true;
        }
    }
    return transcript;
}

/// Puts the reported mismatches into a scoreboard, with the transactions they belong to.
void score(const UnitModel& model, const std::vector<Recorded>& recorded,
           const Transcript& transcript, Scoreboard& scoreboard) {
    const std::vector<Field> fields = fields_of(line_fields(model), FieldKind::Output);
    const int width = line_width(fields);
    uint64_t first = 0, first_beat = 0;
    std::size_t next = 0;
    for (const Recorded& r : recorded) {
        const uint64_t beats = r.outputs.size() / fields.size();
        std::vector<int64_t> engine = r.outputs;
        std::vector<uint64_t> depart(beats, 0);
        for (; next < transcript.mismatches.size(); ++next) {
            const Transcript::Line& m = transcript.mismatches[next];
            if (m.index >= first_beat + beats) break;
            const std::string digits = known_digits(m, line_digits(width));
            LineUnpacker unpacker(digits, width);
            int64_t* word = &engine[(m.index - first_beat) * fields.size()];
            for (const Field& field : fields) *word++ = unpacker.take(field.format);
            depart[m.index - first_beat] = m.cycle;
        }
        scoreboard.compare(r.scenario, first, engine, r.outputs, depart.data());
        first += model.count(r.scenario);
        first_beat += beats;
    }
}

}  // namespace

Result<Outcome> run_icarus(const UnitModel& model, const fs::path& root,
                           const std::vector<Scenario>& hard_cases, uint64_t vectors,
                           uint64_t seed) {
    const auto start = std::chrono::steady_clock::now();
    for (const char* program : {"iverilog", "vvp"}) {
        const Status found = require_program(program, "iverilog");
        if (!found) return found.error();
    }
    const std::string unit(model.desc().name);
    std::vector<Scenario> scenarios = hard_cases;
    for (uint64_t n = 0; n * kPortion < vectors; ++n) {
        Random random(seed, n + 1);
        scenarios.push_back(
            model.random(random, std::min<uint64_t>(kPortion, vectors - n * kPortion)));
    }
    const std::unique_ptr<UnitModel> judge = model.with(model.profile());
    const std::vector<Recorded> recorded = record(*judge, std::move(scenarios));
    uint64_t count = 0;
    for (const Recorded& r : recorded) count += model.count(r.scenario);

    const TemporaryFolder work;
    const Result<VectorSizes> sizes =
        write_vectors(work.path() / "replay.vec", model, recorded, seed);
    if (!sizes) return sizes.error();

    const Result<Words> rtl = rtl_files(root, model.desc());
    if (!rtl) return rtl.error();
    const std::string top = unit + "_replay";
    const fs::path replay = source_folder() / "testbench/cosim/replay";
    Words command = {"iverilog",
                     "-g2012",
                     "-I",
                     root.string(),
                     "-I",
                     source_folder().string(),
                     "-s",
                     top,
                     "-o",
                     (work.path() / "replay.vvp").string(),
                     fmt::format("-P{}.COUNT={}", top, sizes->lines)};
    if (sizes->beats != 0) command.push_back(fmt::format("-P{}.BEATS={}", top, sizes->beats));
    if (sizes->entries != 0) command.push_back(fmt::format("-P{}.ENTRIES={}", top, sizes->entries));
    for (const Parameter& p : parameters(model.desc(), model.profile())) {
        command.push_back(fmt::format("-P{}.{}={}", top, p.name, p.value));
    }
    for (const char* file : {"replay_stream.sv", "replay_memory.sv"}) {
        command.push_back((replay / file).string());
    }
    command.push_back((replay / (top + ".sv")).string());
    command.insert(command.end(), rtl->begin(), rtl->end());
    const Result<std::string> compiled = run_checked(command, root);
    if (!compiled) return compiled.error();
    const Result<std::string> output =
        run_checked({"vvp", "-n", "replay.vvp", "+vectors=replay.vec", "+tables=replay.tables",
                     "+beats=replay.beats", fmt::format("+seed={}", seed)},
                    work.path());
    if (!output) return output.error();

    const Transcript transcript = parse(*output);
    Scoreboard scoreboard(model, fmt::format("seed {}", seed));
    score(model, recorded, transcript, scoreboard);
    Outcome outcome;
    outcome.unit = unit;
    outcome.engine = "Icarus";
    outcome.transactions = "hard + random";
    outcome.cases = transcript.cases;
    outcome.mismatches = transcript.mismatch_count;
    outcome.first_mismatch = scoreboard.first_mismatch();
    if (!transcript.finished || transcript.cases != count) {
        ++outcome.mismatches;
        if (outcome.first_mismatch.empty()) {
            outcome.first_mismatch = fmt::format("{}: Icarus: the unit is stuck at transaction {}",
                                                 unit, transcript.cases);
        }
    }
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

}  // namespace repousse::cosim
