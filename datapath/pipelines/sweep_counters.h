#pragma once

#include <optional>
#include <vector>

#include "datapath/pipelines/adaptive_counters.h"
#include "datapath/units/bump.h"
#include "datapath/units/controller.h"
#include "datapath/units/displace.h"
#include "datapath/units/footprint.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/normalise.h"
#include "datapath/units/perspective.h"
#include "datapath/units/shade.h"
#include "datapath/units/strip.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_buffer.h"
#include "datapath/units/triangle_setup.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/view_clip.h"

namespace repousse {

/// What the units of sweep-line remeshing counted in one draw. Units that were not built have no
/// counters.
struct SweepCounters {
    ControllerCounters controller;
    VertexTransformCounters vertex_transform;
    GridTransformCounters grid_transform;
    std::optional<ViewClipCounters> view_clip;
    TriangleSetupCounters triangle_setup;
    SweepLineCounters sweep_line;
    PerspectiveCounters perspective;
    NormaliseCounters normalise;
    std::optional<FootprintCounters> footprint;
    DisplaceCounters displace;
    std::optional<BumpCounters> bump;
    std::optional<ShadeCounters> shade;
    StripCounters strip;
    TriangleBufferCounters triangle_buffer;

    /// Every counter that is a function of the data, under its unit, in pipeline order:
    /// bit-accurate levels agree on each.
    std::vector<CounterRow> rows() const;
};

}  // namespace repousse
