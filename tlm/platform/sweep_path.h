#pragma once

#include <memory>

#include "datapath/pipelines/sweep_counters.h"
#include "tlm/platform/frame_path.h"
#include "tlm/units/controller.h"
#include "tlm/units/footprint.h"
#include "tlm/units/grid_transform.h"
#include "tlm/units/perspective.h"
#include "tlm/units/strip.h"
#include "tlm/units/sweep_line.h"
#include "tlm/units/triangle_buffer.h"
#include "tlm/units/triangle_setup.h"
#include "tlm/units/view_clip.h"

namespace repousse::shell {

/// Sweep-line remeshing in the device (Gumhold and Huettner, figure 3), with the triangles that
/// pass it by; or, if the configuration asks for these alone, only what they need.
class SweepPath : public FramePath {
public:
    SweepPath(const DeviceConfig& config, SharedUnits& shared, FrameHost& host);

    FrameError run() override;
    FrameError bind() override;
    void reset() override;
    const BusyTable& busy() const override { return busy_; }
    uint32_t status() const override;

    /// Those of the shared units included.
    SweepCounters counters() const;

private:
    /// What displaced triangles need.
    struct Units {
        explicit Units(const DeviceConfig& config);

        GridTransform grid_transform;
        std::unique_ptr<ViewClip> view_clip;  // null where the configuration goes without
        TriangleSetup triangle_setup;
        SweepLine sweep_line;
        Perspective perspective;
        std::unique_ptr<Footprint> footprint;  // null where the configuration goes without
        Strip strip;
    };

    void connect();
    bool has_units() const;
    bool in_range() const;
    void configure();
    void configure_units();
    FrameError bind_units();
    bool elapse(const BatchTime& time, uint64_t cycles);

    const Profile profile_;
    SharedUnits& shared_;
    FrameHost& host_;
    Controller controller_;
    TriangleBuffer triangle_buffer_;
    std::unique_ptr<Units> units_;  // null where nothing is displaced

    Span<const VertexRecord> vertices_;
    Span<const SweepRecord> bases_;
    StreamTime stream_time_;
    BusyTable busy_;
};

}  // namespace repousse::shell
