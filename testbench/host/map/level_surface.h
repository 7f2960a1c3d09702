#pragma once

#include <vector>

#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// Deepest filter level: a map of kMaxMapSide has become 1 x 1.
constexpr int kMaxFilterLevel = 14;

/// Vertices of a filter level along a side of `size` texels: ceil(size / 2^level), which is
/// `level` times the half rounded up. Range: size >= 1, level 0..kMaxFilterLevel.
int level_size(int size, int level);

/// Number of filter levels of a map, itself not counted: the last one is 1 x 1.
int level_count(int width, int height);

/// How one side of a map lies over the vertices of a filter level.
///
/// Vertex i stands at (i + 1/2) 2^level texels from the border, the centre of the block of 2^level
/// texels that it replaces, so that the device finds it by a shift of its texel coordinate. A
/// texel's centre lies between two vertices; beyond the last ones the surface is level (clamp) or
/// goes on to the other border's vertex (wrap). On a side that wraps and is no multiple of
/// 2^level the last block is cut short, and the surface has a step at the seam, as the device's
/// reads have.
struct LevelAxis {
    /// The texels begin..end - 1 lie between the same two vertices; these are one where the
    /// surface is level, and `fraction` is 0 there.
    struct Cell {
        int begin = 0;
        int end = 0;
        int lower = 0;
        int upper = 0;
    };
    int vertices = 0;
    std::vector<Cell> cells;       ///< in the order of the texels, none empty
    std::vector<double> fraction;  ///< of each texel: 0 at the lower vertex, 1 at the upper
};

LevelAxis level_axis(int size, int level, bool wrap);

/// A level of a map as a surface: bilinear between its vertices.
struct LevelGrid {
    LevelAxis x;
    LevelAxis y;

    LevelGrid(const HeightMap& map, int level);
    std::size_t vertices() const {
        return static_cast<std::size_t>(x.vertices) * static_cast<std::size_t>(y.vertices);
    }
};

/// The surface at every texel centre of the map, row-major, from the heights of the level's
/// vertices: a linear map B of `heights`. The second form reuses the memory of `surface`.
std::vector<double> surface_of(const LevelGrid& grid, const std::vector<double>& heights);
void surface_of(const LevelGrid& grid, const std::vector<double>& heights,
                std::vector<double>& surface);

/// B's transpose: for each vertex, the sum of `values` (one a texel) weighted with the vertex's
/// hat. The second form reuses the memory of `sums`.
std::vector<double> hat_sums(const LevelGrid& grid, const std::vector<double>& values);
void hat_sums(const LevelGrid& grid, const std::vector<double>& values, std::vector<double>& sums);

/// The volume between a map and the surface over `grid` with the vertex heights `heights` (LSB,
/// row-major): the sum of |surface - map| over the map's texel centres, in LSB x texel (Gumhold
/// and Huettner, section 4.2, figure 16: "the difference volume").
///
/// Weights are multiples of 4^-(level + 1), so with heights that are multiples of 1/64 LSB every
/// term is exact in a double, and the sum is too up to 2^53 / 2^(24 + 2 level) texels.
double difference_volume(const HeightMap& map, const LevelGrid& grid,
                         const std::vector<double>& heights);

/// The same of a level that is a map of its own: `level_map` is level `level` of `map`.
double difference_volume(const HeightMap& map, const HeightMap& level_map, int level);

}  // namespace repousse::host
