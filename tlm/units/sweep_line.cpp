#include "tlm/units/sweep_line.h"

#include <utility>

#include "datapath/pipelines/sweep.h"

namespace repousse::shell {

SweepLine::SweepLine(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name), unit_(sweep_options(profile)) {
    pieces_.reserve(kBatchRuns + kBatchBases);
}

void SweepLine::configure(std::function<bool(const BatchTime&)> elapse) {
    elapse_ = std::move(elapse);
    aborted_ = false;
    unit_.abort();
    // What the frame has no unit for stays 0.
    vertices_ = {};
}

void SweepLine::process(BaseBatch& batch, BatchTime&) {
    for (std::size_t i = 0; i < batch.items.size() && !aborted_; ++i) {
        const BaseItem& item = batch.items[i];
        if (item.rejected) {
            pieces_.push_back({item.base, 0, 0, true, false, nullptr});
        } else {
            sweep(item, batch.triangles[i]);
        }
    }
    flush();
}

void SweepLine::sweep(const BaseItem& item, const SweepTriangle& triangle) {
    unit_.load(triangle);
    while (true) {
        const std::size_t before = vertices_.size;
        const std::size_t runs =
            unit_.fill({runs_.data() + run_count_, runs_.size() - run_count_}, vertices_);
        run_count_ += runs;
        const bool last = !unit_.busy();
        // The status bit stays set for later triangles: only the end of one may flush the strip.
        pieces_.push_back({item.base, static_cast<uint32_t>(runs),
                           static_cast<uint32_t>(vertices_.size - before), last,
                           last && unit_.runaway(), &triangle.texel_steps});
        if (last) return;
        flush();
        if (aborted_) return unit_.abort();
    }
}

// The busy cycles are those of the steps: a base triangle without any passes beside.
void SweepLine::flush() {
    if (pieces_.empty()) return;
    const Span<const SweepRun> runs(runs_.data(), run_count_);
    FineBatch batch{pieces_, runs, vertices_};
    BatchTime time;
    time.stage(kSweepLineDesc, step_count(runs));
    fine_out->put(batch, time);
    pieces_.clear();
    run_count_ = vertices_.size = 0;
    if (!elapse_(time)) aborted_ = true;
}

}  // namespace repousse::shell
