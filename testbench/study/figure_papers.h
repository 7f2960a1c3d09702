#pragma once

#include <string>

#include "testbench/study/figures.h"
#include "testbench/study/scene_run.h"

namespace repousse::study {

/// The figures one by one, for `make_figure`.
Result<Figure> figure_9(const FigureOptions& options);
Result<Figure> figure_10(const FigureOptions& options);
Result<Figure> figure_11(const FigureOptions& options);
Result<Figure> figure_18(const FigureOptions& options);
Result<Figure> figure_19(const FigureOptions& options);

/// Table cells "normal | height": the thresholds of an object's tests, a dash for none.
std::string tests_of(const host::AdaptiveSettings& settings);

/// Root mean square of mesh - map over the map's texels, in per cent of the relief. For a scene's
/// only object, a height field on a grid that starts at the origin.
double error_percent(const SceneRun& run, const host::RenderMesh& surface);

}  // namespace repousse::study
