#pragma once

#include <functional>
#include <utility>

#include <systemc>

#include "tlm/batch_time.h"

namespace repousse::shell {

/// The one interface between the units of the device: a call hands a batch on. Units are joined
/// sc_port to sc_export; a call a batch costs a hundredth of what the batch's arithmetic does.
template <class Batch>
class Stage : public virtual sc_core::sc_interface {
public:
    virtual void put(Batch& batch, BatchTime& time) = 0;
};

/// A place in a chain of stages: works on the batch, then passes it on. The last one in the chain
/// has no successor. A place whose unit the frame does not use lets batches pass untouched.
template <class Batch>
class Place : public sc_core::sc_module, public Stage<Batch> {
public:
    sc_core::sc_export<Stage<Batch>> in{"in"};
    sc_core::sc_port<Stage<Batch>, 1, sc_core::SC_ZERO_OR_MORE_BOUND> out{"out"};

    void enable(bool enabled) { enabled_ = enabled; }
    bool enabled() const { return enabled_; }

protected:
    explicit Place(const sc_core::sc_module_name& name) : sc_module(name) { in.bind(*this); }

    /// The unit's own work on a batch.
    virtual void process(Batch& batch, BatchTime& time) = 0;

private:
    void put(Batch& batch, BatchTime& time) final {
        if (enabled_) process(batch, time);
        if (out.size() != 0) out->put(batch, time);
    }

    bool enabled_ = true;
};

/// A place of a unit that stands in several chains, or in one more than once: `work` is what it
/// does there.
template <class Batch>
class Call : public Place<Batch> {
public:
    using Work = std::function<void(Batch&, BatchTime&)>;
    Call(const sc_core::sc_module_name& name, Work work)
        : Place<Batch>(name), work_(std::move(work)) {}

private:
    void process(Batch& batch, BatchTime& time) override { work_(batch, time); }

    Work work_;
};

/// Joins places in a row, the first one to the unit where the batches come from.
template <class Batch>
class Chain {
public:
    explicit Chain(sc_core::sc_port_b<Stage<Batch>>& source) : last_(&source) {}

    void then(Place<Batch>& place) {
        last_->bind(place.in);
        last_ = &place.out;
    }

private:
    sc_core::sc_port_b<Stage<Batch>>* last_;
};

}  // namespace repousse::shell
