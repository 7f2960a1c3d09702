#include "datapath/profile.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace repousse {
namespace {

constexpr ProfileEntry format_entry(std::string_view key, Format Profile::*member, bool is_signed,
                                    int low, int high, std::string_view doc) {
    return {key, member, nullptr, low, high, is_signed, doc};
}

constexpr ProfileEntry integer_entry(std::string_view key, int Profile::*member, int low, int high,
                                     std::string_view doc) {
    return {key, nullptr, member, low, high, false, doc};
}

// Values are held in 32 bits, products and sums in 64; the upper width limits follow from that
// and from the rules in check_growth.
constexpr std::array kEntries = {
    format_entry("uv", &Profile::uv, true, 4, 31, "texture coordinates, in texels"),
    integer_entry("sat_width", &Profile::sat_width, 8, 39, "stored bits of the summed-area table"),
    format_entry("height", &Profile::height, false, 1, 16, "a texel of the displacement map"),
    format_entry("map_normal", &Profile::map_normal, true, 3, 16, "a component of N_D"),
    format_entry("position", &Profile::position, true, 4, 32, "P and P', in world units"),
    format_entry("normal", &Profile::normal, true, 3, 20, "components of N and T"),
    format_entry("displaced_normal", &Profile::displaced_normal, true, 3, 20, "components of N'"),
    format_entry("filtered_height", &Profile::filtered_height, false, 1, 32, "a bilinear height"),
    format_entry("displacement", &Profile::displacement, true, 4, 32, "D, in world units"),
    format_entry("unnormalised", &Profile::unnormalised, true, 4, 24, "a vector to be normalised"),
    format_entry("diagonal", &Profile::diagonal, true, 4, 30, "differences of P' in split"),
    integer_entry("bump_kind", &Profile::bump_kind, 0, 2,
                  "displaced normals by: 0 stored normals, 1 differences of heights, 2 two angles"),
    format_entry("slope", &Profile::slope, true, 4, 24, "derivatives of D along T and B"),
    format_entry("angle", &Profile::angle, true, 3, 16, "a stored rotation angle, in half turns"),
    integer_entry("sine_index_bits", &Profile::sine_index_bits, 2, 10,
                  "log2 of the sine table's entries"),
    integer_entry("cache_line_bits", &Profile::cache_line_bits, 0, 5,
                  "log2 of the texels in a line of a texel cache"),
    integer_entry("cache_set_bits", &Profile::cache_set_bits, 0, 12,
                  "log2 of the sets of a texel cache"),
    integer_entry("cache_ways", &Profile::cache_ways, 1, 8, "lines in a set of a texel cache"),
    integer_entry("cache_replacement", &Profile::cache_replacement, 0, 1,
                  "of the line that is replaced: 0 the oldest, 1 the least recently used"),
    format_entry("view_row", &Profile::view_row, true, 4, 28, "right, up and forward"),
    format_entry("clip", &Profile::clip, true, 4, 32, "P' in eye space"),
    format_entry("ndc", &Profile::ndc, true, 4, 32, "eye-space x/w and y/w"),
    format_entry("focal", &Profile::focal, true, 4, 30, "pixels per unit of x/w; the centre"),
    format_entry("screen", &Profile::screen, true, 3, 30, "pixels"),
    format_entry("sweep_data", &Profile::sweep_data, true, 4, 32, "attributes times c"),
    format_entry("inverse_w", &Profile::inverse_w, true, 4, 32, "c = w_scale / w"),
    format_entry("steps_per_octave", &Profile::steps_per_octave, false, 4, 30,
                 "grid steps in depth for each doubling of w"),
    integer_entry("z_table_kind", &Profile::z_table_kind, 0, 2,
                  "depth table: 0 uniform, 1 linear by octaves, 2 quadratic by octaves"),
    integer_entry("z_table_index_bits", &Profile::z_table_index_bits, 1, 16,
                  "log2 of the depth table's entries"),
    integer_entry("adder_kind", &Profile::adder_kind, 0, 2,
                  "adders of the sweep: 0 plain, 1 canonical, 2 exact"),
    integer_entry("guard_bits", &Profile::guard_bits, 0, 13,
                  "below the LSB of sweep_data; exact adders need none"),
    integer_entry("column_depth", &Profile::column_depth, 0, 256,
                  "vertices in the column FIFO; 0: one lane"),
    integer_entry("components", &Profile::components, 1, 13,
                  "components of a vertex that the sweep's registers hold"),
    integer_entry("dividers", &Profile::dividers, 1, 65, "dividers of the triangle setup"),
    format_entry("cosine", &Profile::cosine, true, 4, 22, "a cosine in the illumination"),
    format_entry("light", &Profile::light, false, 2, 20, "a light's colour times the material's"),
    format_entry("colour", &Profile::colour, false, 1, 20, "a vertex's colour"),
    integer_entry("lights", &Profile::lights, 1, 8, "lights of the illumination"),
    integer_entry("power_log_index_bits", &Profile::power_log_index_bits, 1, 5,
                  "log2 of the logarithm's table in x^n"),
    integer_entry("power_exp_index_bits", &Profile::power_exp_index_bits, 1, 8,
                  "log2 of the exponential's table in x^n"),
    integer_entry("normalise_kind", &Profile::normalise_kind, 0, 1,
                  "unit vectors by: 0 inverse square root, 1 CORDIC"),
    integer_entry("inverse_sqrt_index_bits", &Profile::inverse_sqrt_index_bits, 2, 12,
                  "log2 of the inverse square root's table"),
    integer_entry("inverse_sqrt_newton_steps", &Profile::inverse_sqrt_newton_steps, 0, 5,
                  "Newton steps of the inverse square root"),
    integer_entry("inverse_sqrt_bits", &Profile::inverse_sqrt_bits, 8, 29,
                  "mantissa bits of the inverse square root"),
    integer_entry("reciprocal_index_bits", &Profile::reciprocal_index_bits, 2, 12,
                  "log2 of the reciprocal's table"),
    integer_entry("reciprocal_newton_steps", &Profile::reciprocal_newton_steps, 0, 5,
                  "Newton steps of the reciprocal"),
    integer_entry("reciprocal_bits", &Profile::reciprocal_bits, 8, 30,
                  "mantissa bits of the reciprocal"),
};

Error bad_value(std::string_view key, std::string what, std::string expected) {
    return {ErrorKind::Input, std::string(key), std::move(what), std::move(expected), {}};
}

std::string range_text(int low, int high) {
    return std::to_string(low) + " to " + std::to_string(high);
}

Status set_format(Profile& profile, const ProfileEntry& entry, const std::string& text) {
    const Result<Format> parsed = parse_format(text);
    if (!parsed) {
        Error error = parsed.error();
        error.where = std::string(entry.key);
        return error;
    }
    if (parsed->is_signed != entry.is_signed) {
        return bad_value(entry.key, "wrong signedness in \"" + text + "\"",
                         entry.is_signed ? "a signed format, like s14.8" : "an unsigned format");
    }
    if (parsed->width < entry.low || parsed->width > entry.high) {
        return bad_value(entry.key, "width " + std::to_string(parsed->width) + " is out of range",
                         range_text(entry.low, entry.high) + " bits");
    }
    profile.*entry.format = *parsed;
    return done();
}

Status set_integer(Profile& profile, const ProfileEntry& entry, const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code != std::errc{} || stop != end || value < entry.low || value > entry.high) {
        return bad_value(entry.key, "\"" + text + "\" is not possible",
                         "an integer, " + range_text(entry.low, entry.high));
    }
    profile.*entry.integer = value;
    return done();
}

// One rule a line: the sum of widths that an exact intermediate result needs must stay below the
// 64th bit, and terms that are added must align by left shifts.
Status check_growth(const Profile& p) {
    struct Rule {
        std::string_view key;
        int bits;
        std::string_view of;
    };
    const int displaced_frac = p.displacement.frac + p.normal.frac;
    const int corrected_frac = std::max({p.position.frac, p.unnormalised.frac, p.uv.frac});
    const int reach_bits = std::max(
        p.clip.width, p.displacement.width + std::max(0, p.clip.frac - p.displacement.frac));
    const std::array rules = {
        Rule{"filtered_height", p.filtered_height.width + kScaleBits, "height * scale"},
        Rule{"displacement", p.displacement.width + p.normal.width + 1, "P + D * N"},
        Rule{"position", p.position.width + displaced_frac - p.position.frac + 1, "P + D * N"},
        Rule{"view_row", p.position.width + 1 + p.view_row.width + 2, "row . (P' - eye)"},
        Rule{"reciprocal_bits", p.clip.width + p.reciprocal_bits + 1, "x * (1/w)"},
        Rule{"ndc", p.ndc.width + p.focal.width + 1, "x/w * focal + centre"},
        Rule{"inverse_w", p.position.width + p.inverse_w.frac + 1, "P * c, c <= 1"},
        Rule{"inverse_w", corrected_frac + p.inverse_w.frac + p.sweep_data.integer_bits() + 2,
             "P * c over the least c"},
        Rule{"clip", reach_bits + p.view_row.frac + 2, "a reach of the view volume"},
        Rule{"diagonal", 2 * p.diagonal.width + 1, "the squared length of a diagonal"},
        Rule{"unnormalised", 2 * p.unnormalised.width + 2, "a squared length"},
        Rule{"inverse_sqrt_bits", p.unnormalised.width + p.inverse_sqrt_bits + 1, "v / |v|"},
        Rule{"map_normal", p.normal.width + p.map_normal.width + 2, "T nx + B ny + N nz"},
        Rule{"slope", p.normal.width + std::max(p.slope.width, p.slope.frac + 2) + 2,
             "N - s_u T - s_v B"},
    };
    for (const Rule& rule : rules) {
        if (rule.bits > 63) {
            return bad_value(rule.key,
                             std::string(rule.of) + " needs " + std::to_string(rule.bits) + " bits",
                             "at most 63; narrow the formats it is made of");
        }
    }
    if (displaced_frac < p.position.frac) {
        return bad_value("displacement", "D * N has fewer fraction bits than the position",
                         "displacement.frac + normal.frac >= position.frac");
    }
    if (p.inverse_w.integer_bits() < 1) {
        return bad_value("inverse_w", "no room for c = 1", "at least one integer bit, like s1.30");
    }
    if (p.cosine.integer_bits() < 1 || p.cosine.frac < 1) {
        return bad_value("cosine", "no room for a cosine of 1, or for less than 1",
                         "at least one integer and one fraction bit, like s1.16");
    }
    if (p.filtered_height.frac < p.height.frac) {
        return bad_value("filtered_height", "fewer fraction bits than the height itself",
                         "at least " + std::to_string(p.height.frac));
    }
    if (p.normal.frac < p.displaced_normal.frac || p.normal.frac < p.map_normal.frac) {
        return bad_value("normal", "fewer fraction bits than map_normal or displaced_normal",
                         "at least as many, so that one threshold serves both");
    }
    // A slope is a product of 42 bits, raised by its fraction bits.
    if (p.slope.frac < 0 || p.slope.frac > 20) {
        return bad_value("slope", "fraction bits out of range", range_text(0, 20));
    }
    if (p.angle.frac < 1 || p.angle.frac > 16) {
        return bad_value("angle", "fraction bits out of range", range_text(1, 16));
    }
    if (p.uv.frac < 0 || p.uv.frac > 16) {
        return bad_value("uv", "fraction bits out of range", range_text(0, 16));
    }
    return done();
}

}  // namespace

Span<const ProfileEntry> profile_entries() { return kEntries; }

Result<Profile> make_profile(const std::vector<std::pair<std::string, std::string>>& pairs) {
    Profile profile;
    std::array<bool, kEntries.size()> seen{};
    for (const auto& [key, value] : pairs) {
        std::size_t i = 0;
        while (i < kEntries.size() && kEntries[i].key != key) ++i;
        if (i == kEntries.size()) return bad_value(key, "unknown key", "a key of a profile");
        if (seen[i]) return bad_value(key, "given twice", "each key once");
        seen[i] = true;
        const ProfileEntry& entry = kEntries[i];
        const Status set = entry.format != nullptr ? set_format(profile, entry, value)
                                                   : set_integer(profile, entry, value);
        if (!set) return set.error();
    }
    for (std::size_t i = 0; i < kEntries.size(); ++i) {
        if (!seen[i])
            return bad_value(kEntries[i].key, "missing key", std::string(kEntries[i].doc));
    }
    const Status growth = check_growth(profile);
    if (!growth) return growth.error();
    return profile;
}

std::string entry_text(const Profile& profile, const ProfileEntry& entry) {
    return entry.format != nullptr ? to_string(profile.*entry.format)
                                   : std::to_string(profile.*entry.integer);
}

uint64_t profile_hash(const Profile& profile, Span<const std::string_view> keys) {
    uint64_t hash = 14695981039346656037ULL;
    const auto mix = [&hash](std::string_view text) {
        for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    };
    for (const ProfileEntry& entry : kEntries) {
        for (const std::string_view key : keys) {
            if (key != entry.key) continue;
            mix(entry.key);
            mix("=");
            mix(entry_text(profile, entry));
            mix("\n");
        }
    }
    return hash;
}

}  // namespace repousse
