#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "datapath/pipelines/adaptive_counters.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/draw.h"
#include "datapath/profile.h"
#include "datapath/units/bump.h"
#include "datapath/units/displace.h"
#include "datapath/units/edge_iter.h"
#include "datapath/units/height_test.h"
#include "datapath/units/mid_vertex.h"
#include "datapath/units/normal_test.h"
#include "datapath/units/split.h"
#include "datapath/units/texcoord_test.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/view_test.h"

namespace repousse {

/// Triangles in one batch. Their 96 edges make the call between units free, and with the tops of
/// their stacks they stay close to the first-level cache.
inline constexpr std::size_t kBatchTriangles = 32;

/// The units of adaptive tessellation (Doggett and Hirche, figures 7 and 8) composed by plain
/// calls: level `ref` with the policy Real, and the bare loop that simulation levels are measured
/// against with Fixed. The order of the stages is the hardware's: ct, vt, nt, sht. Units that the
/// draw does not call for are not built.
template <class P>
class AdaptivePipeline {
public:
    /// The draw must outlive the pipeline.
    AdaptivePipeline(const Profile& profile, const AdaptiveDraw<P>& draw);

    /// Called with finished triangles, base triangle by base triangle.
    using Emit = std::function<void(Span<const OutputTriangle<P>>)>;

    /// Tessellates the draw. `emit` gets finished triangles in architectural order, whatever the
    /// number of contexts. False if a stack's bound was broken.
    bool run(const Emit& emit, int contexts = int(kBatchTriangles));

    /// What the units counted so far.
    AdaptiveCounters counters() const;

private:
    void prepare_base(Triangle<P>& triangle);
    void test_edges(Span<const Triangle<P>> triangles, Span<Edge<P>> edges);

    const AdaptiveDraw<P>& draw_;
    AdaptiveRegisters<P> registers_;
    EdgeIter<P> edge_iter_;
    MidVertex<P> mid_vertex_;
    TexcoordTest texcoord_test_;
    Displace<P> displace_;
    Split<P> split_;
    std::optional<VertexTransform<P>> vertex_transform_;
    std::optional<ViewTest<P>> view_test_;
    std::optional<Bump<P>> bump_;
    std::optional<NormalTest<P>> normal_test_;
    std::optional<HeightTest> height_test_;
    std::size_t stack_peak_ = 0;
};

}  // namespace repousse
