// repousse study: sweeps, and the reports in docs/ that they make.

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "testbench/app/commands.h"
#include "testbench/host/files.h"
#include "testbench/host/image/picture_file.h"
#include "testbench/study/cache.h"
#include "testbench/study/figures.h"
#include "testbench/study/filter.h"
#include "testbench/study/normalise.h"
#include "testbench/study/quality.h"
#include "testbench/study/sweep.h"

namespace repousse::app {
namespace {

struct QualityOptions {
    std::string input = "inputs/jacksboro_fault_dem.npz";
    std::string output;
};

Status check_folder(const std::string& output) {
    const std::string folder = host::folder_of(output);
    if (!output.empty() && !std::filesystem::is_directory(folder)) {
        return Error{ErrorKind::Environment, folder, "there is no such folder", {}, {}};
    }
    return done();
}

// Says on a terminal what goes on, on one line.
std::function<void(const std::string&)> progress_line() {
    return [live = isatty(STDERR_FILENO) != 0](const std::string& step) {
        if (live) std::fprintf(stderr, "\r\033[K%s ...", step.c_str());
    };
}

Status write_report(const std::string& text, const std::string& output) {
    if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
    if (!output.empty()) return host::write_file(output, text);
    std::fputs(text.c_str(), stdout);
    return done();
}

Status quality(const QualityOptions& options) {
    if (!host::is_file(options.input)) {
        return Error{ErrorKind::Input,
                     options.input,
                     "the elevation file is not there",
                     {},
                     "scenes/fetch.sh gets it"};
    }
    if (const Status folder = check_folder(options.output); !folder) return folder;
    const auto report = study::quality_study(options.input, progress_line());
    if (!report) return report.error();
    return write_report(study::quality_markdown(*report), options.output);
}

struct SweepOptions {
    uint64_t seed = 1;
    std::string output;
};

Status sweep(const SweepOptions& options) {
    if (const Status folder = check_folder(options.output); !folder) return folder;
    const study::SweepReport report = study::sweep_study(options.seed, progress_line());
    return write_report(study::sweep_markdown(report), options.output);
}

void add_sweep(CLI::App& study, Run& run) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App* sub = study.add_subcommand(
        "sweep", "sweep-line remeshing: work, accuracy, widths (some minutes)");
    sub->add_option("--seed", options->seed, "of triangles and cameras")->capture_default_str();
    sub->add_option("-o,--output", options->output, "Markdown file; the terminal otherwise");
    sub->callback([options, &run] { run = [options] { return sweep(*options); }; });
}

struct FilterOptions {
    std::string inputs = "inputs";
    std::string output;
};

// The figure goes into a folder images/ beside the report; times go to the terminal only.
Status filter(const FilterOptions& options) {
    if (const Status folder = check_folder(options.output); !folder) return folder;
    const auto report = study::filter_study(options.inputs, progress_line());
    if (!report) return report.error();
    if (isatty(STDERR_FILENO) != 0) std::fputs("\r\033[K", stderr);
    for (const study::FilteredMap& map : report->maps) {
        std::fprintf(stderr, "%s: all variational levels in %.2f s a megatexel\n", map.name.c_str(),
                     map.seconds_per_megatexel);
    }
    const std::string stem = std::filesystem::path(options.output).stem().string();
    const std::string figure = "images/" + (stem.empty() ? "filter" : stem) + ".svg";
    if (!options.output.empty()) {
        const std::string target = host::folder_of(options.output) + "/" + figure;
        std::error_code failed;  // the write below says so
        std::filesystem::create_directories(host::folder_of(target), failed);
        if (const Status drawn = host::write_file(target, study::filter_figure(*report)); !drawn) {
            return drawn;
        }
    }
    return write_report(study::filter_markdown(*report, figure), options.output);
}

void add_filter(CLI::App& study, Run& run) {
    auto options = std::make_shared<FilterOptions>();
    CLI::App* sub = study.add_subcommand(
        "filter", "filter levels of real maps: volume, bounds, heights kept (some minutes)");
    sub->add_option("--inputs", options->inputs, "folder of what scenes/fetch.sh gets")
        ->capture_default_str();
    sub->add_option("-o,--output", options->output, "Markdown file; the terminal otherwise");
    sub->callback([options, &run] { run = [options] { return filter(*options); }; });
}

struct FiguresOptions {
    std::string scenes = "scenes";
    std::vector<int> only;
    std::string output;
};

// Pictures go into a folder images/ beside the report; without a report none are drawn.
Status figures(const FiguresOptions& options) {
    if (const Status folder = check_folder(options.output); !folder) return folder;
    study::FigureOptions how{options.scenes, !options.output.empty(), progress_line()};
    const std::string images = host::folder_of(options.output) + "/images";
    std::error_code failed;  // writing the pictures says so
    if (how.draw) std::filesystem::create_directories(images, failed);
    std::vector<study::Figure> made;
    for (const int number : study::kFigures) {
        const auto& only = options.only;
        const bool wanted =
            only.empty() || std::find(only.begin(), only.end(), number) != only.end();
        if (!wanted) continue;
        auto figure = study::make_figure(number, how);
        if (!figure) return figure.error();
        for (const study::FigurePicture& picture : figure->pictures) {
            const std::string file = images + "/" + picture.name + ".png";
            if (const Status s = host::write_png(file, picture.picture); !s) return s;
        }
        figure->pictures.clear();
        made.push_back(std::move(*figure));
    }
    return write_report(study::figures_markdown(made), options.output);
}

void add_figures(CLI::App& study, Run& run) {
    auto options = std::make_shared<FiguresOptions>();
    CLI::App* sub = study.add_subcommand(
        "figures", "the papers' figures, made again: pictures and their numbers (a minute)");
    sub->add_option("--only", options->only, "figures to make; all otherwise")
        ->check(CLI::IsMember(study::kFigures));
    sub->add_option("--scenes", options->scenes, "folder of the scene files")
        ->capture_default_str();
    sub->add_option("-o,--output", options->output,
                    "Markdown file, pictures in images/ beside it; the terminal otherwise, and no "
                    "pictures");
    sub->callback([options, &run] { run = [options] { return figures(*options); }; });
}

struct CacheOptions {
    std::string scenes = "scenes";
    std::string output;
};

// The figure goes into a folder images/ beside the report.
Status cache(const CacheOptions& options) {
    if (const Status folder = check_folder(options.output); !folder) return folder;
    const auto report = study::cache_study(options.scenes, progress_line());
    if (!report) return report.error();
    const std::string stem = std::filesystem::path(options.output).stem().string();
    const std::string figure = "images/" + (stem.empty() ? "cache" : stem) + ".svg";
    if (!options.output.empty()) {
        const std::string target = host::folder_of(options.output) + "/" + figure;
        std::error_code failed;  // the write below says so
        std::filesystem::create_directories(host::folder_of(target), failed);
        if (const Status drawn = host::write_file(target, study::cache_figure(*report)); !drawn) {
            return drawn;
        }
    }
    return write_report(study::cache_markdown(*report, figure), options.output);
}

void add_cache(CLI::App& study, Run& run) {
    auto options = std::make_shared<CacheOptions>();
    CLI::App* sub = study.add_subcommand(
        "cache", "texel caches of many shapes under the reads of real scenes (half a minute)");
    sub->add_option("--scenes", options->scenes, "folder of the scene files")
        ->capture_default_str();
    sub->add_option("-o,--output", options->output, "Markdown file; the terminal otherwise");
    sub->callback([options, &run] { run = [options] { return cache(*options); }; });
}

Status normalise(const SweepOptions& options) {
    if (const Status folder = check_folder(options.output); !folder) return folder;
    return write_report(study::normalise_markdown(study::normalise_study(options.seed)),
                        options.output);
}

void add_normalise(CLI::App& study, Run& run) {
    auto options = std::make_shared<SweepOptions>();
    CLI::App* sub =
        study.add_subcommand("normalise", "normals against double, both kinds: error and cycles");
    sub->add_option("--seed", options->seed, "of the vectors")->capture_default_str();
    sub->add_option("-o,--output", options->output, "Markdown file; the terminal otherwise");
    sub->callback([options, &run] { run = [options] { return normalise(*options); }; });
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
    add_sweep(*study, run);
    add_filter(*study, run);
    add_normalise(*study, run);
    add_cache(*study, run);
    add_figures(*study, run);
}

}  // namespace repousse::app
