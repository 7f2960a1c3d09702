#pragma once

#include <cstdint>
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

/// Triangles in one batch: 64 triangles and their 192 edges stay in a second-level cache.
inline constexpr std::size_t kBatchTriangles = 64;

/// The units of adaptive tessellation (Doggett and Hirche, figures 7 and 8) composed by plain
/// calls: level `ref` with the policy Real, and the bare loop that simulation levels are measured
/// against with Fixed. The order of the stages is the hardware's: ct, vt, nt, sht. Units that the
/// draw does not call for are not built.
template <class P>
class AdaptivePipeline {
public:
    /// The draw must outlive the pipeline.
    AdaptivePipeline(const Profile& profile, const AdaptiveDraw<P>& draw);

    /// Tessellates the draw. `emit(Span<const OutputTriangle<P>>)` gets finished triangles in
    /// architectural order, whatever the number of contexts. False if a stack's bound was broken.
    template <class Emit>
    bool run(Emit&& emit, int contexts = int(kBatchTriangles));

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

template <class P>
template <class Emit>
bool AdaptivePipeline<P>::run(Emit&& emit, int contexts) {
    Contexts<P> lanes(contexts, registers_.order, registers_.cap);
    std::vector<Triangle<P>> triangles(kBatchTriangles);
    std::vector<Edge<P>> edges(3 * kBatchTriangles);
    Children<P> children;
    std::size_t next = 0;
    const auto fetch = [&](Triangle<P>& place) {
        if (next == draw_.triangles.size()) return false;
        place = draw_.base_triangle(next++);
        prepare_base(place);
        return true;
    };
    bool fits = true;
    while (const std::size_t n = lanes.gather(triangles, fetch)) {
        const Span<Edge<P>> batch(edges.data(), 3 * n);
        test_edges(Span<const Triangle<P>>(triangles.data(), n), batch);
        for (std::size_t i = 0; i < n; ++i) {
            split_.tessellate(triangles[i], &edges[3 * i], children);
            fits = lanes.scatter(i, triangles[i], children) && fits;
        }
        lanes.flush(emit);
    }
    stack_peak_ = lanes.peak();
    return fits;
}

}  // namespace repousse
