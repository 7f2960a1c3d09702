// repousse study: sweeps, and the reports in docs/ that they make.

#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "testbench/app/commands.h"
#include "testbench/host/files.h"
#include "testbench/study/quality.h"

namespace repousse::app {
namespace {

struct QualityOptions {
    std::string input = "inputs/jacksboro_fault_dem.npz";
    std::string output;
};

Status quality(const QualityOptions& options) {
    if (!host::is_file(options.input)) {
        return Error{ErrorKind::Input,
                     options.input,
                     "the elevation file is not there",
                     {},
                     "scenes/fetch.sh gets it"};
    }
    const std::string folder = host::folder_of(options.output);
    if (!options.output.empty() && !std::filesystem::is_directory(folder)) {
        return Error{ErrorKind::Environment, folder, "there is no such folder", {}, {}};
    }
    const bool live = isatty(STDERR_FILENO) != 0;
    const auto report = study::quality_study(options.input, [live](const std::string& step) {
        if (live) std::fprintf(stderr, "\r\033[K%s ...", step.c_str());
    });
    if (live) std::fputs("\r\033[K", stderr);
    if (!report) return report.error();
    const std::string text = study::quality_markdown(*report);
    if (!options.output.empty()) return host::write_file(options.output, text);
    std::fputs(text.c_str(), stdout);
    return done();
}

}  // namespace

void add_study(CLI::App& root, Run& run) {
    CLI::App* study = root.add_subcommand("study", "sweeps that make the reports in docs/");
    study->require_subcommand(1);
    auto options = std::make_shared<QualityOptions>();
    CLI::App* sub = study->add_subcommand(
        "quality", "error against triangle count on real elevations (some minutes)");
    sub->add_option("--input", options->input, "the Jacksboro elevation file (scenes/fetch.sh)")
        ->capture_default_str();
    sub->add_option("-o,--output", options->output, "Markdown file; the terminal otherwise");
    sub->callback([options, &run] { run = [options] { return quality(*options); }; });
}

}  // namespace repousse::app
