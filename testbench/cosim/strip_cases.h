#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "datapath/strip_ports.h"
#include "datapath/units/sweep_line.h"
#include "testbench/cosim/sweep_line_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// Steps for the unit, written down as a scenario; new vertices are numbered as they come.
class StripSteps {
public:
    StripSteps(const Profile& profile, std::vector<Scenario>& cases, uint32_t first_vertex);

    /// Each scenario begins with a flush: it does not depend on the one before.
    void begin(const char* name) {
        cases_.push_back({name, {}, nullptr, {}});
        flush_ = true;
    }
    void flush() { flush_ = true; }

    void step(const StripStep& step);
    void step(std::initializer_list<StripCommand> commands, bool init = false, bool flip = false);

    /// What the sweep line sends for a base triangle, of this profile's number of lanes; at most
    /// `limit` steps of it. Whether that was all.
    bool sweep(const GridCorners& grid, std::size_t limit = ~std::size_t{0});

private:
    std::vector<Scenario>& cases_;
    SweepLine sweep_;
    uint32_t next_vertex_;
    bool flush_ = true;
};

/// The hard cases of the stripping unit, by name.
std::vector<Scenario> strip_cases(const Profile& profile);

}  // namespace repousse::cosim
