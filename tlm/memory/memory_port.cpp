#include "tlm/memory/memory_port.h"

#include <algorithm>
#include <cstring>

namespace repousse::shell {

MemoryPort::MemoryPort(const sc_core::sc_module_name& name) : sc_module(name) {
    socket.register_invalidate_direct_mem_ptr(this, &MemoryPort::invalidate);
}

// Transactions are cut so that their length fits the payload's unsigned int.
void MemoryPort::transport(tlm::tlm_command command, uint64_t address, void* data, uint64_t bytes,
                           sc_core::sc_time& delay) {
    constexpr uint64_t kBurst = uint64_t(1) << 30;
    auto* at = static_cast<unsigned char*>(data);
    while (bytes > 0 && ok_) {
        const auto length = static_cast<unsigned>(std::min(bytes, kBurst));
        trans_.set_command(command);
        trans_.set_address(address);
        trans_.set_data_ptr(at);
        trans_.set_data_length(length);
        trans_.set_streaming_width(length);
        trans_.set_byte_enable_ptr(nullptr);
        trans_.set_dmi_allowed(false);
        trans_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
        socket->b_transport(trans_, delay);
        ok_ = trans_.is_response_ok();
        address += length;
        at += length;
        bytes -= length;
    }
}

// One latency for a burst, as b_transport charges.
unsigned char* MemoryPort::direct(uint64_t address, uint64_t bytes, bool write,
                                  sc_core::sc_time& delay) {
    const auto inside = [&](const tlm::tlm_dmi& dmi) {
        return address >= dmi.get_start_address() && address + bytes - 1 <= dmi.get_end_address() &&
               (write ? dmi.is_write_allowed() : dmi.is_read_allowed());
    };
    auto region = std::find_if(regions_.begin(), regions_.end(), inside);
    if (region == regions_.end()) {
        tlm::tlm_dmi dmi;
        trans_.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
        trans_.set_address(address);
        if (!socket->get_direct_mem_ptr(trans_, dmi) || !inside(dmi)) return nullptr;
        region = regions_.insert(regions_.end(), dmi);
    }
    delay += write ? region->get_write_latency() : region->get_read_latency();
    return region->get_dmi_ptr() + (address - region->get_start_address());
}

void MemoryPort::read(uint64_t address, void* data, uint64_t bytes, sc_core::sc_time& delay) {
    if (bytes == 0) return;
    std::memset(data, 0, bytes);
    if (const unsigned char* from = direct(address, bytes, false, delay)) {
        std::memcpy(data, from, bytes);
    } else {
        transport(tlm::TLM_READ_COMMAND, address, data, bytes, delay);
    }
}

// b_transport never writes to the data of a write, so the constness is only the payload's.
void MemoryPort::write(uint64_t address, const void* data, uint64_t bytes,
                       sc_core::sc_time& delay) {
    if (bytes == 0) return;
    if (unsigned char* to = direct(address, bytes, true, delay)) {
        std::memcpy(to, data, bytes);
    } else {
        transport(tlm::TLM_WRITE_COMMAND, address, const_cast<void*>(data), bytes, delay);
    }
}

const void* MemoryPort::view(uint64_t address, uint64_t bytes, sc_core::sc_time& delay) {
    if (bytes == 0) return nullptr;
    if (const unsigned char* from = direct(address, bytes, false, delay)) return from;
    std::vector<unsigned char>& copy = copies_[address];
    copy.assign(bytes, 0);
    transport(tlm::TLM_READ_COMMAND, address, copy.data(), bytes, delay);
    return copy.data();
}

bool MemoryPort::moved() {
    const bool moved = moved_;
    moved_ = false;
    return moved;
}

void MemoryPort::clear() {
    ok_ = true;
    copies_.clear();
}

void MemoryPort::invalidate(sc_dt::uint64, sc_dt::uint64) {
    regions_.clear();
    moved_ = true;
}

}  // namespace repousse::shell
