#pragma once

#include <functional>
#include <vector>

#include "datapath/profile.h"
#include "datapath/units/sweep_line.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The sweep line in the device: datapath/units/sweep_line.h with its timing. Where base triangles
/// turn into steps, which go on in batches of their own; the batch of base triangles ends here.
class SweepLine : public Place<BaseBatch> {
public:
    sc_core::sc_port<Stage<FineBatch>> fine_out{"fine_out"};

    SweepLine(const sc_core::sc_module_name& name, const Profile& profile);

    /// `elapse` is called after each batch of steps; false: the frame is aborted, and what is in
    /// the unit is dropped.
    void configure(std::function<bool(const BatchTime&)> elapse);
    void reset() { unit_.reset(); }
    bool runaway() const { return unit_.runaway(); }
    const SweepLineCounters& counters() const { return unit_.counters(); }

private:
    void process(BaseBatch& batch, BatchTime& time) override;
    void sweep(const BaseItem& item, const SweepTriangle& triangle);
    void flush();

    repousse::SweepLine unit_;
    std::function<bool(const BatchTime&)> elapse_;
    bool aborted_ = false;

    // The batch under way.
    std::vector<FinePiece> pieces_;
    std::array<SweepRun, kBatchRuns> runs_;
    std::size_t run_count_ = 0;
    FineVertices<Fixed> vertices_;
};

}  // namespace repousse::shell
