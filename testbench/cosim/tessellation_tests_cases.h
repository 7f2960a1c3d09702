#pragma once

#include <vector>

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// The hard cases of the Tessellation Tests, by name: each test alone, every combination of what
/// the four say under every way to use them, and what lies at the border of each.
std::vector<Scenario> tessellation_tests_cases(const Profile& profile);

}  // namespace repousse::cosim
