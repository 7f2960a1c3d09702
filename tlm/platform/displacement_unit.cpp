#include "tlm/platform/displacement_unit.h"

#include <cstring>

namespace repousse::shell {

DisplacementUnit::DisplacementUnit(const sc_core::sc_module_name& name, const DeviceConfig& config)
    : sc_module(name), clock_period_(config.clock_period_ns, sc_core::SC_NS), shared_(config) {
    FrameHost& host = *this;
    if (config.adaptive) adaptive_ = std::make_unique<AdaptivePath>(config, shared_, host);
    if (config.has_controller()) sweep_ = std::make_unique<SweepPath>(config, shared_, host);

    registers.register_b_transport(this, &DisplacementUnit::b_transport);
    registers.register_transport_dbg(this, &DisplacementUnit::transport_dbg);
    SC_THREAD(run_frames);
    // The interrupt is a wire with one driver, whichever process changes its level.
    const auto drive = [this] { interrupt.write(interrupt_level_); };
    sc_core::sc_spawn_options options;
    options.spawn_method();
    options.set_sensitivity(&interrupt_event_);
    sc_core::sc_spawn(drive, "drive_interrupt", &options);
}

// The shared units count for both paths: their numbers must enter the sum once.
std::vector<CounterRow> DisplacementUnit::counters() const {
    std::vector<CounterRow> rows;
    if (adaptive_) rows = adaptive_->counters().rows();
    if (!sweep_) return rows;
    SweepCounters sweep = sweep_->counters();
    if (adaptive_) {
        sweep.displace = {};
        if (sweep.bump) sweep.bump = BumpCounters{};
        if (sweep.shade) sweep.shade = ShadeCounters{};
        sweep.vertex_transform = {};
    }
    merge_rows(rows, sweep.rows());
    return rows;
}

BusyTable DisplacementUnit::busy() const {
    BusyTable total;
    if (adaptive_) total.add(adaptive_->busy());
    if (sweep_) total.add(sweep_->busy());
    return total;
}

void DisplacementUnit::reset() {
    file_ = {};
    frame_.clear();
    status_ = error_ = output_count_ = output_vertex_count_ = 0;
    cycles_ = 0;
    interrupt_level_ = false;
    interrupt_event_.notify(sc_core::SC_ZERO_TIME);
    memory_port.clear();
    if (shared_.displace) shared_.displace->reset();
    if (shared_.bump) shared_.bump->reset();
    if (shared_.shade) shared_.shade->reset();
    if (shared_.vertex_transform) shared_.vertex_transform->reset();
    if (adaptive_) adaptive_->reset();
    if (sweep_) sweep_->reset();
}

uint32_t DisplacementUnit::read_register(uint32_t index) const {
    switch (index) {
        case kId:
            return kIdValue;
        case kStatus:
            return status_ | (sweep_ ? sweep_->status() : 0);
        case kErrorCode:
            return error_;
        case kOutputCount:
            return output_count_;
        case kOutputVertexCount:
            return output_vertex_count_;
        case kCyclesLo:
            return static_cast<uint32_t>(cycles_);
        case kCyclesHi:
            return static_cast<uint32_t>(cycles_ >> 32);
        default:
            return file_[index];
    }
}

void DisplacementUnit::write_register(uint32_t index, uint32_t value) {
    file_[index] = value;
    if (index == kControl) {
        control(value);
    } else if (index == kDoorbell) {
        ring(value);
    } else if (index == kInterrupt) {
        interrupt_level_ = false;
        interrupt_event_.notify(sc_core::SC_ZERO_TIME);
    }
}

void DisplacementUnit::control(uint32_t value) {
    const bool busy = (status_ & kStatusBusy) != 0;
    file_[kControl] = value & kControlInterrupts;
    if ((value & kControlReset) != 0 && !busy) {
        reset();
    } else if ((value & kControlAbort) != 0 && busy) {
        abort_ = true;
        drained_event_.notify(sc_core::SC_ZERO_TIME);
    }
}

void DisplacementUnit::ring(uint32_t bell) {
    if (bell == kStart && (status_ & kStatusBusy) == 0) {
        frame_.latch(file_);
        status_ = kStatusBusy;
        error_ = kNoError;
        abort_ = false;
        start_event_.notify(sc_core::SC_ZERO_TIME);
    } else if (bell == kDrained && (status_ & kStatusOutputFull) != 0) {
        drained_event_.notify(sc_core::SC_ZERO_TIME);
    }
}

bool DisplacementUnit::access(tlm::tlm_generic_payload& trans) {
    const uint64_t address = trans.get_address();
    trans.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
    if (trans.get_data_length() != 4 || trans.get_streaming_width() < 4) return false;
    trans.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
    if (trans.get_byte_enable_ptr() != nullptr) return false;
    trans.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    if (address % 4 != 0 || address / 4 >= kRegisterCount) return false;
    const auto index = static_cast<uint32_t>(address / 4);
    uint32_t value = 0;
    if (trans.is_write()) {
        std::memcpy(&value, trans.get_data_ptr(), sizeof value);
        write_register(index, value);
    } else if (trans.is_read()) {
        value = read_register(index);
        std::memcpy(trans.get_data_ptr(), &value, sizeof value);
    }
    trans.set_response_status(tlm::TLM_OK_RESPONSE);
    return true;
}

void DisplacementUnit::b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay) {
    access(trans);
    delay += clock_period_;
}

unsigned DisplacementUnit::transport_dbg(tlm::tlm_generic_payload& trans) {
    // Looking must not change anything, and a write here would ring bells.
    return trans.is_read() && access(trans) ? 4 : 0;
}

}  // namespace repousse::shell
