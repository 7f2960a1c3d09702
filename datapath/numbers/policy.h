#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/cast.h"
#include "datapath/numbers/functions.h"

namespace repousse {

/// Straight-line attribute stages are written once, over one of the two policies below. A policy
/// says what a value is, how products and sums are formed at full precision (`Wide`), and where
/// precision is given up: only in `quantize` and in the closed functions.
///
/// `align(x, bits)` multiplies by 2^bits (floors, for negative bits) so that terms of different
/// fraction bits can be added or compared; doubles carry their own exponent, so Real ignores it.
/// `exact(raw, frac)` takes in an integer that stands for raw * 2^-frac: Fixed keeps the integer,
/// Real the value.

/// Bit-accurate: raw two's-complement integers, formats beside them.
struct Fixed {
    using Value = int32_t;
    using Wide = int64_t;
    using Texel = int16_t;  ///< a component of a stored normal map

    static Wide mul(Wide a, Wide b) { return a * b; }
    static Wide align(Wide x, int bits) { return bits >= 0 ? x * (Wide(1) << bits) : x >> -bits; }
    static Wide half(Wide sum) { return sum >> 1; }
    static Wide exact(int64_t raw, int) { return raw; }
    static Value quantize(const Cast& cast, Wide x, uint64_t& overflows) {
        return static_cast<Value>(cast(x, overflows));
    }

    /// One prepared cast for each exponent that a closed function can return: the rounding after
    /// a data-dependent shift. 64 shifts cover every 64-bit product.
    class ShiftedCast {
    public:
        ShiftedCast() = default;
        explicit ShiftedCast(const Format& to) {
            for (int e = 0; e < 64; ++e) casts_[static_cast<std::size_t>(e)] = Cast(e, to);
        }
        Value operator()(Wide x, int exponent, uint64_t& overflows) const {
            return quantize(casts_[static_cast<std::size_t>(exponent)], x, overflows);
        }

    private:
        std::array<Cast, 64> casts_{};
    };

    /// v / |v| for components of at most 19 bits: squares 36 bits, their sum 38, which leaves room
    /// for v times the mantissa (19 + 24 bits). The zero vector has no direction and stays zero;
    /// it is counted.
    class Normalise {
    public:
        Normalise(const InverseSqrt& inverse_sqrt, const Format& to)
            : inverse_sqrt_(&inverse_sqrt), round_(to) {}
        Vec3<Value> operator()(const Vec3<Value>& v, uint64_t& degenerate) const {
            const Wide square = mul(v.x, v.x) + mul(v.y, v.y) + mul(v.z, v.z);
            degenerate += square == 0;
            if (square == 0) return {};
            const Scaled s = (*inverse_sqrt_)(static_cast<uint64_t>(square));
            uint64_t saturated = 0;  // |v| rounds to one at most: not an event worth reporting
            return {round_(mul(v.x, s.mantissa), s.exponent, saturated),
                    round_(mul(v.y, s.mantissa), s.exponent, saturated),
                    round_(mul(v.z, s.mantissa), s.exponent, saturated)};
        }

    private:
        const InverseSqrt* inverse_sqrt_;
        ShiftedCast round_;
    };

    /// x / w and y / w for w > 0: one reciprocal, two products (32 + 25 bits).
    class Divide {
    public:
        Divide(const Reciprocal& reciprocal, const Format& to)
            : reciprocal_(&reciprocal), round_(to) {}
        std::array<Value, 2> operator()(Value x, Value y, Value w, uint64_t& overflows) const {
            const Scaled r = (*reciprocal_)(static_cast<uint64_t>(w));
            return {round_(mul(x, r.mantissa), r.exponent, overflows),
                    round_(mul(y, r.mantissa), r.exponent, overflows)};
        }

    private:
        const Reciprocal* reciprocal_;
        ShiftedCast round_;
    };
};

/// The same stages in double: what they would give if no bit were ever dropped. The only double
/// in datapath/.
struct Real {
    using Value = double;
    using Wide = double;
    using Texel = double;

    static Wide mul(Wide a, Wide b) { return a * b; }
    static Wide align(Wide x, int) { return x; }
    static Wide half(Wide sum) { return sum * 0.5; }
    static Wide exact(int64_t raw, int frac) { return std::ldexp(static_cast<double>(raw), -frac); }
    static Value quantize(const Cast&, Wide x, uint64_t&) { return x; }

    class Normalise {
    public:
        Normalise(const InverseSqrt&, const Format&) {}
        Vec3<Value> operator()(const Vec3<Value>& v, uint64_t& degenerate) const {
            const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
            degenerate += length == 0.0;
            if (length == 0.0) return {};
            return {v.x / length, v.y / length, v.z / length};
        }
    };

    class Divide {
    public:
        Divide(const Reciprocal&, const Format&) {}
        std::array<Value, 2> operator()(Value x, Value y, Value w, uint64_t&) const {
            return {x / w, y / w};
        }
    };
};

}  // namespace repousse
