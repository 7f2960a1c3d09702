#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

#include "datapath/span.h"
#include "datapath/unit_desc.h"

namespace repousse::shell {

/// How long a unit was busy.
struct UnitBusy {
    const UnitDesc* unit = nullptr;
    uint64_t cycles = 0;
};

/// Busy cycles by unit, in the order in which the units first worked.
class BusyTable {
public:
    void add(const UnitDesc& unit, uint64_t cycles) {
        UnitBusy* end = rows_.data() + count_;
        UnitBusy* row =
            std::find_if(rows_.data(), end, [&](const UnitBusy& r) { return r.unit == &unit; });
        if (row == end) {
            assert(count_ < rows_.size());
            *row = {&unit, 0};
            ++count_;
        }
        row->cycles += cycles;
    }

    void add(const BusyTable& other) {
        for (const UnitBusy& row : other.rows()) add(*row.unit, row.cycles);
    }

    Span<const UnitBusy> rows() const { return {rows_.data(), count_}; }

private:
    std::array<UnitBusy, 32> rows_{};  // more than a device has units
    std::size_t count_ = 0;
};

/// The time that a batch takes, gathered while it passes through the units: each unit adds its
/// latency to the fill of the pipeline, and the busiest unit sets the rate. An estimate, as level
/// lt is: exact cycles are the business of level at.
class BatchTime {
public:
    /// A unit worked on `items` transactions, which kept it busy for `busy` cycles; its latency
    /// where that is not the description's own. Reports refer to the description, so it must be
    /// one of the constants.
    void stage(const UnitDesc& desc, uint64_t items, uint64_t busy, int latency) {
        if (items == 0) return;
        fill_ += static_cast<uint64_t>(latency);
        busy_.add(desc, busy);
    }
    void stage(const UnitDesc& desc, uint64_t items, uint64_t busy) {
        stage(desc, items, busy, desc.latency);
    }

    /// As above for a unit of constant interval.
    void stage(const UnitDesc& desc, uint64_t items) {
        stage(desc, items, items * static_cast<uint64_t>(desc.interval));
    }

    /// Work of the same units that ran ahead of this batch, item after item: it keeps them busy,
    /// but fills the pipeline once.
    void ahead(const BatchTime& other) {
        fill_ = std::max(fill_, other.fill_);
        busy_.add(other.busy_);
    }

    /// Cycles of a batch whose triangles belong to `contexts` contexts: a context waits for its
    /// own triangle to come round, so each of its triangles costs at least one fill.
    uint64_t cycles(uint64_t triangles, uint64_t contexts) const {
        return std::max((triangles + contexts - 1) / contexts * fill_, busiest());
    }

    uint64_t fill() const { return fill_; }  ///< sum of the latencies
    uint64_t busiest() const {
        uint64_t most = 0;
        for (const UnitBusy& row : busy_.rows()) most = std::max(most, row.cycles);
        return most;
    }
    const BusyTable& busy() const { return busy_; }

private:
    uint64_t fill_ = 0;
    BusyTable busy_;
};

/// The time of a frame whose batches only go forward, so that the pipeline fills once. Batches of
/// base triangles are *outer* ones; what the sweep line makes of one of them leaves in *inner* ones
/// before the outer one ends. Both halves of the pipeline work at once: an outer batch takes as
/// long as the slower half.
class StreamTime {
public:
    /// Cycles that pass with an inner batch.
    uint64_t inner(const BatchTime& time) {
        inner_cycles_ += time.busiest();
        return time.busiest() + filled(inner_fill_, time);
    }

    /// Cycles that pass at the end of an outer batch, beyond those of its inner ones.
    uint64_t outer(const BatchTime& time) {
        const uint64_t passed = std::min(inner_cycles_, time.busiest());
        inner_cycles_ = 0;
        return time.busiest() - passed + filled(outer_fill_, time);
    }

private:
    // A unit that no batch before has used is filled now.
    static uint64_t filled(uint64_t& fill, const BatchTime& time) {
        const uint64_t more = std::max(fill, time.fill()) - fill;
        fill += more;
        return more;
    }

    uint64_t inner_cycles_ = 0;  // of the outer batch under way
    uint64_t inner_fill_ = 0;
    uint64_t outer_fill_ = 0;
};

}  // namespace repousse::shell
