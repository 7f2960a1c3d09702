#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// An elevation grid in JSON: {"width": W, "height": H, "values": [W * H numbers]}, row by row, as
/// the volcano of vega-datasets has it; row 0 becomes v = 0, no flip. A null is a void (voids.h);
/// other keys are ignored. low and high are measured; samples are taken for metres.
///
/// Errors: `name:line:column: ...` for text that is no JSON, `name: ...` for JSON that is no grid.
Result<ElevationGrid> read_json_grid(const std::string& text, const std::string& name);

}  // namespace repousse::host
