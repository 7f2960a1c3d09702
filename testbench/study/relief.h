#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/study/figures.h"
#include "testbench/study/scene_run.h"
#include "testbench/study/skyline.h"

namespace repousse::study {

/// Figure 19's pictures before they are reduced.
inline constexpr host::Viewport kReliefViewport{1260, 264};
inline constexpr int kCoarse_px = 20;

/// A way to make the surface.
struct ReliefVariant {
    const char* name;
    double coarseness_px;
    host::HeightFilter filter;
    std::optional<host::LevelFilter> levels;
    int finer = 0;  ///< levels below that of the footprint
};

/// Behind kVariational and kBox stand the same with levels one and two finer.
enum : std::size_t {
    kFine,
    kUnfiltered,
    kAverage,
    kMean,
    kVariational,
    kBox = kVariational + kMostFiner + 1,
    kReliefVariants = kBox + kMostFiner + 1,
};

extern const std::array<ReliefVariant, kReliefVariants> kReliefWays;

/// What became of a relief's peaks in one surface.
struct ReliefRow {
    RunSurface surface;
    PeaksKept silhouette, relief;

    /// Texels that a displaced vertex took, on average.
    double reads() const {
        return static_cast<double>(surface.texel_reads) / static_cast<double>(surface.displaced);
    }
};

struct Relief {
    SceneRun run;
    std::vector<double> skyline;  ///< of the map itself
    std::vector<ReliefRow> rows;  ///< by variant
    std::size_t silhouette_peaks = 0, relief_peaks = 0;
    int unit_texels = 0;  ///< a coarse grid unit in the middle of the relief
};

/// A scene's map as a relief on eight base triangles, made in all ways.
///
/// @param height  of the relief, in world units
Result<Relief> make_relief(const std::string& scene_file, double height,
                           const FigureOptions& options);

}  // namespace repousse::study
