#pragma once

#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "testbench/host/draw.h"
#include "testbench/host/leaves.h"
#include "testbench/reference/leaf_mesh.h"

namespace repousse::test {

/// Everything a run of the adaptive pipeline leaves behind, in doubles and exact integers.
struct AdaptiveRun {
    std::vector<reference::LeafTriangle> leaves;
    std::vector<reference::LeafTriangle> base;  ///< the displaced base mesh
    AdaptiveCounters counters;
    bool fits = false;  ///< no stack bound was broken
};

/// Tessellates a draw, and once more with cap 0 for the displaced base mesh.
template <class P>
AdaptiveRun run_adaptive(const Profile& profile, AdaptiveDraw<P> draw,
                         int contexts = int(kBatchTriangles)) {
    AdaptiveRun run;
    const auto into = [&](std::vector<reference::LeafTriangle>& leaves) {
        return [&](Span<const OutputTriangle<P>> triangles) {
            for (const auto& leaf : host::leaves_of<P>(triangles, profile)) leaves.push_back(leaf);
        };
    };
    AdaptivePipeline<P> pipeline(profile, draw);
    run.fits = pipeline.run(into(run.leaves), contexts);
    run.counters = pipeline.counters();
    draw.registers.cap = 0;
    AdaptivePipeline<P>(profile, draw).run(into(run.base));
    return run;
}

}  // namespace repousse::test
