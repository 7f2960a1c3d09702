#include "tlm/memory/memory.h"

#include <cstring>

namespace repousse::shell {

Memory::Memory(const sc_core::sc_module_name& name, uint64_t bytes, sc_core::sc_time latency,
               bool allow_dmi)
    : sc_module(name), bytes_(bytes), latency_(latency), allow_dmi_(allow_dmi) {
    socket.register_b_transport(this, &Memory::b_transport);
    socket.register_get_direct_mem_ptr(this, &Memory::get_direct_mem_ptr);
    socket.register_transport_dbg(this, &Memory::transport_dbg);
}

tlm::tlm_response_status Memory::access(tlm::tlm_generic_payload& trans) {
    const uint64_t address = trans.get_address();
    const uint64_t length = trans.get_data_length();
    if (trans.get_byte_enable_ptr() != nullptr) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
    if (trans.get_streaming_width() < length) return tlm::TLM_BURST_ERROR_RESPONSE;
    if (address > bytes_.size() || length > bytes_.size() - address) {
        return tlm::TLM_ADDRESS_ERROR_RESPONSE;
    }
    if (trans.is_read()) {
        std::memcpy(trans.get_data_ptr(), bytes_.data() + address, length);
    } else if (trans.is_write()) {
        std::memcpy(bytes_.data() + address, trans.get_data_ptr(), length);
    }
    return tlm::TLM_OK_RESPONSE;
}

void Memory::b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay) {
    trans.set_response_status(access(trans));
    trans.set_dmi_allowed(allow_dmi_);
    delay += latency_;
}

bool Memory::get_direct_mem_ptr(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
    if (!allow_dmi_) return false;
    dmi.set_dmi_ptr(bytes_.data());
    dmi.set_start_address(0);
    dmi.set_end_address(bytes_.size() - 1);
    dmi.set_read_latency(latency_);
    dmi.set_write_latency(latency_);
    dmi.allow_read_write();
    return true;
}

unsigned Memory::transport_dbg(tlm::tlm_generic_payload& trans) {
    const bool ok = access(trans) == tlm::TLM_OK_RESPONSE;
    return ok ? static_cast<unsigned>(trans.get_data_length()) : 0;
}

}  // namespace repousse::shell
