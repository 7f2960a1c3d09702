#pragma once

#include "datapath/units/edge_iter.h"
#include "datapath/units/edge_iter_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// The edge iterator in the device: datapath/units/edge_iter.h with its timing.
class EdgeIter : public EdgePlace {
public:
    explicit EdgeIter(const sc_core::sc_module_name& name) : EdgePlace(name) {}

    /// `cap`: the generation cap, 0 to 15.
    void configure(int cap) { unit_.configure(cap); }
    void reset() { unit_.reset(); }
    const EdgeIterCounters& counters() const { return unit_.counters(); }

private:
    void process(EdgeBatch& batch, BatchTime& time) override;

    repousse::EdgeIter<Fixed> unit_;
};

}  // namespace repousse::shell
