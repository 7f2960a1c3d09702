#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/sweep_items.h"

namespace repousse::study {

/// Cycles in which the triangle setup's dividers work on one base triangle: for each component the
/// differences of three edges and two gradients. All else is pipelined, so this is its interval.
constexpr int setup_cycles(int components, int dividers) {
    return (5 * components + dividers - 1) / dividers;
}

struct SetupBoundSettings {
    int components = kSweepComponents;
    int column_depth = 256;                              ///< two lanes: a step a cycle
    std::vector<int> sizes = {8, 16, 32, 64, 128, 256};  ///< px
    std::vector<int> dividers = {1, 4, 8};
    uint64_t fine_triangles = 500'000;  ///< about so many for each size
    uint64_t seed = 5;
};

/// Base triangles of one size behind a setup of some dividers.
struct SetupBoundRow {
    int size = 0;  ///< px: corners uniform in a square of this side
    int dividers = 0;
    int setup = 0;  ///< cycles a base triangle
    uint64_t base_triangles = 0;
    uint64_t fine_triangles = 0;
    double sweep = 0;            ///< cycles a base triangle, mean
    double bound_triangles = 0;  ///< share of base triangles that take the setup longer
    double bound_time = 0;       ///< share of all cycles in which the sweep line waits for it
    double cycles = 0;           ///< a fine triangle, with the setup
    double sweep_cycles = 0;     ///< a fine triangle, without
};

/// Rows by size, then dividers. The sweep line takes a triangle while it works on the one before
/// (two buffers), and the setup holds one that is done while it divides for the next.
std::vector<SetupBoundRow> setup_bound(const SetupBoundSettings& settings = {});

/// The rows as a Markdown table.
std::string setup_bound_table(const std::vector<SetupBoundRow>& rows);

}  // namespace repousse::study
