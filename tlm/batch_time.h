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
    std::array<UnitBusy, 16> rows_{};  // a device has eleven units
    std::size_t count_ = 0;
};

/// The time that a batch takes, gathered while it passes through the units: each unit adds its
/// latency to the fill of the pipeline, and the busiest unit sets the rate. An estimate, as level
/// lt is: exact cycles are the business of level at.
class BatchTime {
public:
    /// A unit worked on `items` transactions, which kept it busy for `busy` cycles.
    void stage(const UnitDesc& desc, uint64_t items, uint64_t busy) {
        if (items == 0) return;
        fill_ += static_cast<uint64_t>(desc.latency);
        busy_.add(desc, busy);
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
        uint64_t most = (triangles + contexts - 1) / contexts * fill_;
        for (const UnitBusy& row : busy_.rows()) most = std::max(most, row.cycles);
        return most;
    }

    const BusyTable& busy() const { return busy_; }

private:
    uint64_t fill_ = 0;
    BusyTable busy_;
};

}  // namespace repousse::shell
