#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "datapath/items.h"
#include "datapath/numbers/cast.h"
#include "datapath/numbers/cordic.h"
#include "datapath/numbers/functions.h"
#include "datapath/numbers/log2.h"
#include "datapath/numbers/power.h"
#include "datapath/numbers/sine.h"
#include "datapath/numbers/vector_clones.h"

namespace repousse {

/// Straight-line attribute stages are written once, over one of the two policies below. A policy
/// says what a value is, how products and sums are formed at full precision (`Wide`), and where
/// precision is given up: only in `quantize` and in the closed functions.
///
/// `align(x, bits)` multiplies by 2^bits (floors, for negative bits) so that terms of different
/// fraction bits can be added or compared; doubles carry their own exponent, so Real ignores it.
/// `exact(raw, frac)` takes in an integer that stands for raw * 2^-frac: Fixed keeps the integer,
/// Real the value. `raw(x, frac)` is its inverse: the nearest integer, ties upwards.
/// `limit(format)` is the largest value that a format does not cut.

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
    /// The same for a batch: y[i] = quantize(cast, exact(i), overflows). Nothing that `exact` reads
    /// may lie in y.
    template <class Exact>
    static void quantize(const Cast& shared, std::size_t n, Value* y, uint64_t& overflows,
                         const Exact& exact) {
        const Cast cast = shared;  // a store to y cannot change it
        if (cast.kind() == CastKind::Clamp) {
            const Wide low = cast.steps().low, high = cast.steps().high;
            Wide outside = 0;  // negative if any value is
            REPOUSSE_INDEPENDENT
            for (std::size_t i = 0; i < n; ++i) {
                const Wide wanted = cast.quantize<CastKind::Clamp>(exact(i));
                outside |= (wanted - low) | (high - wanted);
                y[i] = static_cast<Value>(wanted);
            }
            if (outside >= 0) return;
        }
        for (std::size_t i = 0; i < n; ++i) y[i] = quantize(cast, exact(i), overflows);
    }
    static int32_t raw(Value x, int) { return x; }
    static Value limit(const Format& format) { return static_cast<Value>(format.max_raw()); }

    /// (x + bias) >> right, made of a logical shift, which vector registers have for each of their
    /// places.
    struct Shift {
        Shift() = default;
        /// Half up. Of 62 bits nothing is left after 63, as with more.
        explicit Shift(int bits)
            : right(static_cast<uint64_t>(bits < 0    ? 0
                                          : bits > 63 ? 63
                                                      : bits)),
              bias(kTop + ((uint64_t{1} << right) >> 1)),
              below(kTop >> right) {}
        Wide operator()(Wide x) const {
            return static_cast<Wide>(((static_cast<uint64_t>(x) + bias) >> right) - below);
        }

        static constexpr uint64_t kTop = uint64_t{1} << 63;
        uint64_t right = 0, bias = kTop, below = kTop;
    };

    /// A batch of vectors, one array a component, and the same to be written.
    struct Columns {
        std::array<const Value*, 3> from;
        std::array<Value*, 3> to;
    };

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
        /// A batch of n <= kFunctionBatch vectors, each times a mantissa and cast by an exponent.
        /// `to` is not `from`.
        void operator()(const Columns& vectors, const int32_t* mantissas, const int32_t* exponents,
                        std::size_t n) const;

    private:
        std::array<Cast, 64> casts_{};
    };

    /// v / |v| for components of at most 24 bits: squares 46 bits, their sum 48; v times the
    /// mantissa 24 + 29. The zero vector has no direction and stays zero; it is counted.
    class Normalise {
    public:
        Normalise(NormaliseKind kind, const InverseSqrt& inverse_sqrt, const Format& to)
            : kind_(kind), inverse_sqrt_(inverse_sqrt), cordic_(to.frac), round_(to) {}
        Vec3<Value> operator()(const Vec3<Value>& v, uint64_t& degenerate) const {
            const Wide square = mul(v.x, v.x) + mul(v.y, v.y) + mul(v.z, v.z);
            degenerate += square == 0;
            if (square == 0) return {};
            uint64_t saturated = 0;  // |v| rounds to one at most: not an event worth reporting
            if (kind_ == NormaliseKind::Cordic) {
                const auto [x, y, z] = cordic_(v.x, v.y, v.z);
                return {round_(x, cordic_.bits(), saturated), round_(y, cordic_.bits(), saturated),
                        round_(z, cordic_.bits(), saturated)};
            }
            const Scaled s = inverse_sqrt_(static_cast<uint64_t>(square));
            return {round_(mul(v.x, s.mantissa), s.exponent, saturated),
                    round_(mul(v.y, s.mantissa), s.exponent, saturated),
                    round_(mul(v.z, s.mantissa), s.exponent, saturated)};
        }
        /// A batch of n <= kFunctionBatch vectors. `to` is not `from`.
        void operator()(const Columns& vectors, std::size_t n, uint64_t& degenerate) const;

    private:
        NormaliseKind kind_;
        InverseSqrt inverse_sqrt_;
        Cordic cordic_;
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

    /// 1/c of a positive c, to be multiplied with several values.
    using Inverse = Scaled;
    static Inverse invert(const Reciprocal& reciprocal, Value c) {
        return reciprocal(static_cast<uint64_t>(c));
    }
    struct Inverses {
        std::array<int32_t, kFunctionBatch> mantissas, exponents;
    };
    static void invert(const Reciprocal& reciprocal, const Value* c, std::size_t n, Inverses& out) {
        reciprocal(c, n, out.mantissas.data(), out.exponents.data());
    }

    /// v * (1/c), 32 x 30 bits, rounded half up after a shift by the exponent of 1/c and saturated,
    /// whatever the modes of the format are. Precondition: v * 2^(frac of the result) over the
    /// least c fits 63 bits.
    class Quotient {
    public:
        Quotient(int frac_of_v, int frac_of_c, const Format& to)
            : shift_(frac_of_v - frac_of_c - to.frac), low_(to.min_raw()), high_(to.max_raw()) {}
        Value operator()(Value v, const Inverse& r, uint64_t& overflows) const {
            const int right = r.exponent + shift_;
            const Wide wanted = Shift(right)(align(mul(v, r.mantissa), right < 0 ? -right : 0));
            Wide value = wanted > high_ ? high_ : wanted;
            value = wanted < low_ ? low_ : value;
            overflows += value != wanted;
            return static_cast<Value>(value);
        }
        /// The same for `count` batches of n <= kFunctionBatch numbers; to[k] is not from[k].
        void operator()(const Value* const* from, Value* const* to, std::size_t count,
                        const Inverses& r, std::size_t n, uint64_t& overflows) const;

    private:
        int shift_;
        Wide low_, high_;
    };

    /// log2 of a value w > 0 with `frac` fraction bits, in OctaveLog2's fraction bits.
    static Wide log2(const OctaveLog2& table, Value w, int frac) {
        return table(static_cast<uint64_t>(w)) - mul(frac, Wide(1) << OctaveLog2::kFractionBits);
    }

    /// x^n of a cosine with `frac` fraction bits; 0 where x is not positive.
    class CosinePower {
    public:
        CosinePower(const Power& power, int frac, const Format& to)
            : power_(power), frac_(frac), round_(to) {}
        Value operator()(Value x, int n) const {
            const auto cosine = static_cast<uint64_t>(x < 0 ? 0 : x);
            const Scaled p = power_(cosine, frac_, static_cast<unsigned>(n));
            uint64_t saturated = 0;  // one at most: not an event worth reporting
            return round_(p.mantissa, p.exponent, saturated);
        }

    private:
        Power power_;
        int frac_;
        ShiftedCast round_;
    };

    /// {sine, cosine} of an angle in half turns.
    class SinCos {
    public:
        SinCos(int index_bits, int angle_frac, const Format& to)
            : sine_(index_bits, angle_frac), round_(Sine::kFractionBits, to) {}
        std::array<Value, 2> operator()(Value angle, uint64_t& overflows) const {
            return {quantize(round_, sine_.sin(angle), overflows),
                    quantize(round_, sine_.cos(angle), overflows)};
        }

    private:
        Sine sine_;
        Cast round_;
    };

    /// A vector of any length on its way into a normalisation: shifted, and rounded half up, until
    /// its largest component has bits - 1 bits with its sign. Rounding may need the last one.
    static Vec3<Value> scaled(const Vec3<Wide>& v, int bits) {
        const auto magnitude = [](Wide x) { return static_cast<uint64_t>(x ^ (x >> 63)); };
        const uint64_t any = magnitude(v.x) | magnitude(v.y) | magnitude(v.z);
        const int length = any == 0 ? 0 : 64 - __builtin_clzll(any);
        const int shift = length - (bits - 2);
        const Wide half = shift > 0 ? Wide(1) << (shift - 1) : 0;
        const auto component = [&](Wide x) { return static_cast<Value>(align(x + half, -shift)); };
        return {component(v.x), component(v.y), component(v.z)};
    }

    /// To an integer that stands for a fixed-point number at every level, as grid positions do.
    static int32_t round(const Cast& cast, Wide x, uint64_t& overflows) {
        return quantize(cast, x, overflows);
    }
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
    template <class Exact>
    static void quantize(const Cast&, std::size_t n, Value* y, uint64_t&, const Exact& exact) {
        REPOUSSE_INDEPENDENT
        for (std::size_t i = 0; i < n; ++i) y[i] = exact(i);
    }
    static int32_t raw(Value x, int frac) {
        return static_cast<int32_t>(std::floor(std::ldexp(x, frac) + 0.5));
    }
    static Value limit(const Format&) { return std::numeric_limits<double>::infinity(); }

    struct Columns {
        std::array<const Value*, 3> from;
        std::array<Value*, 3> to;
    };

    class Normalise {
    public:
        Normalise(NormaliseKind, const InverseSqrt&, const Format&) {}
        Vec3<Value> operator()(const Vec3<Value>& v, uint64_t& degenerate) const {
            const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
            degenerate += length == 0.0;
            if (length == 0.0) return {};
            return {v.x / length, v.y / length, v.z / length};
        }
        void operator()(const Columns& vectors, std::size_t n, uint64_t& degenerate) const {
            const auto& [from, to] = vectors;
            for (std::size_t i = 0; i < n; ++i) {
                const Vec3<Value> v = (*this)({from[0][i], from[1][i], from[2][i]}, degenerate);
                to[0][i] = v.x, to[1][i] = v.y, to[2][i] = v.z;
            }
        }
    };

    class Divide {
    public:
        Divide(const Reciprocal&, const Format&) {}
        std::array<Value, 2> operator()(Value x, Value y, Value w, uint64_t&) const {
            return {x / w, y / w};
        }
    };

    using Inverse = double;
    static Inverse invert(const Reciprocal&, Value c) { return 1.0 / c; }
    using Inverses = std::array<double, kFunctionBatch>;
    static void invert(const Reciprocal&, const Value* c, std::size_t n, Inverses& out) {
        for (std::size_t i = 0; i < n; ++i) out[i] = 1.0 / c[i];
    }

    class Quotient {
    public:
        Quotient(int, int, const Format&) {}
        Value operator()(Value v, const Inverse& r, uint64_t&) const { return v * r; }
        void operator()(const Value* const* from, Value* const* to, std::size_t count,
                        const Inverses& r, std::size_t n, uint64_t&) const {
            for (std::size_t k = 0; k < count; ++k) {
                for (std::size_t i = 0; i < n; ++i) to[k][i] = from[k][i] * r[i];
            }
        }
    };

    static Wide log2(const OctaveLog2&, Value w, int) { return std::log2(w); }

    class CosinePower {
    public:
        CosinePower(const Power&, int, const Format&) {}
        Value operator()(Value x, int n) const { return x > 0.0 ? std::pow(x, n) : 0.0; }
    };

    class SinCos {
    public:
        SinCos(int, int, const Format&) {}
        std::array<Value, 2> operator()(Value angle, uint64_t&) const {
            constexpr double kPi = 3.14159265358979323846;
            return {std::sin(kPi * angle), std::cos(kPi * angle)};
        }
    };

    static Vec3<Value> scaled(const Vec3<Wide>& v, int) { return v; }

    /// Rounds half up and saturates, whatever the modes of the cast's format.
    static int32_t round(const Cast& cast, Wide x, uint64_t& overflows) {
        const Format& to = cast.format();
        const double wanted = std::floor(std::ldexp(x, to.frac) + 0.5);
        const auto low = static_cast<double>(to.min_raw());
        const auto high = static_cast<double>(to.max_raw());
        double kept = wanted > high ? high : wanted;
        kept = kept >= low ? kept : low;  // also where x is no number
        overflows += kept != wanted;
        return static_cast<int32_t>(kept);
    }
};

}  // namespace repousse
