#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "datapath/sweep_items.h"
#include "datapath/units/grid_transform.h"
#include "testbench/study/setup_bound.h"

namespace repousse::study {

/// What the sweep does for triangles of one size: corners uniform in a square, as the paper counts.
struct SweepSizeRow {
    int size_px = 0;
    std::size_t base_triangles = 0;
    double fine_triangles = 0;      ///< of each base triangle
    double to_area = 0;             ///< fine triangles over twice the area in grid units
    double additions_per_quad = 0;  ///< one lane
    double commands = 0;            ///< for the strips of one lane, a fine triangle; as all below
    double swaps = 0;
    double sent = 0;           ///< vertices, one lane
    double displaced = 0;      ///< vertices, two lanes with the column FIFO
    double additions_one = 0;  ///< vector additions, a cycle each in one lane
    double additions_two = 0;
    double steps_two = 0;  ///< a cycle each in two lanes
};

/// What a kind of adder does to the edges of closed meshes.
struct AdderRow {
    AdderKind kind = AdderKind::Exact;
    int guard_bits = 0;
    int data_frac = 16;
    double edge_ulp = 0;         ///< largest distance of an edge vertex from the true v * c
    double edge_px = 0;          ///< the same behind `perspective`, on the screen
    std::size_t base_edges = 0;  ///< with vertices on them
    std::size_t cracked_edges = 0;
    std::size_t edge_vertices = 0;
    std::size_t cracked_vertices = 0;
    std::size_t inside_vertices = 0;
    std::size_t cracked_inside = 0;
    std::size_t open_edges = 0;
    int edge_bits = 0;    ///< of one component of the adder along an edge
    int inside_bits = 0;  ///< and inside: value and remainder
};

/// A depth table, for a large picture and a wide angle.
struct DepthRow {
    static constexpr int kLines = 2160;
    static constexpr double kAngle_deg = 90;

    ZTableKind kind = ZTableKind::Linear;
    int index_bits = 0;
    double far_over_near = 0;
    double steps_per_octave = 0;  ///< grid units for each doubling of w
    int64_t table_bits = 0;
    double error = 0;       ///< largest, in grid units, of the position before rounding
    bool reloaded = false;  ///< with every camera
};

struct SweepReport {
    static constexpr int kSizes[] = {8, 16, 32, 64, 128, 256};
    static constexpr int kGuardBits[] = {0, 2, 4, 6, 8, 10, 12, 13};
    static constexpr int kFractions[] = {8, 12, 16, 20};

    uint64_t seed = 1;
    std::vector<SweepSizeRow> sizes;
    std::vector<AdderRow> adders;     ///< 16 fraction bits
    std::vector<AdderRow> fractions;  ///< no guard bits
    std::vector<DepthRow> depths;
    std::vector<SetupBoundRow> setups;
};

/// One row each; the same seed gives the same row, whatever else is made.
SweepSizeRow sweep_size_row(int size_px, uint64_t seed);
std::vector<SetupBoundRow> setup_rows(uint64_t seed);
AdderRow adder_row(AdderKind kind, int guard_bits, int data_frac, uint64_t seed);
DepthRow depth_row(ZTableKind kind, int index_bits, double far_over_near);

/// All of them: about a minute. The same seed gives the same report.
SweepReport sweep_study(uint64_t seed, const std::function<void(const std::string&)>& progress);

/// The report as docs/sweep.md, and its rows.
std::string sweep_markdown(const SweepReport& report);
std::string markdown_row(const SweepSizeRow& row);
std::string markdown_row(const AdderRow& row);
std::string markdown_row(const DepthRow& row);

}  // namespace repousse::study
