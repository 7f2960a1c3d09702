#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

inline constexpr Port kViewTestPorts[] = {
    {PortKind::Config, "threshold", "screen", 1, true,
     "longest Manhattan length that stays unsplit; |dx| + |dy| needs one bit more than x"},
    {PortKind::Input, "skip", "", 1, true, "the edge is decided: pass it on with result 0"},
    {PortKind::Input, "near1", "", 1, true, "end 1 is not in front of the near plane"},
    {PortKind::Input, "x1", "screen", 0, false, "end 1 in pixels, saturated"},
    {PortKind::Input, "y1", "screen", 0, false, ""},
    {PortKind::Input, "near2", "", 1, true, "end 2 is not in front of the near plane"},
    {PortKind::Input, "x2", "screen", 0, false, "end 2 in pixels, saturated"},
    {PortKind::Input, "y2", "screen", 0, false, ""},
    {PortKind::Output, "vt", "", 1, true, "the edge is longer than the threshold"},
};

inline constexpr std::string_view kViewTestKeys[] = {"screen"};

/// Absolute differences, then sum and comparison.
inline constexpr UnitDesc kViewTestDesc = {
    "view_test", "Doggett and Hirche 2000, sections 2.4 and 3.1.1", kViewTestPorts, kViewTestKeys,
    2,  // latency
    1,  // interval
    2,  // capacity
    0,  // backward latency
};

}  // namespace repousse
