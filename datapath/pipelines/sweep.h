#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "datapath/pipelines/sweep_counters.h"
#include "datapath/pipelines/sweep_draw.h"
#include "datapath/pipelines/vertex_pool.h"
#include "datapath/profile.h"
#include "datapath/units/bump.h"
#include "datapath/units/controller.h"
#include "datapath/units/displace.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/perspective.h"
#include "datapath/units/strip.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_buffer.h"
#include "datapath/units/triangle_setup.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/view_clip.h"

namespace repousse {

/// Steps of the sweep line in one batch: their vertices stay in the first-level cache.
inline constexpr std::size_t kBatchSteps = 64;

/// How the setup and the sweep line of a draw are built: by the profile, and by whether the draw
/// wants the components that `bump` needs.
TriangleSetupOptions setup_options(const Profile& profile, bool use_bump);
SweepLineOptions sweep_options(const Profile& profile);

/// The units of sweep-line remeshing (Gumhold and Huettner, figure 3) composed by plain calls:
/// level `ref` with the policy Real, and the bare loop that simulation levels are measured against
/// with Fixed.
///
///  1. `direct` triangles leave as they are. Of the others, every vertex is brought to the grid
///     once, when the first triangle needs it;
///  2. clip, setup and sweep line;
///  3. a new fine vertex passes perspective, displace and bump, then becomes part of a strip;
///  4. triangles leave in the order of their base triangles.
///
/// With Real, names and topology come from the same integer setup and sweep, on slots rounded from
/// doubles; attributes follow from the names in closed form: nothing is accumulated.
template <class P>
class SweepPipeline {
public:
    /// The draw must outlive the pipeline.
    SweepPipeline(const Profile& profile, const SweepDraw<P>& draw);

    /// Called with finished triangles.
    using Emit = std::function<void(Span<const SweepOutput<P>>)>;

    /// Remeshes the draw. `emit` gets finished triangles in architectural order. False if a base
    /// triangle names a vertex that is not there, or the sweep line gave one up.
    bool run(const Emit& emit);

    /// What the units counted so far.
    SweepCounters counters() const;

private:
    using Data = std::array<typename P::Value, kSweepComponents>;

    /// A base vertex on the grid.
    struct Corner {
        bool ready = false;
        EyePoint<P> eye;
        std::array<int32_t, 3> slot{};
        Data data{};
    };

    void transform(uint32_t vertex);
    void pass(uint32_t base, const SweepBase<P>& triangle, const Emit& emit);
    void remesh(uint32_t base, const SweepBase<P>& triangle, const Emit& emit);
    bool set_up(const SweepBase<P>& triangle);
    void finish_vertices(const SweepBase<P>& triangle, Span<const SweepStep> steps);
    void build_strips(Span<const SweepStep> steps);
    void enter(uint32_t base, const Emit& emit);
    void drain(const Emit& emit);

    const SweepDraw<P>& draw_;
    Controller<P> controller_;
    VertexTransform<P> vertex_transform_;
    GridTransform<P> grid_transform_;
    std::optional<ViewClip<P>> view_clip_;
    TriangleSetup triangle_setup_;
    SweepLine sweep_line_;
    Perspective<P> perspective_;
    Displace<P> displace_;
    std::optional<Bump<P>> bump_;
    Strip<uint32_t> strip_;  // vertices by their number in fine_
    TriangleBuffer<SweepOutput<P>> triangle_buffer_;

    std::vector<Corner> corners_;  // by base vertex
    SweepTriangle triangle_;
    std::vector<SweepStep> steps_;
    // Vertices of the current base triangle: those that the strip holds, then the batch's.
    VertexPool<SweepOutputVertex<P>> fine_;
    uint32_t first_new_ = 0;                     // of the batch
    std::vector<std::array<uint32_t, 3>> made_;  // by the batch, of vertices in fine_
};

}  // namespace repousse
