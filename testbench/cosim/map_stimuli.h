#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "datapath/numbers/format.h"
#include "testbench/cosim/engine.h"
#include "testbench/cosim/random.h"

namespace repousse::cosim {

/// A map of texels as a read port carries them, `texel(x, y)` row by row. The table has a column
/// and a row more than the map, which are not read.
std::shared_ptr<const Table> texel_table(int width, int height,
                                         const std::function<uint64_t(int x, int y)>& texel);

/// The coordinate nearest to `u` (raw, as all here) that a periodic map of `size` texels accepts:
/// within one period of it.
int32_t within_a_period(const Format& uv, int64_t u, int size);

/// A coordinate on a map of `size` texels, beyond its border, near a seam, or at a texel's border.
/// On a periodic map it lies within one period. With `centres`, at a texel's centre too.
int32_t map_coordinate(Random& random, const Format& uv, int size, bool wrap, bool centres);

}  // namespace repousse::cosim
