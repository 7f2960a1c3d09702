#pragma once

#include <string>

namespace repousse::cosim {

/// The text of rtl/units/bump_tables.svh: the knots of Sine's largest table.
std::string verilog_sine_tables();

}  // namespace repousse::cosim
