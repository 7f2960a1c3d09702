#pragma once

#include <cstdint>
#include <vector>

#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// Exclusive prefix sums: entry (x, y) of (width + 1) x (height + 1), row-major, is the sum of
/// all texels with index below x and below y, modulo 2^stored_bits. A box [x0, x1) x [y0, y1)
/// sums to t(x1,y1) - t(x0,y1) - t(x1,y0) + t(x0,y0), exact modulo 2^stored_bits whenever the
/// true sum is below that. Full precision needs 16 + log2(W * H) bits, at most 44 here.
/// Range: stored_bits 1..64.
std::vector<std::uint64_t> summed_area_table(const HeightMap& map, int stored_bits);

/// Bits that hold any box of at most half the map in each direction: 16 + log2 of its texels,
/// rounded up (32 at 512^2, 38 at 4096^2; adaptive-tessellation.md, section 4).
int summed_area_bits(int width, int height);

}  // namespace repousse::host
