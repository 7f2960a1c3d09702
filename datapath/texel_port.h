#pragma once

#include <cstdint>

namespace repousse {

/// Bits of the index of a word in a unit's table: 2^14 x 2^14 texels, and with the filter levels
/// below them 4/3 as many, stay below 2^29; one bit to spare.
inline constexpr int kTexelAddressBits = 30;

/// What listens at the read port of a map-reading unit: a cache that counts, or a record of the
/// reads. It sees every read of the unit in the unit's own order. Values never pass here: they come
/// from the table, whatever listens, so a unit without a listener computes the same.
class TexelPort {
public:
    virtual ~TexelPort() = default;

    /// The unit reads the word `address` of its table, below 2^kTexelAddressBits:
    ///   displace      the texel's number in the map, row by row; levels follow one another
    ///   bump          the normal's number in the map, row by row
    ///   height_test   the number of an entry of the (W + 1) x (H + 1) prefix sums, row by row
    virtual void read(uint32_t address) = 0;
};

/// The read ports of a pipeline's units; null: nobody listens.
struct TexelPorts {
    TexelPort* displace = nullptr;
    TexelPort* bump = nullptr;
    TexelPort* height_test = nullptr;
};

}  // namespace repousse
