#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "datapath/pipelines/adaptive_counters.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/draw.h"
#include "datapath/pipelines/tessellation_tests.h"
#include "datapath/profile.h"
#include "datapath/units/bump.h"
#include "datapath/units/displace.h"
#include "datapath/units/edge_iter.h"
#include "datapath/units/mid_vertex.h"
#include "datapath/units/shade.h"
#include "datapath/units/vertex_transform.h"

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

    /// Called with the edges of every batch as they leave the Tessellation Tests, decided. The
    /// midpoints of edges that want attributes (Edge::wants_attributes) have their normals if there
    /// is a Normal Test.
    using Observe = std::function<void(Span<const Edge<P>>)>;
    void observe_tests(Observe observe) { observe_ = std::move(observe); }

    /// Listens at the units' read ports. One context reads in architectural order: triangles depth
    /// first, of each its edges in turn (of a base triangle first its corners). With more of them
    /// `begin` is wanted: it is called with a triangle's path before the reads that the triangle
    /// causes, so that they can be sorted. The ports must outlive the pipeline's use.
    using BeginReads = std::function<void(const Path&)>;
    void attach(const TexelPorts& ports, BeginReads begin = {});

    /// What the units counted so far.
    AdaptiveCounters counters() const;

private:
    void prepare_base(Triangle<P>& triangle);
    void test_edges(Span<const Triangle<P>> triangles, Span<Edge<P>> edges);

    const AdaptiveDraw<P>& draw_;
    AdaptiveRegisters<P> registers_;
    EdgeIter<P> edge_iter_;
    MidVertex<P> mid_vertex_;
    Displace<P> displace_;
    TessellationTests<P> tests_;
    std::optional<VertexTransform<P>> vertex_transform_;
    std::optional<Bump<P>> bump_;
    std::optional<Shade<P>> shade_;
    Observe observe_;
    BeginReads begin_reads_;
    std::size_t stack_peak_ = 0;
};

}  // namespace repousse
