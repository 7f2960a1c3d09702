#pragma once

#include <string_view>

#include "datapath/span.h"

namespace repousse {

/// What a port of a unit carries.
enum class PortKind {
    Input,   ///< a field of each transaction the unit accepts
    Output,  ///< a field of each transaction the unit delivers
    Config,  ///< a register, stable while a frame is in the unit
};

/// One field at a unit's boundary. Its width comes from the profile, so that one number rules the
/// C++ model, the Verilog parameter and the vector file:
///   width = width of the entry `key` + `extra_bits`, signedness as `key` unless `is_unsigned`;
///   with an empty key the port is a plain integer of `extra_bits` bits, signed unless
///   `is_unsigned`.
/// The fraction bits are those of `key`: growth is always at the top. A vector port is flattened,
/// element 0 in the low bits; as words of a transaction its elements stand last to first, so that
/// words, most significant first, are what the port carries.
struct Port {
    PortKind kind;
    std::string_view name;
    std::string_view key;
    int extra_bits = 0;
    bool is_unsigned = false;
    std::string_view doc = {};
    std::string_view count_key = {};   ///< integer entry: elements of a vector port; none: a scalar
    std::string_view other_key = {};   ///< format entry: the width is that of the wider one
    std::string_view growth_key = {};  ///< integer entry whose value widens the port
};

/// The description of a unit: the one source of its ports and its timing. A printer turns it into
/// the Verilog parameters, the vectors' header and the tables of the sheet.
struct UnitDesc {
    std::string_view name;
    std::string_view paper;             ///< paper, section and equation it implements
    Span<const Port> ports;             ///< in transaction order, most significant first
    Span<const std::string_view> keys;  ///< every profile entry that changes a result
    int latency = 1;                    ///< cycles from accept to the first possible departure
    int interval = 1;                   ///< least cycles between two accepts
    int capacity = 1;                   ///< transactions the unit can hold
    int backward_latency = 0;           ///< 0: combinational ready, 1: registered ready
    /// Output port that is set in an item's last beat; none: each item leaves as one beat.
    std::string_view last_beat = {};
    /// Units that a Verilog top in rtl/tops is made of; none: a unit of its own in rtl/units.
    Span<const std::string_view> parts = {};
};

}  // namespace repousse
