#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "datapath/error.h"
#include "testbench/cosim/engine.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/cosim/vector_file.h"

namespace repousse::cosim {

/// What one engine's run over one unit found.
struct Outcome {
    std::string unit;
    std::string engine;        ///< "Verilator", "Icarus", ...
    std::string transactions;  ///< "hard + random", "exhaustive", ...
    uint64_t cases = 0;
    uint64_t mismatches = 0;
    double seconds = 0.0;  ///< wall time with everything: generation, engine, datapath, comparison
    std::string first_mismatch;
};

/// How much is tried, and how.
struct Effort {
    uint64_t vectors = 10'000'000;  ///< random transactions
    uint64_t seed = 1;
    uint32_t stalled_percent = 10;  ///< share of the batches with random gaps and stalls
    unsigned jobs = 1;              ///< threads, each with an instance of the engine
};

/// Called now and then with the number of transactions done.
using Progress = std::function<void(uint64_t done)>;

/// Streams the hard cases and then random transactions through an engine, in batches under one
/// setting of the registers each, and compares every transaction with the datapath. Batch b of a
/// seed is the same whatever the number of jobs.
Outcome run_random(const UnitModel& model, const Engine& engine,
                   const std::vector<Scenario>& hard_cases, const Effort& effort,
                   const Progress& progress);

/// Streams every transaction of the model's (tiny) profile through an engine.
Outcome run_exhaustive(const UnitModel& model, const Engine& engine, const Effort& effort,
                       const Progress& progress);

/// Hands recorded transactions to `take`, scenario by scenario.
using Recording = std::function<void(const std::function<void(const Recorded&)>& take)>;

/// Streams what a recording gives through an engine and compares every transaction with the outputs
/// that were recorded. `what` says where they come from.
Outcome run_recorded(const UnitModel& model, const Engine& engine, const std::string& what,
                     const Recording& recording, const Effort& effort, const Progress& progress);

/// Replays vectors in Icarus Verilog, with random gaps and stalls: the hard cases and `vectors`
/// random transactions. The RTL is taken from below `root`.
Result<Outcome> run_icarus(const UnitModel& model, const std::filesystem::path& root,
                           const std::vector<Scenario>& hard_cases, uint64_t vectors,
                           uint64_t seed);

}  // namespace repousse::cosim
