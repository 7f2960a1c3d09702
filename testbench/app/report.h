#pragma once

#include <string>
#include <vector>

#include "testbench/app/job.h"
#include "testbench/app/run_levels.h"

namespace repousse::app {

/// report.json (docs/report.md has its schema): what was run and what came of it. A function of
/// the scene, the profile and the level alone: the same inputs give the same bytes.
std::string report_json(const Job& job, Level level, const SimResult& result);

/// One phase of a run and how long it took.
struct Phase {
    std::string name;
    double seconds = 0;
};

/// timing.json: wall times and the machine, the only output that differs from run to run.
std::string timing_json(const std::vector<Phase>& phases, const SimResult& result);

/// The summary for the terminal, ending in a line feed.
std::string summary(const Job& job, Level level, const SimResult& result);

/// The first broken invariant as an error, or done.
Status verdict(const Job& job, const SimResult& result);

}  // namespace repousse::app
