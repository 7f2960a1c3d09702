#pragma once

#include <string>
#include <variant>
#include <vector>

#include "datapath/pipelines/adaptive_counters.h"
#include "testbench/app/job.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/sweep_judge.h"
#include "testbench/reference/leaf_mesh.h"
#include "tlm/batch_time.h"

namespace repousse::app {

/// How much of the hardware a run models.
enum class Level { Ref, Lt };

/// Reads the argument of --level; levels and overrides that are not built yet are refused by name.
Result<Level> parse_level(const std::string& text);
const char* level_name(Level level);

/// What one object turned into.
struct ObjectResult {
    std::size_t base_triangles = 0;
    int cap = 0;  ///< of generations: adaptive
    host::Mesh surface;
    /// By the object's method; nothing if the check was not wanted.
    std::variant<std::monostate, reference::LeafReport, host::SweepInvariants> invariants;
};

/// What a run gave.
struct SimResult {
    std::vector<ObjectResult> objects;
    std::vector<CounterRow> counters;   ///< summed over the objects
    uint64_t table_bytes = 0;           ///< maps and tables that were made
    uint64_t cycles = 0;                ///< of the device; 0 at level ref
    std::vector<shell::UnitBusy> busy;  ///< cycles by unit; empty at level ref
    double simulated_ns = 0;            ///< 0 at level ref
    double tessellation_s = 0;          ///< wall time of the level's own work
};

/// Tessellates every object of the job at the level. `check` judges the result by the invariants.
Result<SimResult> run_level(const Job& job, Level level, bool check, const Progress& progress);

}  // namespace repousse::app
