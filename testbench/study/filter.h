#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"
#include "testbench/study/volume_bound.h"

namespace repousse::study {

/// What a level keeps of the heights of a map, 1 being all, by the kind of the level. Heights are
/// measured from h = 0.
struct HeightsKept {
    double unfiltered = 0;  ///< the texel at the block's centre
    double average = 0;
    double variational = 0;
    double maximum = 0;
};

/// One filter level of a map.
struct FilterLevelReport {
    int level = 0;
    int width = 0;
    int height = 0;
    double start_lsb = 0;       ///< mean |surface - map| of the average
    std::vector<double> curve;  ///< volume over the start's, from step 0
    double ratio = 0;           ///< of the level as rounded to 16 bits
    double maximum_ratio = 0;   ///< of the box maximum
    /// Where `ratio` is above kPromised: that the optimum is, too.
    std::optional<VolumeBound> bound;
    double least_ratio = 0;  ///< bound->least and bound->found over the start's volume
    double found_ratio = 0;
    HeightsKept peaks;    ///< mean over the blocks that are peaks, see filter_study
    HeightsKept skyline;  ///< mean over the columns of blocks: the map's outline from the south
};

/// The levels of one map.
struct FilteredMap {
    std::string name;
    std::string source;
    int width = 0;
    int height = 0;
    bool wrap = false;
    std::vector<FilterLevelReport> levels;
    double seconds_per_megatexel = 0;  ///< all variational levels; processor time
};

struct FilterReport {
    static constexpr int kLevels = 5;
    static constexpr double kPromised = 0.7;  ///< "about 70 %": Gumhold and Huettner, section 4.2
    std::vector<FilteredMap> maps;
    std::vector<std::string> missing;  ///< files that are not there
};

/// One map's levels. A block is a peak if its highest texel is above those of the eight blocks
/// around it; what a level keeps of a peak is its own highest vertex of these nine over that texel:
/// a mountain may move by a block, but not sink. `name` and `source` are for people.
FilteredMap study_map(const host::HeightMap& map, const std::string& name,
                      const std::string& source,
                      const std::function<void(const std::string&)>& progress);

/// The filter levels of the Jacksboro elevations, the mannequin's range map and ETOPO5, from
/// `folder` (scenes/fetch.sh). Some minutes, most of them for the bounds; the same files give the
/// same report but for the time. Errors: a file that is there but broken.
Result<FilterReport> filter_study(const std::string& folder,
                                  const std::function<void(const std::string&)>& progress);

/// The report as docs/filter.md, whose figure stands in `figure`.
std::string filter_markdown(const FilterReport& report, const std::string& figure);

/// The curves as an SVG picture: volume over steps, one panel a map, one line a level.
std::string filter_figure(const FilterReport& report);

}  // namespace repousse::study
