#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "testbench/cosim/engine_builder.h"
#include "testbench/cosim/session.h"
#include "testbench/cosim/unit_model.h"
#include "tlm/config/profile_reader.h"

namespace repousse::cosim {

/// The model of a unit under a shipped profile.
inline std::unique_ptr<UnitModel> model_of(const std::string& unit,
                                           const char* profile = "default") {
    return make_unit_model(unit, *shipped_profile(profile));
}

/// The Verilated unit that a model judges, built if it is not there; its RTL is below `root`.
inline Engine engine_of(const UnitModel& model,
                        const std::filesystem::path& root = source_folder()) {
    const auto path = build_engine(model.desc(), model.profile(), root);
    if (!path) throw std::runtime_error(path.error().message());
    auto engine = Engine::open(*path, model.desc(), model.profile());
    if (!engine) throw std::runtime_error(engine.error().message());
    return *engine;
}

/// So many random transactions; `stalled_percent` of the batches run under random gaps and stalls
/// on every port.
inline Effort effort(uint64_t vectors, uint32_t stalled_percent = 50) {
    Effort e;
    e.vectors = vectors;
    e.stalled_percent = stalled_percent;
    return e;
}

/// The hard cases and so many random transactions in Verilator; the RTL is below `root`.
inline Outcome run_verilator(const UnitModel& model, uint64_t vectors,
                             const std::filesystem::path& root = source_folder()) {
    return run_random(model, engine_of(model, root), model.hard_cases(), effort(vectors), {});
}

/// The hard cases and so many random transactions are replayed in Icarus without a mismatch.
inline void expect_equal_in_icarus(const UnitModel& model, uint64_t vectors) {
    const auto outcome = run_icarus(model, source_folder(), model.hard_cases(), vectors, 1);
    ASSERT_TRUE(outcome.ok()) << outcome.error().message();
    EXPECT_GE(outcome->cases, vectors);
    EXPECT_EQ(outcome->mismatches, 0U) << outcome->first_mismatch;
}

}  // namespace repousse::cosim
