#include "tlm/units/sweep_line.h"

#include <utility>

#include "datapath/pipelines/sweep.h"

namespace repousse::shell {

SweepLine::SweepLine(const sc_core::sc_module_name& name, const Profile& profile)
    : Place(name), unit_(sweep_options(profile)), steps_(kBatchSweepSteps) {
    pieces_.reserve(kBatchSweepSteps + kBatchBases);
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
    pieces_.push_back({item.base, 0, 0, false, false, &triangle.texel_steps});
    while (true) {
        if (step_count_ == steps_.size() || vertices_.size + 4 > kFineVertices) {
            flush();
            if (aborted_) return unit_.abort();
            pieces_.push_back({item.base, 0, 0, false, false, &triangle.texel_steps});
        }
        SweepStep& step = steps_[step_count_];
        if (!unit_.step(step)) break;
        ++step_count_;
        ++pieces_.back().steps;
        pieces_.back().vertices += step.vertex_count;
        for (std::size_t i = 0; i < step.vertex_count; ++i) {
            vertices_.push_back(step.vertices[i].name, step.vertices[i].data);
        }
    }
    pieces_.back().last = true;
    pieces_.back().runaway = unit_.runaway();
}

// The busy cycles are those of the steps: a base triangle without any passes beside.
void SweepLine::flush() {
    if (pieces_.empty()) return;
    FineBatch batch{pieces_, {steps_.data(), step_count_}, vertices_};
    BatchTime time;
    time.stage(kSweepLineDesc, step_count_);
    fine_out->put(batch, time);
    pieces_.clear();
    step_count_ = vertices_.size = 0;
    if (!elapse_(time)) aborted_ = true;
}

}  // namespace repousse::shell
