#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// A two-dimensional array of a NumPy .npz archive as an elevation grid: rows are the grid's rows
/// (row 0 at v = 0, no flip), samples int16, uint16, int32, float32 or float64, little-endian,
/// C order. low and high are measured; samples are taken for metres; voids (voids.h) stay.
///
/// The array is "elevation.npy" (as in the Jacksboro elevation file, 344 rows x 403 int16).
/// Errors: `name: offset N: ...`, offsets within the archive, or within the member after its name.
Result<ElevationGrid> read_npz(const std::string& bytes, const std::string& name);

/// The .npy part: `bytes` is the member's content.
Result<ElevationGrid> read_npy(const std::string& bytes, const std::string& name);

}  // namespace repousse::host
