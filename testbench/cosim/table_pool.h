#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "testbench/cosim/engine.h"
#include "testbench/cosim/random.h"

namespace repousse::cosim {

/// Exclusive prefix sums of the heights `height(x, y)`, modulo 2^stored_bits.
std::shared_ptr<const Table> prefix_sums(int width, int height, int stored_bits,
                                         const std::function<uint64_t(int x, int y)>& texel);

/// The same sums counted from another origin: every box keeps its sum, but the stored entries
/// wrap around somewhere else.
std::shared_ptr<const Table> offset_table(const Table& table, uint64_t offset, int stored_bits);

/// Entries that are sums of nothing: all bits random. They drive the adders over their full range.
std::shared_ptr<const Table> random_words(int width, int height, int stored_bits, Random& random);

/// Maps of many shapes, no larger than `max_size` on a side, with heights of `height_bits` bits:
/// noise, all texels at the maximum, a ramp, and random words.
std::vector<std::shared_ptr<const Table>> table_pool(int max_size, int height_bits,
                                                     int stored_bits);

}  // namespace repousse::cosim
