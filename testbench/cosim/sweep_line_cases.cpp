#include "testbench/cosim/sweep_line_cases.h"

#include <algorithm>

namespace repousse::cosim {
namespace {

using Point = std::array<int32_t, 3>;

Point point_in(Random& random, int x, int y, int z) {
    return {static_cast<int32_t>(random.between(0, x)), static_cast<int32_t>(random.between(0, y)),
            static_cast<int32_t>(random.between(0, z))};
}

GridCorners corners_in(Random& random, int x, int y, int z) {
    return {point_in(random, x, y, z), point_in(random, x, y, z), point_in(random, x, y, z)};
}

/// The third corner beside a point of the line through the first two.
GridCorners thin(Random& random, int limit) {
    GridCorners t;
    for (std::size_t i = 0; i < 2; ++i) {
        for (int32_t& x : t[i]) x = static_cast<int32_t>(random.between(-limit, limit));
    }
    const auto k = static_cast<int32_t>(random.between(0, 1000));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto off = static_cast<int32_t>(random.between(-1, 1));
        const int32_t x = t[0][axis] + (t[1][axis] - t[0][axis]) * k / 1000 + off;
        t[2][axis] = std::clamp(x, -limit, limit);
    }
    std::swap(t[2], t[random.below(3)]);
    return t;
}

}  // namespace

const std::vector<SweepCase>& sweep_hard_cases() {
    static const std::vector<SweepCase> cases = {
        // All three orders of the corners, both windings: columns of one row.
        {"sliver_of_height_1",
         {{{{0, 0, 0}, {9, 0, 0}, {4, 1, 0}}},
          {{{9, 0, 0}, {0, 0, 0}, {4, 1, 0}}},
          {{{0, 0, 0}, {4, -1, 0}, {9, 0, 0}}},
          {{{0, 0, 5}, {0, 12, 6}, {0, 7, 6}}}}},
        // C over A or B: a half without width, whose edge the other half walks (R5).
        {"roof_split_at_a_corner",
         {{{{0, 0, 0}, {6, 0, 0}, {0, 5, 0}}},
          {{{0, 0, 0}, {6, 0, 0}, {6, 5, 0}}},
          {{{0, 0, 0}, {0, 6, 0}, {-6, 6, 2}}},
          {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}},
        // Steep edges: several edge points in one slot, and fans before the tip (R1, R4, R8).
        {"three_edge_points_in_a_slot",
         {{{{0, 0, 0}, {3, 1, 7}, {1, 2, 5}}},
          {{{5, 0, 9}, {4, 3, 0}, {6, 1, 3}}},
          {{{0, 0, 0}, {2, 9, 9}, {1, 3, 6}}},
          {{{0, 6, 3}, {7, 2, 5}, {5, 6, 0}}}}},
        {"three_main_directions",
         {{{{0, 0, 0}, {7, 3, 2}, {6, 4, 9}}},
          {{{0, 0, 0}, {1, 8, 2}, {9, 6, 3}}},
          {{{4, 4, -6}, {-4, 5, 1}, {1, -3, 2}}}}},
        // Every second point of an edge lies between two rows.
        {"half_ties",
         {{{{0, 0, 0}, {8, 4, 0}, {4, 6, 0}}},
          {{{8, 4, 0}, {0, 0, 0}, {4, 6, 0}}},
          {{{0, 4, 0}, {8, 0, 0}, {4, 6, 0}}},
          {{{-8, -4, 4}, {0, 0, 0}, {-4, 2, 2}}}}},
        {"corners_on_one_grid_point",
         {{{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}},
          {{{-4096, 4096, 0}, {-4096, 4096, 0}, {-4096, 4096, 0}}}}},
        {"two_corners_on_one_grid_point",
         {{{{0, 0, 0}, {0, 0, 0}, {5, 2, 1}}},
          {{{5, 2, 1}, {0, 0, 0}, {5, 2, 1}}},
          {{{0, 0, 0}, {0, -4, 0}, {0, -4, 0}}}}},
        {"collinear",
         {{{{0, 0, 0}, {6, 3, 3}, {2, 1, 1}}},
          {{{0, 0, 0}, {4, 4, 4}, {2, 2, 2}}},
          {{{4, 0, 0}, {0, 0, 0}, {1, 0, 0}}}}},
        {"increasing_and_decreasing",
         {{{{0, 0, 0}, {8, 6, 0}, {5, 5, 0}}},
          {{{0, 6, 0}, {8, 0, 0}, {3, 5, 0}}},
          {{{8, 6, 0}, {0, 0, 0}, {3, 1, 0}}},
          {{{8, 0, 0}, {0, 6, 0}, {5, 1, 0}}},
          {{{0, 0, 0}, {8, 7, 0}, {8, 8, 0}}}}},
        {"at_the_ends_of_the_grid",
         {{{{-4096, -4096, -4096}, {-4090, -4096, -4096}, {-4093, -4091, -4096}}},
          {{{4096, 4096, 4096}, {4096, 4090, 4096}, {4091, 4093, 4096}}}}},
        {"a_column_at_a_time",
         {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}}},
          {{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}}},
          {{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}},
          {{{0, 0, 0}, {2, 2, 0}, {0, 2, 2}}}}},
    };
    return cases;
}

GridCorners random_sweep_triangle(Random& random) {
    GridCorners t{};
    switch (random.below(16)) {
        case 0:
        case 1:
        case 2:
            return corners_in(random, 6, 6, 6);
        case 3:
        case 4:
        case 5:
            return corners_in(random, 14, 14, 14);
        case 6:
        case 7:
            return corners_in(random, 20, 20, 20);
        case 8:
            return corners_in(random, 36, 36, 36);
        case 9:
            return corners_in(random, 24, 24, 3);
        case 10:
            return corners_in(random, 3, 24, 24);
        case 11:
            return corners_in(random, 16, 16, 0);
        case 12:
        case 13:
            return thin(random, 20);
        case 14: {
            t = corners_in(random, 24, 24, 24);
            const std::size_t i = random.below(3);
            t[i] = t[(i + 1 + random.below(2)) % 3];
            return t;
        }
        default:
            break;
    }
    // Collinear, or one point.
    const Point p = point_in(random, 9, 9, 9), d = point_in(random, 6, 6, 6);
    for (Point& q : t) {
        const auto k = static_cast<int32_t>(random.percent(80) ? random.between(-4, 4) : 0);
        for (std::size_t axis = 0; axis < 3; ++axis) q[axis] = p[axis] + k * (d[axis] - 3);
    }
    return t;
}

GridCorners random_far_sliver(Random& random) { return thin(random, 4096); }

GridCorners any_sweep_triangle(Random& random) {
    return random.below(8192) == 0 ? random_far_sliver(random) : random_sweep_triangle(random);
}

}  // namespace repousse::cosim
