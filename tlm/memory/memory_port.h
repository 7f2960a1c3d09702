#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <tlm_utils/simple_initiator_socket.h>
#include <systemc>
#include <tlm>

namespace repousse::shell {

/// An initiator's access to memory: through DMI where it is granted, through b_transport where it
/// is not, with the delay of either added to the caller's local time.
///
/// Failures do not throw: `ok()` turns false and stays so until `clear()`, and what was read is
/// zero.
class MemoryPort : public sc_core::sc_module {
public:
    tlm_utils::simple_initiator_socket<MemoryPort> socket{"socket"};

    explicit MemoryPort(const sc_core::sc_module_name& name);

    void read(uint64_t address, void* data, uint64_t bytes, sc_core::sc_time& delay);
    void write(uint64_t address, const void* data, uint64_t bytes, sc_core::sc_time& delay);

    /// A pointer to `bytes` bytes of memory, valid until `moved()` says otherwise: straight into
    /// the target's memory, or a copy fetched in one burst. Null for no bytes.
    const void* view(uint64_t address, uint64_t bytes, sc_core::sc_time& delay);

    /// Whether DMI pointers were taken back since the last call: views must be asked for again.
    bool moved();

    bool ok() const { return ok_; }
    void clear();

private:
    void transport(tlm::tlm_command command, uint64_t address, void* data, uint64_t bytes,
                   sc_core::sc_time& delay);
    unsigned char* direct(uint64_t address, uint64_t bytes, bool write, sc_core::sc_time& delay);
    void invalidate(sc_dt::uint64 start, sc_dt::uint64 end);

    tlm::tlm_generic_payload trans_;
    std::vector<tlm::tlm_dmi> regions_;
    std::map<uint64_t, std::vector<unsigned char>> copies_;  // by address
    bool moved_ = false;
    bool ok_ = true;
};

}  // namespace repousse::shell
