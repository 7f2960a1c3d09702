#include "tlm/platform/displacement_unit.h"

#include <cstring>

namespace repousse::shell {

DisplacementUnit::DisplacementUnit(const sc_core::sc_module_name& name, const DeviceConfig& config)
    : sc_module(name),
      config_(config),
      clock_period_(config.clock_period_ns, sc_core::SC_NS),
      triangle_stack_("triangle_stack", config.contexts),
      edge_iter_("edge_iter"),
      mid_vertex_("mid_vertex", config.profile),
      texcoord_test_("texcoord_test", config.profile),
      split_("split", config.profile),
      displace_("displace", config.profile) {
    const Profile& profile = config.profile;
    if (config.view_test) {
        view_test_ = std::make_unique<ViewTest>("view_test", profile);
        vertex_transform_ = std::make_unique<VertexTransform>("vertex_transform", profile);
    }
    if (config.bump || config.normal_test) bump_ = std::make_unique<Bump>("bump", profile);
    if (config.normal_test) normal_test_ = std::make_unique<NormalTest>("normal_test", profile);
    if (config.height_test) height_test_ = std::make_unique<HeightTest>("height_test", profile);
    connect();

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

// The chain in the hardware's order (Doggett and Hirche, figure 8): the serial tests, the decision,
// what only new vertices need. A unit that was not built leaves no gap.
void DisplacementUnit::connect() {
    EdgePlace* last = &edge_iter_;
    const auto then = [&last](EdgePlace& place) {
        last->out.bind(place.in);
        last = &place;
    };
    triangle_stack_.out.bind(edge_iter_.in);
    then(mid_vertex_.topology);
    then(texcoord_test_);
    if (view_test_) then(*view_test_);
    if (normal_test_) {
        then(mid_vertex_.before_test);
        then(bump_->before_test);
        then(*normal_test_);
    }
    if (height_test_) then(*height_test_);
    then(split_);
    then(mid_vertex_.after_split);
    if (bump_) then(bump_->after_split);
    then(displace_);
    if (vertex_transform_) then(*vertex_transform_);
    triangle_stack_.children.bind(split_.children);

    BasePlace* last_base = &displace_;
    triangle_stack_.base_out.bind(displace_.base_in);
    const auto then_base = [&last_base](BasePlace& place) {
        last_base->base_out.bind(place.base_in);
        last_base = &place;
    };
    if (bump_) then_base(*bump_);
    if (vertex_transform_) then_base(*vertex_transform_);
}

AdaptiveCounters DisplacementUnit::counters() const {
    AdaptiveCounters c;
    c.stack_peak = triangle_stack_.peak();
    c.edge_iter = edge_iter_.counters();
    c.mid_vertex = mid_vertex_.counters();
    c.texcoord_test = texcoord_test_.counters();
    c.displace = displace_.counters();
    c.split = split_.counters();
    if (vertex_transform_) c.vertex_transform = vertex_transform_->counters();
    if (view_test_) c.view_test = view_test_->counters();
    if (bump_) c.bump = bump_->counters();
    if (normal_test_) c.normal_test = normal_test_->counters();
    if (height_test_) {
        c.height_test = height_test_->counters();
        c.height_test_reads = height_test_->stats().reads;
    }
    return c;
}

void DisplacementUnit::reset() {
    file_ = {};
    frame_ = {};
    status_ = error_ = output_count_ = 0;
    cycles_ = 0;
    interrupt_level_ = false;
    interrupt_event_.notify(sc_core::SC_ZERO_TIME);
    memory_port.clear();
    triangle_stack_.reset();
    edge_iter_.reset();
    mid_vertex_.reset();
    texcoord_test_.reset();
    displace_.reset();
    split_.reset();
    if (vertex_transform_) vertex_transform_->reset();
    if (view_test_) view_test_->reset();
    if (bump_) bump_->reset();
    if (normal_test_) normal_test_->reset();
    if (height_test_) height_test_->reset();
}

uint32_t DisplacementUnit::read_register(uint32_t index) const {
    switch (index) {
        case kId:
            return kIdValue;
        case kStatus:
            return status_;
        case kErrorCode:
            return error_;
        case kOutputCount:
            return output_count_;
        case kCyclesLo:
            return static_cast<uint32_t>(cycles_);
        case kCyclesHi:
            return static_cast<uint32_t>(cycles_ >> 32);
        default:
            return file_[index];
    }
}

void DisplacementUnit::write_register(uint32_t index, uint32_t value) {
    const bool busy = (status_ & kStatusBusy) != 0;
    file_[index] = index == kControl ? value & 1 : value;
    if (index == kControl && (value & 2) != 0 && !busy) {
        reset();
    } else if (index == kDoorbell && value == kStart && !busy) {
        std::copy(file_.begin(), file_.begin() + kFrameEnd, frame_.begin());
        status_ = kStatusBusy;
        error_ = kNoError;
        start_event_.notify(sc_core::SC_ZERO_TIME);
    } else if (index == kDoorbell && value == kDrained && (status_ & kStatusOutputFull) != 0) {
        drained_event_.notify(sc_core::SC_ZERO_TIME);
    } else if (index == kInterrupt) {
        interrupt_level_ = false;
        interrupt_event_.notify(sc_core::SC_ZERO_TIME);
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
