#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <systemc>

#include "datapath/error.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/draw.h"
#include "datapath/pipelines/sweep_draw.h"
#include "tlm/memory/memory_port.h"
#include "tlm/platform/registers.h"

namespace repousse::shell {

/// Work for the device: one object, by one of the two methods.
using Draw = std::variant<AdaptiveDraw<Fixed>, SweepDraw<Fixed>>;

/// What one draw gave, in architectural order: the alternative of its draw.
using DrawOutput = std::variant<std::vector<OutputTriangle<Fixed>>, SweepMesh<Fixed>>;

/// Where the driver finds the device and lays out its buffers.
struct AddressMap {
    uint64_t device = 0;  ///< base of the registers
    uint64_t memory = 0;  ///< base of the memory
    uint64_t memory_bytes = 0;
    uint32_t output_capacity = 1;  ///< triangles, and fine vertices, in an output buffer
};

/// Bytes of memory that a draw's buffers take, the output buffer included.
uint64_t buffer_bytes(const Draw& draw, uint32_t output_capacity);

/// A processor that plays the driver: for each draw it writes vertices, maps and tables to memory,
/// programs the registers, rings the doorbell, sleeps until the interrupt and collects the output.
class Driver : public sc_core::sc_module {
public:
    MemoryPort port{"port"};
    sc_core::sc_in<bool> interrupt{"interrupt"};

    Driver(const sc_core::sc_module_name& name, const AddressMap& map);

    /// Sets the work of the next run; to be called while the kernel stands still. The draws must
    /// outlive the run.
    void start(Span<const Draw> draws);

    /// One output a draw, once the run has ended.
    std::vector<DrawOutput> take_outputs() { return std::move(outputs_); }
    const Status& status() const { return status_; }

    SC_HAS_PROCESS(Driver);

private:
    void drive();
    void drive_all();
    bool run(const Draw& draw, DrawOutput& output);
    template <class Record>
    Span<const Record> output(uint64_t address, uint32_t count);
    void collect(std::vector<OutputTriangle<Fixed>>& triangles);
    void collect(SweepMesh<Fixed>& mesh);

    // A draw in memory and registers: driver_draw.cpp.
    void upload(const Draw& draw);
    void upload_bases(const AdaptiveDraw<Fixed>& draw);
    void upload_bases(const SweepDraw<Fixed>& draw);
    void program(const AdaptiveDraw<Fixed>& draw);
    void program(const SweepDraw<Fixed>& draw);
    template <class D>
    void program_common(const D& draw);
    void program_shade(const ShadeRegisters<Fixed>& registers);
    void place(Register low, const void* data, uint64_t bytes);

    void set(uint32_t index, uint32_t word);
    void set(uint32_t index, int32_t word) { set(index, static_cast<uint32_t>(word)); }
    void set(uint32_t index, const Vec3<int32_t>& vector);
    void set(uint32_t index, const Colour<int32_t>& colour);
    void set_address(Register low, uint64_t address);
    uint32_t get(uint32_t index);

    AddressMap map_;
    Span<const Draw> draws_;
    std::vector<DrawOutput> outputs_;
    Status status_ = done();
    uint64_t next_address_ = 0;
    uint64_t output_address_ = 0;
    uint64_t output_vertices_address_ = 0;
    sc_core::sc_time local_time_;
    sc_core::sc_event start_event_;
};

}  // namespace repousse::shell
