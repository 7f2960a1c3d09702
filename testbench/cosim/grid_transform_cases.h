#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// The registers of grid_transform in the order of its description.
struct GridTransformWords {
    int64_t w_min, w_scale, focal_x, focal_y, steps_per_octave;
    int64_t log2_near, table_near, table_scale, table_shift;

    std::vector<int64_t> pack() const {
        return {w_min,     w_scale,    focal_x,     focal_y,    steps_per_octave,
                log2_near, table_near, table_scale, table_shift};
    }
};

/// A camera: near at 1/2, 64 grid units per unit of x/w, as many steps an octave; the uniform table
/// covers all depths.
GridTransformWords usual_grid_transform(const Profile& profile);

/// Whether the unit has a table to be written, as the uniform kind has.
bool has_depth_words(const Profile& profile);

/// Ascending depths for it; null for a kind without.
std::shared_ptr<const Table> random_depths(const Profile& profile, Random& random);

/// The hard cases of grid_transform, by name.
std::vector<Scenario> grid_transform_cases(const Profile& profile);

}  // namespace repousse::cosim
