#pragma once

#include <cstdint>
#include <vector>

#include <tlm_utils/multi_passthrough_initiator_socket.h>
#include <tlm_utils/multi_passthrough_target_socket.h>
#include <systemc>
#include <tlm>

namespace repousse::shell {

/// A memory-mapped bus for any number of initiators and targets: it routes by address, rebases the
/// address for the target, passes DMI through with the range rebased back, and adds no time.
/// Addresses outside of every range get TLM_ADDRESS_ERROR_RESPONSE.
class Bus : public sc_core::sc_module {
public:
    tlm_utils::multi_passthrough_target_socket<Bus> initiators{"initiators"};
    tlm_utils::multi_passthrough_initiator_socket<Bus> targets{"targets"};

    explicit Bus(const sc_core::sc_module_name& name);

    /// The next target that is bound to `targets` answers at [base, base + size).
    void map(uint64_t base, uint64_t size) { ranges_.push_back({base, size}); }

private:
    struct Range {
        uint64_t base;
        uint64_t size;
    };

    void b_transport(int id, tlm::tlm_generic_payload& trans, sc_core::sc_time& delay);
    bool get_direct_mem_ptr(int id, tlm::tlm_generic_payload& trans, tlm::tlm_dmi& dmi);
    unsigned transport_dbg(int id, tlm::tlm_generic_payload& trans);
    void invalidate_direct_mem_ptr(int id, sc_dt::uint64 start, sc_dt::uint64 end);

    /// The target of an address, or -1; rebases the transaction's address on success.
    int route(tlm::tlm_generic_payload& trans) const;

    std::vector<Range> ranges_;
};

}  // namespace repousse::shell
