#pragma once

#include <string>

namespace repousse::cosim {

/// The text of rtl/units/shade_tables.svh: the ROMs of Power, LOG_TABLE and EXP_TABLE, for each
/// size a profile may ask for.
std::string verilog_power_tables();

}  // namespace repousse::cosim
