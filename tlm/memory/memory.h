#pragma once

#include <cstdint>
#include <vector>

#include <tlm_utils/simple_target_socket.h>
#include <systemc>
#include <tlm>

namespace repousse::shell {

/// A RAM behind a TLM-2.0 target socket.
///
/// - b_transport: reads and writes of any length inside the memory; `latency` a transaction.
///   Byte enables and wrapping streams are answered with the standard error responses.
/// - DMI: the whole memory, readable and writable, unless `allow_dmi` is false.
/// - transport_dbg: as b_transport, without time.
class Memory : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Memory> socket{"socket"};

    Memory(const sc_core::sc_module_name& name, uint64_t bytes, sc_core::sc_time latency,
           bool allow_dmi = true);

    uint64_t size() const { return bytes_.size(); }

    /// Takes back every DMI pointer, as a memory that is remapped would.
    void invalidate() { socket->invalidate_direct_mem_ptr(0, bytes_.size() - 1); }

private:
    void b_transport(tlm::tlm_generic_payload& trans, sc_core::sc_time& delay);
    bool get_direct_mem_ptr(tlm::tlm_generic_payload& trans, tlm::tlm_dmi& dmi);
    unsigned transport_dbg(tlm::tlm_generic_payload& trans);
    tlm::tlm_response_status access(tlm::tlm_generic_payload& trans);

    std::vector<unsigned char> bytes_;
    sc_core::sc_time latency_;
    bool allow_dmi_;
};

}  // namespace repousse::shell
