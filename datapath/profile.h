#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "datapath/error.h"
#include "datapath/numbers/format.h"
#include "datapath/span.h"

namespace repousse {

/// The format of every signal, the table sizes and the modes of one device. A profile is data: a
/// precision sweep makes another profile, it never recompiles. The same integers become Verilog
/// parameters and vector headers.
///
/// Each member stands under its key in `profile_entries()`, which says what it is for and which
/// values are possible; read the reasons for the shipped widths in tlm/config/profiles/*.toml.
struct Profile {
    // Topology: exact, never rounded.
    Format uv;          ///< texture coordinates in texels (Doggett and Hirche 3.1.2)
    int sat_width = 0;  ///< stored bits of the summed-area table, sums modulo 2^sat_width

    // Maps, as stored in memory.
    Format height;      ///< a texel of the displacement map
    Format map_normal;  ///< a component of the displacement map's normal N_D

    // Attributes, in world units.
    Format position;          ///< P and P'
    Format normal;            ///< components of the base normal N and tangent T
    Format displaced_normal;  ///< components of N'
    Format filtered_height;   ///< a bilinear height: `height` with more fraction bits
    Format displacement;      ///< D in world units
    Format unnormalised;      ///< vectors on their way into a normalisation
    Format diagonal;          ///< differences of P' in split's squared length

    // Bump mapping.
    int bump_kind = 0;        ///< BumpKind
    Format slope;             ///< derivatives of D along T and B, where heights are differenced
    Format angle;             ///< stored rotation angles, in half turns
    int sine_index_bits = 0;  ///< log2 of the sine table's entries

    // Texel caches, all alike.
    int cache_line_bits = 0;    ///< log2 of the texels in a line
    int cache_set_bits = 0;     ///< log2 of the sets
    int cache_ways = 0;         ///< lines in a set
    int cache_replacement = 0;  ///< CacheReplacement

    // View.
    Format view_row;  ///< components of the camera's right, up and forward
    Format clip;      ///< P' in eye space
    Format ndc;       ///< eye-space x/w and y/w
    Format focal;     ///< pixels per unit of x/w, and the viewport's centre
    Format screen;    ///< pixels

    // Sweep-line remeshing (Gumhold and Huettner).
    Format sweep_data;           ///< attributes times c, as vertices carry them
    Format inverse_w;            ///< c = w_scale / w, the last of a vertex's components
    Format steps_per_octave;     ///< grid steps in depth for each doubling of w
    int z_table_kind = 0;        ///< ZTableKind
    int z_table_index_bits = 0;  ///< log2 of the table's entries
    int adder_kind = 0;          ///< AdderKind
    int guard_bits = 0;          ///< below the LSB of sweep_data; the exact adders need none
    int column_depth = 0;        ///< vertices in the column FIFO; 0: one lane
    int components = 0;          ///< components of a vertex that the sweep's registers hold
    int dividers = 0;            ///< of the triangle setup

    // Illumination.
    Format cosine;                 ///< dot products of unit vectors, and their powers
    Format light;                  ///< a light's colour times the material's, and ambient light
    Format colour;                 ///< a vertex's colour
    int lights = 0;                ///< that the unit has registers and lanes for
    int power_log_index_bits = 0;  ///< log2 of the logarithm's table
    int power_exp_index_bits = 0;  ///< log2 of the exponential's table

    // Closed functions.
    int normalise_kind = 0;           ///< NormaliseKind
    int inverse_sqrt_index_bits = 0;  ///< log2 of the table's entries
    int inverse_sqrt_newton_steps = 0;
    int inverse_sqrt_bits = 0;  ///< mantissa bits
    int reciprocal_index_bits = 0;
    int reciprocal_newton_steps = 0;
    int reciprocal_bits = 0;
};

/// One key of a profile: a format or an integer with its range.
struct ProfileEntry {
    std::string_view key;               ///< "uv", "table.reciprocal_bits", ...
    Format Profile::*format = nullptr;  ///< set for formats
    int Profile::*integer = nullptr;    ///< set for integers
    int low = 0, high = 0;              ///< integers: range; formats: range of the width
    bool is_signed = true;              ///< formats: the signedness that the arithmetic expects
    std::string_view doc = {};
};

/// Significant bits of the displacement scale register: d = height * mantissa * 2^-exponent.
inline constexpr int kScaleBits = 24;

/// All keys, in the order in which profiles are printed and hashed.
Span<const ProfileEntry> profile_entries();

/// Builds a profile from key/value pairs. Every key is required exactly once and no other is
/// accepted; values are formats ("s14.8 SC_RND SC_SAT") or integers; widths that would overflow
/// 64-bit intermediate results are refused. The error's `where` is the key.
Result<Profile> make_profile(const std::vector<std::pair<std::string, std::string>>& pairs);

/// The value of one entry as text, as make_profile reads it.
std::string entry_text(const Profile& profile, const ProfileEntry& entry);

/// FNV-1a over the given keys and their values: vectors carry it, so that a change of an entry
/// their unit uses is noticed and a change of any other is not. Unknown keys are ignored.
uint64_t profile_hash(const Profile& profile, Span<const std::string_view> keys);

}  // namespace repousse
