#include "tlm/memory/bus.h"

namespace repousse::shell {

Bus::Bus(const sc_core::sc_module_name& name) : sc_module(name) {
    initiators.register_b_transport(this, &Bus::b_transport);
    initiators.register_get_direct_mem_ptr(this, &Bus::get_direct_mem_ptr);
    initiators.register_transport_dbg(this, &Bus::transport_dbg);
    targets.register_invalidate_direct_mem_ptr(this, &Bus::invalidate_direct_mem_ptr);
}

int Bus::route(tlm::tlm_generic_payload& trans) const {
    const uint64_t address = trans.get_address();
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
        if (address >= ranges_[i].base && address - ranges_[i].base < ranges_[i].size) {
            trans.set_address(address - ranges_[i].base);
            return static_cast<int>(i);
        }
    }
    return -1;
}

void Bus::b_transport(int, tlm::tlm_generic_payload& trans, sc_core::sc_time& delay) {
    const uint64_t address = trans.get_address();
    const int target = route(trans);
    if (target < 0) {
        trans.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    targets[target]->b_transport(trans, delay);
    trans.set_address(address);
}

bool Bus::get_direct_mem_ptr(int, tlm::tlm_generic_payload& trans, tlm::tlm_dmi& dmi) {
    const uint64_t address = trans.get_address();
    const int target = route(trans);
    if (target < 0) return false;
    const bool granted = targets[target]->get_direct_mem_ptr(trans, dmi);
    const uint64_t base = ranges_[static_cast<std::size_t>(target)].base;
    dmi.set_start_address(dmi.get_start_address() + base);
    dmi.set_end_address(dmi.get_end_address() + base);
    trans.set_address(address);
    return granted;
}

unsigned Bus::transport_dbg(int, tlm::tlm_generic_payload& trans) {
    const uint64_t address = trans.get_address();
    const int target = route(trans);
    if (target < 0) return 0;
    const unsigned count = targets[target]->transport_dbg(trans);
    trans.set_address(address);
    return count;
}

void Bus::invalidate_direct_mem_ptr(int id, sc_dt::uint64 start, sc_dt::uint64 end) {
    const uint64_t base = ranges_[static_cast<std::size_t>(id)].base;
    for (unsigned i = 0; i < initiators.size(); ++i) {
        initiators[static_cast<int>(i)]->invalidate_direct_mem_ptr(start + base, end + base);
    }
}

}  // namespace repousse::shell
