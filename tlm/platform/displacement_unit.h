#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include <tlm_utils/simple_target_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>
#include <systemc>
#include <tlm>

#include "datapath/pipelines/adaptive_counters.h"
#include "tlm/config/device_config.h"
#include "tlm/memory/memory_port.h"
#include "tlm/platform/registers.h"
#include "tlm/units/bump.h"
#include "tlm/units/displace.h"
#include "tlm/units/edge_iter.h"
#include "tlm/units/height_test.h"
#include "tlm/units/mid_vertex.h"
#include "tlm/units/normal_test.h"
#include "tlm/units/split.h"
#include "tlm/units/texcoord_test.h"
#include "tlm/units/triangle_stack.h"
#include "tlm/units/vertex_transform.h"
#include "tlm/units/view_test.h"

namespace repousse::shell {

/// The displacement-mapping device, loosely timed.
///
/// | socket      | kind      | what for                                                        |
/// |-------------|-----------|-----------------------------------------------------------------|
/// | registers   | target    | 32-bit words, registers.h; b_transport, and debug reads         |
/// | memory_port | initiator | vertices, maps, tables and output, 64-bit addresses; uses DMI    |
/// | interrupt   | sc_out    | rises when a frame is done, has failed, or the output is full    |
///
/// One SC_THREAD runs frames with temporal decoupling; units hand batches on by interface calls.
/// Only the units that the configuration names are constructed. Several devices may live in one
/// simulation. A device is built once; reset restores its power-on state.
class DisplacementUnit : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<DisplacementUnit> registers{"registers"};
    MemoryPort memory_port{"memory_port"};
    sc_core::sc_out<bool> interrupt{"interrupt"};

    DisplacementUnit(const sc_core::sc_module_name& name, const DeviceConfig& config);

    /// Sum over all frames since the last reset; for reports, not for drivers.
    AdaptiveCounters counters() const;
    uint64_t cycles() const { return cycles_; }
    const BusyTable& busy() const { return triangle_stack_.busy(); }

    SC_HAS_PROCESS(DisplacementUnit);

private:
    // The registers as software sees them.
    void b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay);
    unsigned transport_dbg(tlm::tlm_generic_payload& trans);
    bool access(tlm::tlm_generic_payload& trans);
    uint32_t read_register(uint32_t index) const;
    void write_register(uint32_t index, uint32_t value);
    void reset();

    // The frame.
    void run_frames();
    FrameError run_frame();
    FrameError configure_units();
    FrameError bind_map();
    ViewRegisters<Fixed> camera() const;
    bool fetch(uint32_t index, Triangle<Fixed>& triangle);
    void emit(Span<const OutputTriangle<Fixed>> triangles);
    void elapse(uint64_t cycles);
    void raise(uint32_t status);
    void connect();
    bool has(Feature feature) const { return (frame_[kFeatures] & feature) != 0; }
    uint64_t address(Register low) const;

    DeviceConfig config_;
    sc_core::sc_time clock_period_;
    std::array<uint32_t, kRegisterCount> file_{};  // what software wrote
    std::array<uint32_t, kFrameEnd> frame_{};      // latched at the start of the frame
    uint32_t status_ = 0;
    uint32_t error_ = kNoError;
    uint32_t output_count_ = 0;
    uint64_t cycles_ = 0;
    const VertexRecord* vertices_ = nullptr;
    const uint32_t* indices_ = nullptr;
    bool bad_index_ = false;
    bool interrupt_level_ = false;
    sc_core::sc_event start_event_;
    sc_core::sc_event drained_event_;
    sc_core::sc_event interrupt_event_;
    tlm_utils::tlm_quantumkeeper quantum_;

    // Units; the optional ones are null where the configuration goes without.
    TriangleStack triangle_stack_;
    EdgeIter edge_iter_;
    MidVertex mid_vertex_;
    TexcoordTest texcoord_test_;
    Split split_;
    Displace displace_;
    std::unique_ptr<ViewTest> view_test_;
    std::unique_ptr<Bump> bump_;
    std::unique_ptr<NormalTest> normal_test_;
    std::unique_ptr<HeightTest> height_test_;
    std::unique_ptr<VertexTransform> vertex_transform_;
};

}  // namespace repousse::shell
