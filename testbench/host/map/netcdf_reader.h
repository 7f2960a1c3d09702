#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// The first two-dimensional variable of a netCDF classic file (CDF-1, or CDF-2 with 64-bit
/// offsets; NetCDF Users' Guide, appendix "File Format Specifications") as an elevation grid.
///
/// Rows are the variable's first dimension, row 0 at v = 0, no flip (ETOPO5: row 0 is 90 S, column
/// 0 is 0 E). Samples are byte, short, int, float or double, big-endian, not packed (a
/// scale_factor or add_offset is refused). Those equal to its missing_value or _FillValue become
/// voids (voids.h). low and high are measured; samples are metres if `units` says so.
///
/// Not read: netCDF-4 (which is HDF5), record variables. Errors: `name: offset N: ...`.
Result<ElevationGrid> read_netcdf(const std::string& bytes, const std::string& name);

}  // namespace repousse::host
