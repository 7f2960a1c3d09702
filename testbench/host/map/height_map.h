#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "datapath/error.h"

namespace repousse::host {

/// Largest side of a map, in texels: the device's UV format (s14.8) must hold U = W and the
/// summed-area table's 64-bit sums are proven up to 4096^2; 16384 leaves room for studies.
constexpr int kMaxMapSide = 16384;

/// A displacement map: 16-bit heights, row 0 at v = 0, row-major (texel (x, y) is
/// texels[y * width + x]). World displacement of a height h is
/// range_low + h * (range_high - range_low) / 65535.
struct HeightMap {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> texels;
    bool wrap = false;        ///< periodic in u and v; otherwise reads clamp to the border
    double range_low = 0.0;   ///< world units of displacement at h = 0
    double range_high = 1.0;  ///< world units of displacement at h = 65535
    bool has_elevation = false;
    double elevation_low_m = 0.0;   ///< metres at h = 0; only with has_elevation
    double elevation_high_m = 0.0;  ///< metres at h = 65535
    std::size_t filled_texels = 0;  ///< of the file: voids that were filled on loading

    std::uint16_t at(int x, int y) const {
        return texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    /// World units of displacement per height LSB.
    double world_per_lsb() const { return (range_high - range_low) / 65535.0; }
};

/// Samples as a file holds them, before they become 16-bit heights.
struct ElevationGrid {
    int width = 0;
    int height = 0;
    std::vector<double> samples;  ///< row-major, row 0 at v = 0
    double low = 0.0;             ///< the sample value that becomes h = 0
    double high = 1.0;            ///< the sample value that becomes h = 65535
    bool metres = false;          ///< samples are elevations in metres
    bool measured = false;        ///< low and high come from measure_range
};

/// h = floor((e - low) * 65535 / (high - low) + .5), clamped to 0..65535; all zero when
/// high == low. 16-bit samples with low = 0, high = 65535 pass unchanged. A void (voids.h), NaN or
/// infinite, becomes 0: it must have been filled or refused before.
HeightMap quantise(const ElevationGrid& grid);

/// Sets low and high of a grid to its smallest and largest finite sample, if it has any.
void measure_range(ElevationGrid& grid);

/// The part of a map that starts at texel (x, y). Error: a part that is not inside the map.
Result<HeightMap> crop(const HeightMap& map, int x, int y, int width, int height);

/// Turns the map upside down: a file whose first row is the north gets its south to v = 0.
void flip_rows(HeightMap& map);

/// Box resampling with exact area weights in integers (mean of the covered area, rounded half
/// up), so the same bytes come out on every machine. Works for any pair of sizes, up or down.
HeightMap resample(const HeightMap& map, int width, int height);

}  // namespace repousse::host
