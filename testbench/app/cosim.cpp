#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "testbench/app/commands.h"
#include "testbench/app/scene_edges.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/tested_edges.h"
#include "testbench/cosim/vector_file.h"
#include "testbench/host/files.h"
#include "tlm/config/profile_reader.h"

namespace repousse::app {
namespace {

struct CosimOptions {
    CosimOptions() { effort.jobs = std::max(1U, std::thread::hardware_concurrency()); }

    std::vector<std::string> units;
    std::string profile = "default";
    cosim::Effort effort;
    uint64_t icarus_vectors = 100'000;
    bool exhaustive = false;
    std::vector<std::string> scenes;
    std::string output;
};

/// One line on stderr that is written over, if stderr is a terminal.
class ProgressLine {
public:
    void show(const std::string& text) const {
        if (terminal_) fmt::print(stderr, "\r\033[K{}", text);
        std::fflush(stderr);
    }
    ~ProgressLine() { show(""); }

private:
    bool terminal_ = isatty(STDERR_FILENO) == 1;
};

std::string thousands(uint64_t n) {
    std::string text = std::to_string(n);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return text;
}

std::string rate(double per_second) {
    return per_second < 1e5 ? fmt::format("{:.1f} k", 1e-3 * per_second)
                            : fmt::format("{:.2f} M", 1e-6 * per_second);
}

void print_row(const cosim::Outcome& o) {
    fmt::print("{:<18} {:<15} {:<30} {:>11} {:>10} {:>9}\n", o.unit, o.engine, o.transactions,
               thousands(o.cases), thousands(o.mismatches),
               o.seconds > 0 ? rate(static_cast<double>(o.cases) / o.seconds) : "-");
    std::fflush(stdout);
}

void print_head() {
    fmt::print("{:<18} {:<15} {:<30} {:>11} {:>10} {:>9}\n", "unit", "engine", "transactions",
               "compared", "mismatches", "vectors/s");
}

/// The same as a document: docs/cosim_results.md.
std::string markdown(const CosimOptions& options, const std::vector<cosim::Outcome>& outcomes) {
    std::string text = fmt::format(
        "# Co-simulation, last measured\n\n"
        "Written by `make cosim`, or by `repousse cosim -o` with other numbers. Profile {}, seed "
        "{},\n"
        "{} % of the batches stalled, {} jobs; up to {} random transactions a unit in Verilator\n"
        "and {} in Icarus.\n\n"
        "| unit | engine | transactions | compared | mismatches | vectors/s |\n"
        "|---|---|---|--:|--:|--:|\n",
        options.profile, options.effort.seed, options.effort.stalled_percent, options.effort.jobs,
        thousands(options.effort.vectors), thousands(options.icarus_vectors));
    for (const cosim::Outcome& o : outcomes) {
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", o.unit, o.engine, o.transactions,
                            thousands(o.cases), thousands(o.mismatches),
                            o.seconds > 0 ? rate(static_cast<double>(o.cases) / o.seconds) : "-");
    }
    return text;
}

/// The committed hard cases if they are of this profile, else the same cases made for it.
Result<std::vector<cosim::Scenario>> hard_cases(const cosim::UnitModel& model, bool is_default) {
    if (!is_default) return model.hard_cases();
    const auto path =
        cosim::source_folder() / fmt::format("vectors/{}/hard.vec", model.desc().name);
    const Result<std::vector<cosim::Recorded>> recorded = cosim::read_vectors(path, model);
    if (!recorded) return recorded.error();
    std::vector<cosim::Scenario> scenarios;
    for (const cosim::Recorded& r : *recorded) scenarios.push_back(r.scenario);
    return scenarios;
}

class CosimCommand {
public:
    explicit CosimCommand(const CosimOptions& options) : options_(options) {}

    Status run() {
        const Result<Profile> profile = find_profile(options_.profile);
        if (!profile) return profile.error();
        const std::vector<std::string> all = units();
        if (!options_.scenes.empty() && std::count(all.begin(), all.end(), kTestsTop) == 0) {
            return Error{ErrorKind::Input,
                         "--scene",
                         "scenes are for " + std::string(kTestsTop) + ", which is not compared",
                         {},
                         {}};
        }
        print_head();
        for (const std::string& unit : all) {
            const Status done = run_unit(*cosim::make_unit_model(unit, *profile));
            if (!done) return done;
        }
        if (!options_.output.empty()) {
            const Status written = host::write_file(options_.output, markdown(options_, outcomes_));
            if (!written) return written;
        }
        if (first_mismatch_.empty()) return done();
        return Error{ErrorKind::Mismatch, {}, first_mismatch_, {}, {}};
    }

private:
    std::vector<std::string> units() const {
        if (!options_.units.empty()) return options_.units;
        return {cosim::rtl_units().begin(), cosim::rtl_units().end()};
    }

    Result<cosim::Engine> engine(const cosim::UnitModel& model) const {
        progress_.show(fmt::format("{}: building the engine", model.desc().name));
        const auto path =
            cosim::build_engine(model.desc(), model.profile(), cosim::source_folder());
        if (!path) return path.error();
        return cosim::Engine::open(*path, model.desc(), model.profile());
    }

    Status run_unit(const cosim::UnitModel& model) {
        const auto report = [&](uint64_t done) {
            progress_.show(fmt::format("{}: {} transactions", model.desc().name, thousands(done)));
        };
        const Result<std::vector<cosim::Scenario>> hard =
            hard_cases(model, options_.profile == "default");
        if (!hard) return hard.error();
        const Result<cosim::Engine> verilated = engine(model);
        if (!verilated) return verilated.error();
        cosim::Effort effort = options_.effort;
        effort.vectors /= model.weight();
        note(cosim::run_random(model, *verilated, *hard, effort, report));

        const auto tiny = model.with(model.tiny_profile());
        if (options_.exhaustive && !tiny->exhaustive(0).inputs.empty()) {
            const Result<cosim::Engine> tiny_engine = engine(*tiny);
            if (!tiny_engine) return tiny_engine.error();
            note(cosim::run_exhaustive(*tiny, *tiny_engine, options_.effort, report));
        }
        if (options_.icarus_vectors > 0) {
            progress_.show(fmt::format("{}: Icarus", model.desc().name));
            const Result<cosim::Outcome> replayed = cosim::run_icarus(
                model, cosim::source_folder(), *hard,
                options_.icarus_vectors / model.icarus_weight(), options_.effort.seed);
            if (!replayed) return replayed.error();
            note(*replayed);
        }
        return model.desc().name == kTestsTop ? run_scenes(model, *verilated) : done();
    }

    /// The edges of the scenes' own runs, in a row a scene.
    Status run_scenes(const cosim::UnitModel& model, const cosim::Engine& engine) {
        for (const std::string& scene : options_.scenes) {
            cosim::TestedEdges edges(model.profile());
            Status made = done();
            const auto recording = [&](const auto& take) {
                made = for_each_setting(scene, options_.profile,
                                        [&](const auto& draw) { edges.run(draw, take); });
            };
            const auto report = [&](uint64_t n) {
                progress_.show(fmt::format("{}: {} edges", scene, thousands(n)));
            };
            cosim::Outcome outcome =
                cosim::run_recorded(model, engine, scene, recording, options_.effort, report);
            if (!made) return made;
            outcome.transactions =
                fmt::format("{}, {} distinct", std::filesystem::path(scene).stem().string(),
                            thousands(edges.distinct()));
            note(outcome);
        }
        return done();
    }

    void note(const cosim::Outcome& outcome) {
        progress_.show("");
        print_row(outcome);
        outcomes_.push_back(outcome);
        if (outcome.mismatches == 0) return;
        fmt::print("  {}\n", outcome.first_mismatch);
        if (first_mismatch_.empty()) first_mismatch_ = outcome.first_mismatch;
    }

    static constexpr std::string_view kTestsTop = "tessellation_tests";

    CosimOptions options_;
    ProgressLine progress_;
    std::vector<cosim::Outcome> outcomes_;
    std::string first_mismatch_;
};

}  // namespace

void add_cosim(CLI::App& root, Run& run) {
    const auto options = std::make_shared<CosimOptions>();
    CLI::App* command = root.add_subcommand(
        "cosim",
        "Compare the RTL with the datapath, transaction by transaction.\n"
        "Runs the committed hard cases and random transactions through the units' Verilog, in\n"
        "Verilator and in Icarus Verilog, with random gaps and stalls. Engines are built when "
        "they\n"
        "are first needed and kept in $REPOUSSE_CACHE_DIR (~/.cache/repousse).");
    const std::vector<std::string> names{cosim::rtl_units().begin(), cosim::rtl_units().end()};
    command->add_option("UNIT", options->units, "units to compare; all that have RTL by default")
        ->check(CLI::IsMember(names));
    command
        ->add_option("--vectors", options->effort.vectors,
                     "random transactions a unit; a tenth of it where they are base triangles")
        ->capture_default_str();
    command
        ->add_option("--icarus", options->icarus_vectors,
                     "random transactions a unit replayed in Icarus, fewer where they are base "
                     "triangles; 0: none")
        ->capture_default_str();
    command->add_flag("--exhaustive", options->exhaustive,
                      "also every transaction of a tiny profile");
    command
        ->add_option("--scene", options->scenes,
                     "also the edges that this scene's run tests, with other thresholds and "
                     "distances too, through tessellation_tests; repeatable")
        ->allow_extra_args(false)
        ->check(CLI::ExistingFile);
    command
        ->add_option("--stalls", options->effort.stalled_percent,
                     "percentage of the batches with random gaps and stalls on every port")
        ->check(CLI::Range(0, 100))
        ->capture_default_str();
    command->add_option("--seed", options->effort.seed, "seed of everything random")
        ->capture_default_str();
    command->add_option("--profile", options->profile, "a shipped profile or a TOML file")
        ->capture_default_str();
    command
        ->add_option("--jobs", options->effort.jobs,
                     "threads for Verilator and the datapath; the results are the same")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "also write the table, as Markdown");
    command->callback(
        [options, &run] { run = [options] { return CosimCommand(*options).run(); }; });
}

}  // namespace repousse::app
