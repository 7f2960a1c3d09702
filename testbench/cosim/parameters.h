#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "datapath/profile.h"
#include "datapath/unit_desc.h"

namespace repousse::cosim {

/// One parameter of a unit's RTL.
struct Parameter {
    std::string name;
    int value = 0;
    std::string_view doc;
};

/// The parameters that a unit's profile entries become: `uv` gives UV_WIDTH and UV_FRAC,
/// `sat_width` gives SAT_WIDTH. The order is that of the description's keys.
std::vector<Parameter> parameters(const UnitDesc& desc, const Profile& profile);

/// How the word of a port is to be read under a profile.
Format port_format(const Port& port, const Profile& profile);

/// The low `width` bits of a word as they stand on the port, zero-extended.
uint64_t field_bits(int64_t word, const Format& format);

/// The word of those bits: sign-extended if the format is signed.
int64_t field_word(uint64_t bits, const Format& format);

/// `0x1a (1.625)`: the bits on the port and the value in the field's own unit.
std::string field_text(int64_t word, const Format& format);

/// One word of a transaction: a scalar port, or an element of a vector port.
struct PortWord {
    std::string name;  ///< the port's, with `[i]` behind it for an element
    Format format;
};

/// The words of the ports of one kind, in order.
std::vector<PortWord> port_words(const UnitDesc& desc, PortKind kind, const Profile& profile);

/// The elements of a port: 1 for a scalar.
int port_elements(const Port& port, const Profile& profile);

/// The output word that is set in an item's last beat; -1 if each item is one beat.
int last_word(const UnitDesc& desc, const Profile& profile);

}  // namespace repousse::cosim
