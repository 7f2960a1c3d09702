#pragma once

#include "datapath/profile.h"
#include "datapath/units/bump.h"
#include "datapath/units/bump_desc.h"
#include "tlm/edge_stage.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The bump mapping unit in the device: datapath/units/bump.h with its timing. It reads the normal
/// map through a port of its own. In adaptive tessellation normals are made, like mid_vertex's
/// attributes, `before_test` or, in a frame without the normal test, `after_split`, and for the
/// corners of `base` triangles; in sweep-line remeshing for `fine` vertices.
class Bump : public sc_core::sc_module {
public:
    Bump(const sc_core::sc_module_name& name, const Profile& profile);

    /// Displaced normals are not wanted in this frame.
    void disable();

    /// The map's tables must outlive the frame. `normal_test`: the frame uses the normal test.
    void configure(const MapView<Fixed>& map, bool normal_test, bool eager);
    void reset() { unit_.reset(); }
    BumpKind bump_kind() const { return unit_.kind(); }
    const BumpCounters& counters() const { return unit_.counters(); }

    EdgeCall before_test;
    EdgeCall after_split;
    BaseCall base;
    FineCall fine;

private:
    void make_normals(EdgeBatch& batch, BatchTime& time, bool for_test);
    template <class Vertices>
    void make_all(Vertices& vertices, BatchTime& time);

    void add_time(BatchTime& time, uint64_t made) const;

    repousse::Bump<Fixed> unit_;
    int interval_;  // of the profile's kind, as the next one
    int latency_;
    bool eager_ = false;
};

}  // namespace repousse::shell
