#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "testbench/host/draw.h"
#include "testbench/reference/leaf_mesh.h"

namespace repousse::test {

/// Everything a run of the adaptive pipeline leaves behind, in doubles and exact integers.
struct AdaptiveRun {
    std::vector<reference::LeafTriangle> leaves;
    std::vector<reference::LeafTriangle> base; ///< the displaced base mesh
    AdaptiveCounters counters;
    bool fits = false; ///< no stack bound was broken
};

/// The displaced position of an output corner as doubles: exact for both policies.
template <class P>
reference::LeafTriangle leaf_of(const OutputTriangle<P>& triangle, const Profile& profile) {
    reference::LeafTriangle leaf;
    leaf.base = triangle.path.base;
    for (std::size_t k = 0; k < 3; ++k) {
        const OutputVertex<P>& v = triangle.corners[k];
        leaf.corners[k].uv = {v.uv.x, v.uv.y};
        const int frac = std::is_same_v<P, Real> ? 0 : profile.position.frac;
        leaf.corners[k].position = {std::ldexp(double(v.displaced.x), -frac),
                                    std::ldexp(double(v.displaced.y), -frac),
                                    std::ldexp(double(v.displaced.z), -frac)};
    }
    return leaf;
}

/// Tessellates a draw, and once more with cap 0 for the displaced base mesh.
template <class P>
AdaptiveRun run_adaptive(const Profile& profile, AdaptiveDraw<P> draw,
                         int contexts = int(kBatchTriangles)) {
    AdaptiveRun run;
    const auto into = [&](std::vector<reference::LeafTriangle>& leaves) {
        return [&](Span<const OutputTriangle<P>> triangles) {
            for (const auto& t : triangles) leaves.push_back(leaf_of(t, profile));
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
