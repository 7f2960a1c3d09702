#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "datapath/fine_vertices.h"
#include "datapath/pipelines/sweep_counters.h"
#include "datapath/pipelines/sweep_draw.h"
#include "datapath/profile.h"
#include "datapath/units/bump.h"
#include "datapath/units/controller.h"
#include "datapath/units/displace.h"
#include "datapath/units/footprint.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/perspective.h"
#include "datapath/units/shade.h"
#include "datapath/units/strip.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_buffer.h"
#include "datapath/units/triangle_setup.h"
#include "datapath/units/vertex_transform.h"
#include "datapath/units/view_clip.h"

namespace repousse {

/// How the setup and the sweep line of a draw are built: by the profile, and by whether the draw
/// wants the components that `bump` needs, and the steps that `footprint` needs.
TriangleSetupOptions setup_options(const Profile& profile, bool use_bump,
                                   bool use_footprints = false);
SweepLineOptions sweep_options(const Profile& profile);

/// The units of sweep-line remeshing (Gumhold and Huettner, figure 3) composed by plain calls:
/// level `ref` with the policy Real, and the bare loop that simulation levels are measured against
/// with Fixed.
///
///  1. `direct` triangles leave as they are. Of the others, every vertex is brought to the grid
///     once, when the first triangle needs it;
///  2. clip, setup and sweep line;
///  3. a new fine vertex passes perspective, footprint where the map has filter levels, displace
///     and bump, then becomes part of a strip;
///  4. triangles leave in the order of their base triangles.
///
/// With Real, names and topology come from the same integer setup and sweep, on slots rounded from
/// doubles; attributes follow from the names in closed form: nothing is accumulated.
template <class P>
class SweepPipeline {
public:
    /// The draw must outlive the pipeline.
    SweepPipeline(const Profile& profile, const SweepDraw<P>& draw);

    /// Called with vertices, and with triangles that refer to vertices of this call and before.
    using Emit = std::function<void(Span<const SweepOutputVertex<P>>, Span<const FineTriangle>)>;

    /// Remeshes the draw. `emit` gets finished triangles in architectural order. False if a base
    /// triangle names a vertex that is not there, or the sweep line gave one up.
    bool run(const Emit& emit);
    bool run(SweepMesh<P>& mesh);

    /// Listens at the units' read ports. Reads come in the order in which the sweep line makes the
    /// vertices, whatever is in a batch. The ports must outlive the pipeline's use.
    void attach(const TexelPorts& ports) {
        displace_.attach(ports.displace);
        if (bump_) bump_->attach(ports.bump);
    }

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
    void set_texel_steps(const SweepBase<P>& triangle);
    void sweep(const SweepBase<P>& triangle);
    void add_vertices(const SweepBase<P>& triangle);
    void finish_vertices(const Emit& emit);
    void build_strips(uint32_t base, const Emit& emit);
    void drain(const Emit& emit);

    const SweepDraw<P>& draw_;
    Controller<P> controller_;
    VertexTransform<P> vertex_transform_;
    GridTransform<P> grid_transform_;
    std::optional<ViewClip<P>> view_clip_;
    TriangleSetup triangle_setup_;
    SweepLine sweep_line_;
    Perspective<P> perspective_;
    std::optional<Footprint<P>> footprint_;
    Displace<P> displace_;
    std::optional<Bump<P>> bump_;
    std::optional<Shade<P>> shade_;
    Strip<uint32_t> strip_;  // vertices by their number in the output
    TriangleBuffer<SweepOutputVertex<P>> triangle_buffer_;

    std::vector<Corner> corners_;  // by base vertex
    SweepTriangle triangle_;
    TexelSteps<typename P::Value> texel_steps_;  // of `triangle_`, only with footprints
    // The batch.
    std::array<SweepRun, kBatchRuns> runs_;
    std::size_t run_count_ = 0;
    FineVertices<P> fine_{};
    SweptVertices<int32_t> swept_;  // with Real, whose vertices are made of their names
    std::vector<std::array<uint32_t, 3>> made_;  // triangles
};

}  // namespace repousse
