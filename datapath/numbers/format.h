#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "datapath/error.h"

namespace repousse {

/// What becomes of the bits below the last one kept (IEEE 1666-2011, 7.10). The names are the
/// standard's. Every mode but SC_TRN* rounds to nearest; it is named after where a tie goes.
enum class Quantization : std::uint8_t {
    SC_TRN,          ///< floor
    SC_TRN_ZERO,     ///< toward zero
    SC_RND,          ///< tie toward plus infinity
    SC_RND_MIN_INF,  ///< tie toward minus infinity
    SC_RND_ZERO,     ///< tie toward zero
    SC_RND_INF,      ///< tie away from zero
    SC_RND_CONV,     ///< tie to the even neighbour
};

/// What becomes of a value outside the range of the format (IEEE 1666-2011, 7.10).
enum class Overflow : std::uint8_t {
    SC_WRAP,      ///< keep the low bits; the top `saturated_bits` of them saturate
    SC_SAT,       ///< nearest end of the range
    SC_SAT_ZERO,  ///< zero
    SC_SAT_SYM,   ///< nearest end of the range -max..max, so that -x always exists
    SC_WRAP_SM,   ///< sign-magnitude wrap, signed formats only
};

/// How a raw integer is to be read: value = raw * 2^-frac, `width` bits in two's complement.
/// `frac` may be negative (steps larger than one) or exceed `width` (leading fraction bits that are
/// never stored). A Format is data, not a type: another precision needs no recompilation.
struct Format {
    int width = 32;  ///< bits in all, the sign included: 1..63
    int frac = 0;    ///< fraction bits: -63..126
    bool is_signed = true;
    Quantization quantization = Quantization::SC_TRN;
    Overflow overflow = Overflow::SC_WRAP;
    int saturated_bits = 0;  ///< SC_WRAP and SC_WRAP_SM only: 0..width

    /// Bits left of the binary point, the sign not counted; negative if frac > width - is_signed.
    constexpr int integer_bits() const { return width - frac - (is_signed ? 1 : 0); }

    /// The ends of the container, as raw integers. An unsigned format has at most 63 bits, so that
    /// both ends fit an int64_t. (SC_SAT_SYM keeps results at -max_raw() or above.)
    constexpr std::int64_t min_raw() const {
        return is_signed ? -(std::int64_t{1} << (width - 1)) : 0;
    }
    constexpr std::int64_t max_raw() const {
        const int magnitude_bits = is_signed ? width - 1 : width;
        return static_cast<std::int64_t>((std::uint64_t{1} << magnitude_bits) - 1);
    }

    /// True if a raw integer is in the range of the container.
    constexpr bool contains(std::int64_t raw) const { return min_raw() <= raw && raw <= max_raw(); }
};

constexpr bool operator==(const Format& a, const Format& b) {
    return a.width == b.width && a.frac == b.frac && a.is_signed == b.is_signed &&
           a.quantization == b.quantization && a.overflow == b.overflow &&
           a.saturated_bits == b.saturated_bits;
}
constexpr bool operator!=(const Format& a, const Format& b) { return !(a == b); }

/// The limits that every Format obeys; see check_format.
constexpr int kMaxWidth = 63;
constexpr int kMinFrac = -63;
constexpr int kMaxFrac = 126;

/// Says which limit a Format breaks: width 1..63, frac -63..126, SC_WRAP_SM signed only,
/// saturated bits 0..width and only with a wrapping mode.
Status check_format(const Format& format);

/// Reads `s14.8` (sign, 14 integer bits, 8 fraction bits: 23 bits) or `u0.16`, then optionally the
/// modes, as `SC_RND SC_SAT`, and the saturated bits of a wrapping mode, as `SC_TRN SC_WRAP 3`.
/// What is left out has the standard's default: SC_TRN, SC_WRAP, 0. The parts are separated by one
/// blank each; integer and fraction bits may be negative (`s20.-4`). Nothing else is accepted.
Result<Format> parse_format(std::string_view text);

/// The one text of a format: parse_format(to_string(f)) == f, and defaults at the end are left out.
std::string to_string(const Format& format);

/// The standard's names, `SC_TRN` ... and `SC_WRAP` ...
std::string_view to_string(Quantization mode);
std::string_view to_string(Overflow mode);

}  // namespace repousse
