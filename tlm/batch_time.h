#pragma once

#include <cstdint>

#include "datapath/unit_desc.h"

namespace repousse::shell {

/// The time that a batch takes, gathered while it passes through the units: each unit adds its
/// latency to the fill of the pipeline, and the busiest unit sets the rate. An estimate, as level
/// lt is: exact cycles are the business of level at.
class BatchTime {
public:
    /// A unit worked on `items` transactions, which kept it busy for `busy` cycles.
    void stage(const UnitDesc& desc, uint64_t items, uint64_t busy) {
        if (items == 0) return;
        fill_ += static_cast<uint64_t>(desc.latency);
        bottleneck_ = busy > bottleneck_ ? busy : bottleneck_;
    }

    /// As above for a unit of constant interval.
    void stage(const UnitDesc& desc, uint64_t items) {
        stage(desc, items, items * static_cast<uint64_t>(desc.interval));
    }

    /// Work of the same units that ran ahead of this batch, item after item: it keeps them busy,
    /// but fills the pipeline once.
    void ahead(const BatchTime& other) {
        fill_ = other.fill_ > fill_ ? other.fill_ : fill_;
        bottleneck_ += other.bottleneck_;
    }

    /// Cycles of a batch whose triangles belong to `contexts` contexts: a context waits for its
    /// own triangle to come round, so each of its triangles costs at least one fill.
    uint64_t cycles(uint64_t triangles, uint64_t contexts) const {
        const uint64_t waiting = (triangles + contexts - 1) / contexts * fill_;
        return bottleneck_ > waiting ? bottleneck_ : waiting;
    }

private:
    uint64_t fill_ = 0;
    uint64_t bottleneck_ = 0;
};

}  // namespace repousse::shell
