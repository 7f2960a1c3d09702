#pragma once

#include <functional>
#include <vector>

#include "datapath/units/controller.h"
#include "datapath/units/controller_desc.h"
#include "tlm/sweep_stage.h"

namespace repousse::shell {

/// The Controller Unit in the device: datapath/units/controller.h with its timing. It is the start
/// of both chains of sweep-line remeshing: base vertices go to the grid when a triangle first needs
/// them, and are kept there for the frame; base triangles follow in batches, and a direct one goes
/// to the triangle buffer.
class Controller : public sc_core::sc_module {
public:
    // Not bound in a device that displaces nothing.
    sc_core::sc_port<Stage<CornerBatch>, 1, sc_core::SC_ZERO_OR_MORE_BOUND> corners_out{
        "corners_out"};
    sc_core::sc_port<Stage<BaseBatch>, 1, sc_core::SC_ZERO_OR_MORE_BOUND> out{"out"};
    sc_core::sc_port<OrderSink> order{"order"};

    Controller(const sc_core::sc_module_name& name, const Profile& profile);

    /// What a frame gives to the controller and wants from it.
    struct Frame {
        uint32_t vertex_count = 0;
        uint32_t triangle_count = 0;
        bool use_bump = false;
        /// Memory; they may move while time passes.
        std::function<const VertexRecord&(uint32_t)> vertex;
        std::function<const SweepRecord&(uint32_t)> base;
        /// Called after each batch of base triangles; false: the frame is aborted.
        std::function<bool(const BatchTime&)> elapse;
    };

    /// How a frame's reading ended.
    enum class Outcome { Done, Aborted, BadIndex, BadDescriptor, MissingUnit };

    /// Works until no base triangle is left. After an error, those before it have been worked on.
    Outcome run(const Frame& frame);

    void reset() { unit_.reset(); }
    const ControllerCounters& counters() const { return unit_.counters(); }

private:
    Outcome gather(const Frame& frame, uint32_t& next);
    void send_direct(const Frame& frame, const OrderToken& token, const SweepRecord& record);
    void transform_new(BatchTime& time);

    repousse::Controller<Fixed> unit_;
    std::vector<GridVertex> table_;  // by base vertex
    std::vector<bool> known_;        // which of them are there
    // The batch: its triangles, and the vertices that nobody has asked for before.
    std::vector<BaseItem> items_;
    std::vector<SweepTriangle> triangles_;
    std::vector<Vertex<Fixed>> new_vertices_;
    std::vector<GridVertex> new_corners_;
};

}  // namespace repousse::shell
