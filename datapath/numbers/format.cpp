#include "datapath/numbers/format.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace repousse {
namespace {

constexpr std::array<std::string_view, 7> kQuantizationNames = {
    "SC_TRN",      "SC_TRN_ZERO", "SC_RND",     "SC_RND_MIN_INF",
    "SC_RND_ZERO", "SC_RND_INF",  "SC_RND_CONV"};
constexpr std::array<std::string_view, 5> kOverflowNames = {"SC_WRAP", "SC_SAT", "SC_SAT_ZERO",
                                                            "SC_SAT_SYM", "SC_WRAP_SM"};

bool wraps(Overflow mode) { return mode == Overflow::SC_WRAP || mode == Overflow::SC_WRAP_SM; }

/// The position of a name in its enumeration.
template <class Mode, std::size_t N>
std::optional<Mode> find_mode(const std::array<std::string_view, N>& names, std::string_view name) {
    for (std::size_t i = 0; i < N; ++i) {
        if (names[i] == name) return static_cast<Mode>(i);
    }
    return std::nullopt;
}

template <std::size_t N>
std::string one_of(const std::array<std::string_view, N>& names) {
    std::string text = "one of";
    for (std::string_view name : names) text += " " + std::string(name);
    return text;
}

/// A decimal integer of at most three digits: no plus sign, no leading zero, no `-0`.
std::optional<int> parse_int(std::string_view text) {
    const bool negative = !text.empty() && text.front() == '-';
    if (negative) text.remove_prefix(1);
    if (text.empty() || text.size() > 3) return std::nullopt;
    if (text.front() == '0' && (text.size() > 1 || negative)) return std::nullopt;
    int value = 0;
    for (char digit : text) {
        if (digit < '0' || digit > '9') return std::nullopt;
        value = 10 * value + (digit - '0');
    }
    return negative ? -value : value;
}

/// Splits at every single blank; two blanks in a row give an empty part, which nothing accepts.
std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t blank = text.find(' '); blank != text.npos; blank = text.find(' ')) {
        parts.push_back(text.substr(0, blank));
        text.remove_prefix(blank + 1);
    }
    parts.push_back(text);
    return parts;
}

Error bad(std::string_view text, std::string_view part, std::string expected) {
    return Error{ErrorKind::Input, "",
                 "format '" + std::string(text) + "' has no meaning at '" + std::string(part) + "'",
                 std::move(expected), ""};
}

Error out_of_limits(const std::string& what, std::string expected) {
    return Error{ErrorKind::Input, "", what, std::move(expected), ""};
}

}  // namespace

Status check_format(const Format& format) {
    const auto range = [](int low, int high) {
        return std::to_string(low) + " to " + std::to_string(high);
    };
    if (format.width < 1 || format.width > kMaxWidth) {
        return out_of_limits("a format of " + std::to_string(format.width) + " bits in all",
                             range(1, kMaxWidth));
    }
    if (format.frac < kMinFrac || format.frac > kMaxFrac) {
        return out_of_limits("a format of " + std::to_string(format.frac) + " fraction bits",
                             range(kMinFrac, kMaxFrac));
    }
    if (format.overflow == Overflow::SC_WRAP_SM && !format.is_signed) {
        return out_of_limits("SC_WRAP_SM in an unsigned format", "a signed format");
    }
    if (format.saturated_bits != 0 && !wraps(format.overflow)) {
        return out_of_limits("saturated bits with " + std::string(to_string(format.overflow)),
                             "SC_WRAP or SC_WRAP_SM");
    }
    if (format.saturated_bits < 0 || format.saturated_bits > format.width) {
        return out_of_limits(std::to_string(format.saturated_bits) + " saturated bits",
                             range(0, format.width));
    }
    return done();
}

Result<Format> parse_format(std::string_view text) {
    const std::vector<std::string_view> parts = split(text);
    const std::string_view size = parts[0];
    const std::size_t dot = size.find('.');
    const bool has_sign = !size.empty() && (size[0] == 's' || size[0] == 'u');
    if (!has_sign || dot == size.npos) {
        return bad(text, size, "s or u, integer bits, a dot and fraction bits, as s14.8 or u0.16");
    }
    const std::optional<int> integer = parse_int(size.substr(1, dot - 1));
    const std::optional<int> frac = parse_int(size.substr(dot + 1));
    if (!integer) return bad(text, size.substr(0, dot), "integer bits between the letter and '.'");
    if (!frac) return bad(text, size.substr(dot), "fraction bits after '.'");

    Format format;
    format.is_signed = size[0] == 's';
    format.frac = *frac;
    format.width = *integer + *frac + (format.is_signed ? 1 : 0);
    if (parts.size() > 1) {
        const auto mode = find_mode<Quantization>(kQuantizationNames, parts[1]);
        if (!mode) return bad(text, parts[1], one_of(kQuantizationNames));
        format.quantization = *mode;
    }
    if (parts.size() > 2) {
        const auto mode = find_mode<Overflow>(kOverflowNames, parts[2]);
        if (!mode) return bad(text, parts[2], one_of(kOverflowNames));
        format.overflow = *mode;
    }
    if (parts.size() > 3) {
        const std::optional<int> bits = parse_int(parts[3]);
        if (!bits || !wraps(format.overflow)) {
            return bad(text, parts[3], "saturated bits, and only after SC_WRAP or SC_WRAP_SM");
        }
        format.saturated_bits = *bits;
    }
    if (parts.size() > 4) return bad(text, parts[4], "the end of the format");

    if (Status status = check_format(format); !status) {
        Error error = status.error();
        error.what = "format '" + std::string(text) + "': " + error.what;
        return error;
    }
    return format;
}

std::string to_string(const Format& format) {
    std::string text = format.is_signed ? "s" : "u";
    text += std::to_string(format.integer_bits()) + "." + std::to_string(format.frac);
    const bool default_overflow =
        format.overflow == Overflow::SC_WRAP && format.saturated_bits == 0;
    if (format.quantization == Quantization::SC_TRN && default_overflow) return text;
    text += " " + std::string(to_string(format.quantization));
    if (default_overflow) return text;
    text += " " + std::string(to_string(format.overflow));
    if (format.saturated_bits != 0) text += " " + std::to_string(format.saturated_bits);
    return text;
}

std::string_view to_string(Quantization mode) {
    return kQuantizationNames[static_cast<std::size_t>(mode)];
}

std::string_view to_string(Overflow mode) { return kOverflowNames[static_cast<std::size_t>(mode)]; }

}  // namespace repousse
