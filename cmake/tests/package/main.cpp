// Compiles and links against the installed libraries alone: a header of the datapath, the shipped
// profiles out of repousse::config, and SystemC with TLM as the package's dependency.
#include <systemc>
#include <tlm>

#include "datapath/error.h"
#include "tlm/config/shipped_profiles.h"

int sc_main(int, char*[]) {
    tlm::tlm_generic_payload payload;
    sc_core::sc_start(sc_core::SC_ZERO_TIME);
    const bool profiles_are_there = repousse::shipped_profiles().size() > 0;
    return profiles_are_there && payload.get_address() == 0 ? 0 : 1;
}
