#pragma once

#include <memory>

#include "datapath/pipelines/adaptive_counters.h"
#include "tlm/platform/frame_path.h"
#include "tlm/units/edge_iter.h"
#include "tlm/units/height_test.h"
#include "tlm/units/mid_vertex.h"
#include "tlm/units/normal_test.h"
#include "tlm/units/split.h"
#include "tlm/units/texcoord_test.h"
#include "tlm/units/triangle_stack.h"
#include "tlm/units/view_test.h"

namespace repousse::shell {

/// Adaptive tessellation in the device. Only the units that the configuration names are
/// constructed.
class AdaptivePath : public FramePath {
public:
    AdaptivePath(const DeviceConfig& config, SharedUnits& shared, FrameHost& host);

    FrameError run() override;
    FrameError bind() override;
    void reset() override;
    const BusyTable& busy() const override { return triangle_stack_.busy(); }

    /// Those of the shared units included.
    AdaptiveCounters counters() const;

private:
    void connect();
    bool has_units() const;
    void configure();
    FrameError configure_height_test(const MapView<Fixed>& map);
    bool fetch(uint32_t index, Triangle<Fixed>& triangle);
    void emit(Span<const OutputTriangle<Fixed>> triangles);

    SharedUnits& shared_;
    FrameHost& host_;
    TriangleStack triangle_stack_;
    EdgeIter edge_iter_;
    MidVertex mid_vertex_;
    TexcoordTest texcoord_test_;
    Split split_;
    // Null where the configuration goes without.
    std::unique_ptr<ViewTest> view_test_;
    std::unique_ptr<NormalTest> normal_test_;
    std::unique_ptr<HeightTest> height_test_;

    Span<const VertexRecord> vertices_;
    Span<const uint32_t> indices_;
    bool bad_index_ = false;
    bool aborted_ = false;
};

}  // namespace repousse::shell
