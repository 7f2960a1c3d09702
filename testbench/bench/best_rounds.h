#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace repousse::bench {

/// One line of a table of ratios.
struct Row {
    const char* name;
    std::function<void()> run;
    double items = 0;  ///< that a call of `run` works on; 0: as many as the program says
};

/// Prints as usual, and keeps the best round of each benchmark, in nanoseconds of processor time
/// for one of the items that a call of Row::run works on.
class BestRounds : public benchmark::ConsoleReporter {
public:
    explicit BestRounds(double items) : items_(items) {}

    void add(const Row& row) {
        if (row.items != 0) items_of_[row.name] = row.items;
    }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type != Run::RT_Iteration) continue;
            const double per_call = run.cpu_accumulated_time * 1e9 / double(run.iterations);
            const auto own = items_of_.find(run.run_name.function_name);
            const double nanoseconds = per_call / (own == items_of_.end() ? items_ : own->second);
            const auto [best, is_new] = best_.emplace(run.run_name.function_name, nanoseconds);
            if (!is_new) best->second = std::min(best->second, nanoseconds);
        }
        ConsoleReporter::ReportRuns(runs);
    }

    /// A table of best rounds and their ratios to the first row's.
    void print_group(const std::vector<Row>& rows) const {
        const auto first = best_.find(rows.front().name);
        for (const Row& row : rows) {
            const auto found = best_.find(row.name);
            if (found == best_.end() || first == best_.end()) continue;
            std::printf("| %-40s | %8.3f | %8.2f | %10.3f |\n", row.name, found->second,
                        found->second / first->second, 1e3 / found->second);
        }
    }

private:
    double items_;
    std::map<std::string, double> items_of_;  // where a row has a number of its own
    std::map<std::string, double> best_;
};

inline std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != line.npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

/// Runs all rows in interleaved rounds and prints a table whose ratios are of one run: each
/// group's are relative to its first row. The program's exit status.
inline int run_groups(int argc, char** argv, const std::vector<std::vector<Row>>& groups,
                      const char* item, double items, int rounds, double min_time) {
    std::vector<char*> arguments(argv, argv + argc);
    std::string interleave = "--benchmark_enable_random_interleaving=true";
    arguments.insert(arguments.begin() + 1, interleave.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    BestRounds best(items);
    for (const std::vector<Row>& rows : groups) {
        for (const Row& row : rows) {
            best.add(row);
            benchmark::RegisterBenchmark(row.name,
                                         [run = row.run](benchmark::State& state) {
                                             for (auto _ : state) run();
                                         })
                ->Repetitions(rounds)
                ->MinTime(min_time);
        }
    }
    benchmark::RunSpecifiedBenchmarks(&best);
    std::printf("\nBest of the rounds of this run, one core of %s, %s\n", processor().c_str(),
                __VERSION__);
    std::printf("| %-40s | %8s | %8s | %10s |\n| %s | %s | %s | %s |\n", item, "ns", "ratio",
                "million/s", std::string(40, '-').c_str(), "-------:", "-------:", "---------:");
    for (const std::vector<Row>& rows : groups) best.print_group(rows);
    return 0;
}

}  // namespace repousse::bench
