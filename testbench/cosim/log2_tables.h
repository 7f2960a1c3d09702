#pragma once

#include <string>

namespace repousse::cosim {

/// The ROMs that grid_transform's RTL can be built with, as rtl/units/grid_transform_tables.svh
/// holds them: linear pieces with 1 to 8 index bits, quadratic ones with 1 to 5, and the choice
/// among them by the parameters QUADRATIC and INDEX_BITS.
std::string verilog_log2_tables();

}  // namespace repousse::cosim
