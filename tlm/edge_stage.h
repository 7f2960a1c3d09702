#pragma once

#include <functional>
#include <utility>

#include <systemc>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"
#include "datapath/units/split.h"
#include "tlm/batch_time.h"

namespace repousse::shell {

/// A batch on its way through the tests: up to kBatchTriangles triangles, three edges each.
struct EdgeBatch {
    Span<const Triangle<Fixed>> triangles;
    Span<Edge<Fixed>> edges;
};

/// The one interface between the units of the device: a call hands a batch on. Units are joined
/// sc_port to sc_export; a call a batch costs a hundredth of what the batch's arithmetic does.
class EdgeStage : public virtual sc_core::sc_interface {
public:
    virtual void put(EdgeBatch& batch, BatchTime& time) = 0;
};

/// The same for the corners of a base triangle, which are displaced before its first tests.
class BaseStage : public virtual sc_core::sc_interface {
public:
    virtual void prepare(Triangle<Fixed>& triangle, BatchTime& time) = 0;
};

/// What the stack asks for when the edges of a batch are decided and their vertices complete.
class ChildrenSource : public virtual sc_core::sc_interface {
public:
    /// What a triangle turns into, given its three edges.
    virtual void tessellate(const Triangle<Fixed>& triangle, const Edge<Fixed>* edges,
                            Children<Fixed>& children) = 0;
};

/// A place in the chain of edge stages: works on the batch, then passes it on. The last one in the
/// chain has no successor. A place whose unit the frame does not use lets batches pass untouched.
class EdgePlace : public sc_core::sc_module, public EdgeStage {
public:
    sc_core::sc_export<EdgeStage> in{"in"};
    sc_core::sc_port<EdgeStage, 1, sc_core::SC_ZERO_OR_MORE_BOUND> out{"out"};

    void enable(bool enabled) { enabled_ = enabled; }
    bool enabled() const { return enabled_; }

protected:
    explicit EdgePlace(const sc_core::sc_module_name& name) : sc_module(name) { in.bind(*this); }

    /// The unit's own work on a batch.
    virtual void process(EdgeBatch& batch, BatchTime& time) = 0;

private:
    void put(EdgeBatch& batch, BatchTime& time) final {
        if (enabled_) process(batch, time);
        if (out.size() != 0) out->put(batch, time);
    }

    bool enabled_ = true;
};

/// A place of a unit that stands in the chain more than once: `work` is what it does there.
class EdgeCall : public EdgePlace {
public:
    using Work = std::function<void(EdgeBatch&, BatchTime&)>;
    EdgeCall(const sc_core::sc_module_name& name, Work work)
        : EdgePlace(name), work_(std::move(work)) {}

private:
    void process(EdgeBatch& batch, BatchTime& time) override { work_(batch, time); }

    Work work_;
};

/// A unit's place in the chain that prepares base triangles.
class BasePlace : public BaseStage {
public:
    sc_core::sc_export<BaseStage> base_in{"base_in"};
    sc_core::sc_port<BaseStage, 1, sc_core::SC_ZERO_OR_MORE_BOUND> base_out{"base_out"};

    void enable_base(bool enabled) { enabled_ = enabled; }

protected:
    BasePlace() { base_in.bind(*this); }
    ~BasePlace() override = default;

    /// The unit's own work on the three corners.
    virtual void process_base(Triangle<Fixed>& triangle, BatchTime& time) = 0;

private:
    void prepare(Triangle<Fixed>& triangle, BatchTime& time) final {
        if (enabled_) process_base(triangle, time);
        if (base_out.size() != 0) base_out->prepare(triangle, time);
    }

    bool enabled_ = true;
};

}  // namespace repousse::shell
