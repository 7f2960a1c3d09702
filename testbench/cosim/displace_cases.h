#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// A map of heights as displace's read port has it, with its levels, which stand below each other,
/// then the minima of levels 1 and up.
struct LevelledMap {
    std::shared_ptr<const Table> table;
    int height = 0;  ///< rows of the map itself; it has as many columns as the table is wide
};

/// A map whose texels, and those of its levels in the rows further down, are what `texel` says: no
/// levels of this map, but the unit cannot know.
LevelledMap levelled_map(int width, int height, const std::function<uint64_t(int x, int y)>& texel);

/// The hard cases of displace by name.
std::vector<Scenario> displace_cases(const Profile& profile);

}  // namespace repousse::cosim
