#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/units/bump.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// How a texel lies in a word of bump's read port: the components of a normal, a height, or two
/// angles, the first in the low bits.
class BumpTexel {
public:
    explicit BumpTexel(const Profile& profile);

    BumpKind kind() const { return kind_; }
    int fields() const { return fields_; }
    int field_bits() const { return field_bits_; }
    int bits() const { return fields_ * field_bits_; }
    uint64_t mask() const { return (uint64_t{1} << bits()) - 1; }

    /// The word of the first fields() values, cut to field_bits() each.
    uint64_t word(const std::array<int32_t, 3>& values) const;
    /// A field of a word, signed.
    int16_t field(uint64_t word, int i) const;

private:
    BumpKind kind_;
    int fields_;
    int field_bits_;
};

/// The registers of a map: slopes of `mantissa` along u and of two thirds of it along v.
std::vector<int64_t> bump_registers(const Table& table, bool wrap, int32_t mantissa, int exponent);

/// The hard cases of bump, of its profile's kind, by name.
std::vector<Scenario> bump_cases(const Profile& profile);

}  // namespace repousse::cosim
