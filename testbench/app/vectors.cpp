#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "testbench/app/commands.h"
#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/scoreboard.h"
#include "testbench/cosim/vector_file.h"
#include "tlm/config/profile_reader.h"

namespace repousse::app {
namespace {

struct VectorsOptions {
    std::vector<std::string> units;
    std::string folder = (cosim::source_folder() / "vectors").string();
};

std::vector<std::string> chosen(const VectorsOptions& options) {
    if (!options.units.empty()) return options.units;
    return {cosim::rtl_units().begin(), cosim::rtl_units().end()};
}

std::filesystem::path vector_path(const VectorsOptions& options, const std::string& unit) {
    return std::filesystem::path(options.folder) / unit / "hard.vec";
}

Status generate(const VectorsOptions& options) {
    const Result<Profile> profile = shipped_profile("default");
    if (!profile) return profile.error();
    for (const std::string& unit : chosen(options)) {
        const auto model = cosim::make_unit_model(unit, *profile);
        const auto recorded = cosim::record(*model, model->hard_cases());
        const auto path = vector_path(options, unit);
        const Result<cosim::VectorSizes> sizes = cosim::write_vectors(path, *model, recorded, 0);
        if (!sizes) return sizes.error();
        fmt::print("{}: {} transactions\n", path.string(), sizes->lines);
    }
    return done();
}

/// Recomputes the outputs of a file, and compares the file with the hard cases as they are now.
Status check(const VectorsOptions& options) {
    const Result<Profile> profile = shipped_profile("default");
    if (!profile) return profile.error();
    for (const std::string& unit : chosen(options)) {
        const auto model = cosim::make_unit_model(unit, *profile);
        const auto path = vector_path(options, unit);
        const Result<std::vector<cosim::Recorded>> recorded = cosim::read_vectors(path, *model);
        if (!recorded) return recorded.error();
        cosim::Scoreboard scoreboard(*model, path.string());
        for (const cosim::Recorded& r : *recorded) {
            std::vector<int64_t> outputs;
            model->evaluate(r.scenario, outputs);
            scoreboard.compare(r.scenario, scoreboard.cases(), r.outputs, outputs, nullptr);
        }
        fmt::print("{}: {} transactions, {} mismatches\n", path.string(), scoreboard.cases(),
                   scoreboard.mismatches());
        if (scoreboard.mismatches() != 0) {
            return Error{ErrorKind::Mismatch, {}, scoreboard.first_mismatch(), {}, {}};
        }
    }
    return done();
}

}  // namespace

void add_vectors(CLI::App& root, Run& run) {
    const auto options = std::make_shared<VectorsOptions>();
    CLI::App* command = root.add_subcommand(
        "vectors", "Write or check the shared vectors of the units that have RTL.");
    command->require_subcommand(1);
    const std::vector<std::string> names{cosim::rtl_units().begin(), cosim::rtl_units().end()};
    const auto add = [&](const char* name, const char* help,
                         Status (*function)(const VectorsOptions&)) {
        CLI::App* action = command->add_subcommand(name, help);
        action->add_option("UNIT", options->units, "units; all that have RTL by default")
            ->check(CLI::IsMember(names));
        action->add_option("--folder", options->folder, "where the units' folders are")
            ->capture_default_str();
        action->callback([options, function, &run] {
            run = [options, function] { return function(*options); };
        });
    };
    add("generate", "write the hard cases, with the datapath's outputs", generate);
    add("check", "compare the files' outputs with the datapath's", check);
}

}  // namespace repousse::app
