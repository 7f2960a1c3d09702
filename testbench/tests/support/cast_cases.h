#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "datapath/numbers/format.h"

namespace repousse::test {

/// Holds any kept part times 2^62: 66 + 62 bits.
__extension__ using Wide = __int128;

/// One combination of modes. Saturated bits come in five classes, because each has its own row in
/// the standard: 0, 1, some, width - 1, and all of them.
struct CastGroup {
    bool is_signed = true;
    Quantization quantization = Quantization::SC_TRN;
    Overflow overflow = Overflow::SC_WRAP;
    int saturated_class = 0;  ///< 0..4

    int saturated_bits(int width, std::mt19937_64& random) const {
        switch (saturated_class) {
            case 0:
                return 0;
            case 1:
                return 1;
            case 2:
                return 1 + static_cast<int>(random() % static_cast<unsigned>(width));
            case 3:
                return width - 1;
            default:
                return width;
        }
    }
};

/// Every pair of modes: 7 quantizations x (3 saturations + wrap + sign-magnitude wrap), signed and
/// unsigned (which has no sign-magnitude wrap), each wrap in its five classes.
inline std::vector<CastGroup> all_cast_groups() {
    std::vector<CastGroup> groups;
    for (int sign = 0; sign < 2; ++sign) {
        for (int q = 0; q < 7; ++q) {
            for (int o = 0; o < 5; ++o) {
                const auto overflow = static_cast<Overflow>(o);
                const bool magnitude = overflow == Overflow::SC_WRAP_SM;
                if (magnitude && sign == 0) continue;
                const int classes = magnitude || overflow == Overflow::SC_WRAP ? 5 : 1;
                for (int c = 0; c < classes; ++c) {
                    groups.push_back({sign == 1, static_cast<Quantization>(q), overflow, c});
                }
            }
        }
    }
    return groups;
}

/// A target format and the number of bits dropped (negative: gained) on the way to it. Most targets
/// are narrow, so that random values meet the ends of their range; one in eight has any width.
struct CastTarget {
    Format format;
    int dropped = 0;
};

inline CastTarget random_target(const CastGroup& group, std::mt19937_64& random) {
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    CastTarget target;
    target.format.width = below(8) == 0 ? 1 + below(kMaxWidth) : 1 + below(24);
    target.format.is_signed = group.is_signed;
    target.format.quantization = group.quantization;
    target.format.overflow = group.overflow;
    target.format.saturated_bits = group.saturated_bits(target.format.width, random);
    switch (below(16)) {
        case 0:
            target.dropped = -below(20);
            break;
        case 1:
            target.dropped = below(63);
            break;
        default:
            target.dropped = below(24);
            break;
    }
    return target;
}

/// A source value in the range of a Cast. Three in four are put where a mistake would show: at the
/// ends of the target's range, at a multiple of its wrap, at ties, or next to any of these.
inline std::int64_t random_source(const CastTarget& target, std::mt19937_64& random) {
    const int left = target.dropped < 0 ? -target.dropped : 0;
    const int right = target.dropped > 0 ? target.dropped : 0;
    const int width = target.format.width;
    const auto any = [&](int bits) { return static_cast<std::int64_t>(random()) >> (64 - bits); };
    const auto near_zero = [&] { return static_cast<std::int64_t>(random() % 5) - 2; };

    // The kept part, in target LSB; 60 bits leave room for three more than the format has.
    Wide y = any(1 + static_cast<int>(random() % 60) % (width + 3));
    switch (random() % 8) {
        case 0:
            y = static_cast<Wide>(target.format.max_raw()) + near_zero();
            break;
        case 1:
            y = static_cast<Wide>(target.format.min_raw()) + near_zero();
            break;
        case 2:
            y = any(4) * (static_cast<Wide>(1) << width) + near_zero();
            break;
        default:
            break;
    }
    // The dropped part: a tie or beside it, nothing or beside it, anything.
    Wide x = left > 0 ? y >> left : y * (static_cast<Wide>(1) << right);
    switch (random() % 4) {
        case 0:
            x += right > 0 ? (static_cast<Wide>(1) << (right - 1)) + near_zero() : 0;
            break;
        case 1:
            x += near_zero();
            break;
        default:
            x += right > 0 ? any(right + 1) : 0;
            break;
    }
    const Wide limit = static_cast<Wide>(1) << (62 - left);
    return -limit <= x && x < limit ? static_cast<std::int64_t>(x) : any(63 - left);
}

}  // namespace repousse::test
