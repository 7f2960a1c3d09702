#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "datapath/pipelines/contexts.h"
#include "datapath/units/triangle_stack_desc.h"
#include "tlm/edge_stage.h"

namespace repousse::shell {

/// Get Triangle and the Triangle Queue in the device: the contexts with their stacks, which keep
/// the batches going round. It is the start of both chains and where their results come back.
class TriangleStack : public sc_core::sc_module {
public:
    sc_core::sc_port<Stage<Triangle<Fixed>>> base_out{"base_out"};
    sc_core::sc_port<Stage<EdgeBatch>> out{"out"};
    sc_core::sc_port<ChildrenSource> children{"children"};

    /// `contexts`: how many contexts the modelled device has; it sets the time, not the values.
    TriangleStack(const sc_core::sc_module_name& name, int contexts);

    /// What a frame gives to the stack and wants from it.
    struct Frame {
        StackOrder order = StackOrder::Lifo;
        int cap = 0;
        std::function<bool(Triangle<Fixed>&)> fetch;                  ///< the next base triangle
        std::function<void(Span<const OutputTriangle<Fixed>>)> emit;  ///< finished ones, in order
        std::function<bool(uint64_t cycles)> elapse;  ///< called after each batch; false: abort
    };

    /// Works until no triangle is left, or an abort. False if a stack's bound was broken.
    bool run(const Frame& frame);

    void reset() {
        peak_ = 0;
        busy_ = {};
    }
    uint64_t peak() const { return peak_; }          ///< most triangles that waited in one context
    const BusyTable& busy() const { return busy_; }  ///< of all units, summed over the batches

private:
    uint64_t contexts_;
    uint64_t peak_ = 0;
    BusyTable busy_;
    std::vector<Triangle<Fixed>> triangles_;
    std::vector<Edge<Fixed>> edges_;
};

}  // namespace repousse::shell
