#pragma once

#include <cstddef>
#include <string>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

// A void is a sample without an elevation: NaN or infinite. Readers leave voids in the grid, whose
// range is measured without them; one of the functions here must follow before `quantise`.

/// Samples equal to `value` become voids: elevation files mark them with -32768, -9999, ... If the
/// grid's range had been measured it is measured again, without them.
void mark_voids(ElevationGrid& grid, double value);

/// An error that names the first void by its texel, or done. `name` is the file.
Status refuse_voids(const ElevationGrid& grid, const std::string& name);

/// Fills voids from their rims inwards: in each round every void with a valid sample among its
/// eight neighbours becomes the mean of those (as they were before the round). So a filled sample
/// lies between the lowest and highest valid ones, all others keep their bits, and the result
/// does not depend on an order. With `wrap` the borders are neighbours too.
/// Returns how many were filled. Error: no sample is valid. `name` is the file.
Result<std::size_t> fill_voids(ElevationGrid& grid, bool wrap, const std::string& name);

}  // namespace repousse::host
