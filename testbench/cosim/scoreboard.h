#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// Compares what an engine gave with what the datapath says, transaction by transaction.
class Scoreboard {
public:
    /// `source` says where transactions come from ("seed 1", a file's name).
    Scoreboard(const UnitModel& model, std::string source)
        : model_(&model), source_(std::move(source)) {}

    /// Transactions `first`, `first` + 1, ... of the run; `depart` (may be null) are the cycles in
    /// which their beats left the unit. Both output lists are whole beats; the engine's may be
    /// shorter. An item with a wrong beat is one mismatch.
    void compare(const Scenario& scenario, uint64_t first, const std::vector<int64_t>& engine,
                 const std::vector<int64_t>& datapath, const uint64_t* depart);

    /// The engine broke the protocol while transactions from `first` on were in it.
    void broken(const Scenario& scenario, uint64_t first, const std::string& what);

    /// The items of which the last beat is among these.
    uint64_t items_in(const std::vector<int64_t>& beats) const;

    /// Adds another scoreboard's counts, and keeps the earlier first mismatch.
    void merge(const Scoreboard& other);

    uint64_t cases() const { return cases_; }
    uint64_t mismatches() const { return mismatches_; }

    /// The first mismatch in full: unit, transaction, cycle, field, both values in hexadecimal and
    /// in the field's own unit, the error in LSB, and the transaction's registers and inputs.
    /// Empty if there was none.
    const std::string& first_mismatch() const { return text_; }

private:
    std::string describe(const Scenario& scenario, std::size_t index) const;
    void note(uint64_t transaction, std::string text);

    const UnitModel* model_;
    std::string source_;
    uint64_t cases_ = 0;
    uint64_t mismatches_ = 0;
    uint64_t first_ = ~uint64_t{0};
    std::string text_;
};

}  // namespace repousse::cosim
