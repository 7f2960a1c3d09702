#pragma once

#include <vector>

#include "datapath/units/height_test.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// The Summed Height Test's hard cases, by name. Maps are small, so that their tables fit a file;
/// the widths that large maps need are reached by tables of random words and by offsets.
std::vector<Scenario> height_test_cases(const Profile& profile);

/// The registers of a scenario's configuration words.
HeightTestRegisters unpack_registers(const std::vector<int64_t>& config);

/// The least threshold, at most `most`, at which an edge no longer fires.
uint64_t border_threshold(HeightTest& unit, HeightTestRegisters registers,
                          Span<const uint64_t> table, const HeightTestIn& edge, uint64_t most);

}  // namespace repousse::cosim
