#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <tlm_utils/simple_target_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>
#include <systemc>
#include <tlm>

#include "datapath/pipelines/adaptive_counters.h"
#include "tlm/config/device_config.h"
#include "tlm/memory/memory_port.h"
#include "tlm/platform/adaptive_path.h"
#include "tlm/platform/frame_path.h"
#include "tlm/platform/registers.h"
#include "tlm/platform/sweep_path.h"

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
/// A frame goes through one of two paths, adaptive tessellation or sweep-line remeshing. Only the
/// units that the configuration names are constructed. Several devices may live in one simulation.
/// A device is built once; reset restores its power-on state.
class DisplacementUnit : public sc_core::sc_module, private FrameHost {
public:
    tlm_utils::simple_target_socket<DisplacementUnit> registers{"registers"};
    MemoryPort memory_port{"memory_port"};
    sc_core::sc_out<bool> interrupt{"interrupt"};

    DisplacementUnit(const sc_core::sc_module_name& name, const DeviceConfig& config);

    /// Sums over all frames since the last reset; for reports, not for drivers.
    std::vector<CounterRow> counters() const;
    uint64_t cycles() const { return cycles_; }
    BusyTable busy() const;

    SC_HAS_PROCESS(DisplacementUnit);

private:
    // The registers as software sees them.
    void b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay);
    unsigned transport_dbg(tlm::tlm_generic_payload& trans);
    bool access(tlm::tlm_generic_payload& trans);
    uint32_t read_register(uint32_t index) const;
    void write_register(uint32_t index, uint32_t value);
    void control(uint32_t value);
    void ring(uint32_t bell);
    void reset();
    void raise(uint32_t status);

    // The frame.
    void run_frames();
    FrameError run_frame();
    FramePath* path() const;
    template <class Record>
    void write(Span<const Record> records, Register low, Register capacity, uint32_t& count);
    void wait_until_drained();

    // What its path asks of the device.
    const FrameRegisters& frame() const override { return frame_; }
    bool memory_ok() const override { return memory_port.ok(); }
    const void* view(uint64_t address, uint64_t bytes) override;
    void write(Span<const OutputRecord> triangles) override;
    void write(Span<const FineTriangleRecord> triangles) override;
    void write(Span<const FineRecord> vertices) override;
    bool elapse(uint64_t cycles) override;

    sc_core::sc_time clock_period_;
    std::array<uint32_t, kRegisterCount> file_{};  // what software wrote
    FrameRegisters frame_;
    uint32_t status_ = 0;
    uint32_t error_ = kNoError;
    uint32_t output_count_ = 0;         // triangles in their output buffer
    uint32_t output_vertex_count_ = 0;  // vertices in theirs
    uint64_t cycles_ = 0;
    bool abort_ = false;
    bool interrupt_level_ = false;
    sc_core::sc_event start_event_;
    sc_core::sc_event drained_event_;  // or aborted
    sc_core::sc_event interrupt_event_;
    tlm_utils::tlm_quantumkeeper quantum_;

    SharedUnits shared_;
    // Null where the configuration goes without.
    std::unique_ptr<AdaptivePath> adaptive_;
    std::unique_ptr<SweepPath> sweep_;
};

}  // namespace repousse::shell
