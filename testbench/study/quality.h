#pragma once

#include <functional>
#include <string>
#include <vector>

#include "datapath/error.h"
#include "testbench/study/height_field.h"

namespace repousse::study {

/// Which tests decide.
enum class Tests { Average, Sum, Normal, AverageNormal, SumNormal };

/// The best that one combination of tests does from one base grid within the budget.
struct BestOf {
    Tests tests = Tests::Average;
    Quality natural;  ///< with the natural cap
    Quality any;      ///< over all caps
};

/// A base grid and its best by each combination of tests.
struct BaseGrid {
    int quads = 0;
    int natural_cap = 0;
    std::vector<BestOf> best;
};

/// Adaptive beside uniform within the same number of triangles.
struct CurvePoint {
    std::size_t budget = 0;
    Quality uniform;
    Quality adaptive;  ///< AVG, best over base grids and caps
};

/// Vertical error against triangle count on a part of the Jacksboro elevations.
struct QualityReport {
    static constexpr int kColumn = 70, kRow = 44, kSize = 257;  ///< the part, in samples
    static constexpr double kSpacing_m = 90;                    ///< 3 arc-seconds, about
    static constexpr std::size_t kBudget = 5000;                ///< triangles

    Quality uniform;  ///< 50 x 50 quads
    std::vector<BaseGrid> bases;
    Quality best;      ///< over everything, thresholds refined
    Quality best_ref;  ///< the same setting at level ref
    Quality coarse;    ///< AVG on 3 x 3 quads with the natural cap
    std::vector<SizeClass> best_sizes, coarse_sizes;
    std::vector<CurvePoint> curve;
};

/// Runs the study on the elevation file: about a minute. The same file gives the same report.
/// `progress` gets a line for each step.
Result<QualityReport> quality_study(const std::string& npz_path,
                                    const std::function<void(const std::string&)>& progress);

/// The report as docs/quality.md.
std::string quality_markdown(const QualityReport& report);

}  // namespace repousse::study
