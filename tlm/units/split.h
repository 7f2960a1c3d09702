#pragma once

#include "datapath/profile.h"
#include "datapath/units/split.h"
#include "datapath/units/split_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// Pass or Tessellate in the device: datapath/units/split.h with its timing. Its place in the
/// chain decides the edges; once the new vertices are complete, the stack asks it for each
/// triangle's children.
class Split : public EdgePlace, public ChildrenSource {
public:
    sc_core::sc_export<ChildrenSource> children{"children"};

    Split(const sc_core::sc_module_name& name, const Profile& profile);

    /// `surface_test`: the frame uses the normal or the height test.
    void configure(bool surface_test) { unit_.configure(surface_test); }
    void reset() { unit_.reset(); }
    const SplitCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;
    void tessellate(const Triangle<Fixed>& triangle, const Edge<Fixed>* edges,
                    Children<Fixed>& result) override {
        unit_.tessellate(triangle, edges, result);
    }

    repousse::Split<Fixed> unit_;
};

}  // namespace repousse::shell
