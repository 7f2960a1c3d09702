#include "testbench/host/draw.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "datapath/units/edge_iter.h"
#include "testbench/host/map/normal_map.h"
#include "testbench/host/map/summed_area_table.h"
#include "testbench/host/scene/assets.h"

namespace repousse::host {
namespace {

// Brings doubles into a profile's formats and remembers the first one that does not fit.
template <class P>
class Encoder {
public:
    explicit Encoder(const Profile& profile) : profile_(profile) {}

    typename P::Value value(double x, Format Profile::*member, const char* what) {
        if constexpr (std::is_same_v<P, Real>) return x;
        const Format& format = profile_.*member;
        const double scaled = std::floor(std::ldexp(x, format.frac) + 0.5);
        const bool fits = scaled >= static_cast<double>(format.min_raw()) &&
                          scaled <= static_cast<double>(format.max_raw());
        if (!fits && what_.empty()) {
            what_ =
                std::string(what) + " " + std::to_string(x) + " does not fit " + to_string(format);
        }
        return fits ? static_cast<typename P::Value>(scaled) : typename P::Value{};
    }

    Vec3<typename P::Value> vector(const glm::dvec3& v, Format Profile::*member, const char* what) {
        return {value(v.x, member, what), value(v.y, member, what), value(v.z, member, what)};
    }

    void refuse(std::string what) {
        if (what_.empty()) what_ = std::move(what);
    }

    Status status() const {
        if (what_.empty()) return done();
        return Error{ErrorKind::Input, {}, what_, {}, "scale the scene or choose a wider profile"};
    }

private:
    const Profile& profile_;
    std::string what_;
};

template <class P>
void encode_vertices(Encoder<P>& encode, const Profile& profile, const DrawInputs& inputs,
                     AdaptiveDraw<P>& draw) {
    const Mesh& mesh = *inputs.mesh;
    draw.triangles = mesh.triangles;
    draw.vertices.resize(mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        Vertex<P>& v = draw.vertices[i];
        v.uv = texel_uv(mesh.uv[i], *inputs.map, inputs.uv, profile.uv.frac);
        const bool fits = v.uv.x >= profile.uv.min_raw() && v.uv.x <= profile.uv.max_raw() &&
                          v.uv.y >= profile.uv.min_raw() && v.uv.y <= profile.uv.max_raw();
        if (!fits) encode.refuse("a texture coordinate does not fit " + to_string(profile.uv));
        v.position = encode.vector(mesh.positions[i], &Profile::position, "position");
        v.normal = encode.vector(mesh.normals[i], &Profile::normal, "normal");
        v.tangent = encode.vector(mesh.tangents[i], &Profile::normal, "tangent");
        v.handedness = mesh.handedness[i] < 0 ? -1 : 1;
    }
}

// D = h * scale + bias. Fixed: 16-bit heights lose their low bits to a narrower format first, and
// the scale becomes kScaleBits significant bits, fewer where the exponent would not fit a cast.
template <class P>
void encode_map(Encoder<P>& encode, const Profile& profile, const DrawInputs& inputs,
                AdaptiveDraw<P>& draw) {
    const HeightMap& map = *inputs.map;
    draw.map.width = map.width;
    draw.map.height = map.height;
    draw.map.wrap = map.wrap;
    draw.map.filter = inputs.filter;
    draw.map.bias = encode.value(map.range_low, &Profile::displacement, "displacement");
    encode.value(map.range_high, &Profile::displacement, "displacement");
    draw.tables.heights = map.texels;
    const double range = map.range_high - map.range_low;
    if constexpr (std::is_same_v<P, Real>) {
        draw.map.scale_mantissa = range / 65535.0;
    } else {
        const Cast narrow(16, profile.height);
        for (uint16_t& h : draw.tables.heights) h = static_cast<uint16_t>(narrow(h));
        const double scale = range / static_cast<double>(profile.height.max_raw());
        int exponent = 0;
        std::frexp(scale, &exponent);
        const int filter_bits = profile.filtered_height.frac - profile.height.frac;
        draw.map.scale_exponent = std::clamp(kScaleBits - 1 - exponent, 0, 62 - filter_bits);
        draw.map.scale_mantissa =
            static_cast<int32_t>(std::lround(std::ldexp(scale, draw.map.scale_exponent)));
    }
    if (draw.registers.use_bump) {
        for (const glm::dvec3& n : normal_map(map, inputs.texel_size.x, inputs.texel_size.y)) {
            const auto v = encode.vector(n, &Profile::map_normal, "map normal");
            using Texel = typename P::Texel;
            draw.tables.normals.push_back({Texel(v.x), Texel(v.y), Texel(v.z)});
        }
    }
    if (draw.registers.use_height_test) {
        HeightMap stored = map;
        stored.texels = draw.tables.heights;
        draw.tables.sums = summed_area_table(stored, profile.sat_width);
    }
}

template <class P>
void encode_view(Encoder<P>& encode, const ViewFrame& view, AdaptiveDraw<P>& draw) {
    ViewRegisters<P>& r = draw.camera;
    r.eye = encode.vector(view.eye, &Profile::position, "camera position");
    r.right = encode.vector(view.right, &Profile::view_row, "camera axis");
    r.up = encode.vector(view.up, &Profile::view_row, "camera axis");
    r.forward = encode.vector(view.forward, &Profile::view_row, "camera axis");
    r.near = encode.value(view.near, &Profile::clip, "near distance");
    r.focal_x = encode.value(view.focal.x, &Profile::focal, "focal length in pixels");
    r.focal_y = encode.value(view.focal.y, &Profile::focal, "focal length in pixels");
    r.centre_x = encode.value(view.centre.x, &Profile::focal, "viewport centre");
    r.centre_y = encode.value(view.centre.y, &Profile::focal, "viewport centre");
}

template <class P>
void encode_registers(const Profile& profile, const DrawInputs& inputs, AdaptiveDraw<P>& draw) {
    const AdaptiveSettings& s = inputs.settings;
    AdaptiveRegisters<P>& r = draw.registers;
    r.use_view_test = s.view_threshold_px.has_value();
    r.use_normal_test = s.normal_threshold.has_value();
    r.use_height_test = s.height_threshold.has_value();
    r.use_bump = r.use_normal_test || inputs.bump;
    r.eager = s.eager;
    r.cap = s.generation_cap ? *s.generation_cap : natural_cap(inputs, profile.uv.frac);
    r.order = s.order;
    r.normal_space = s.normal_space;
    // Differences may be longer than what they are differences of, so neither threshold is a value
    // of the format whose fraction bits it has.
    const auto threshold = [](double value, int frac) {
        return std::is_same_v<P, Real> ? value : std::floor(std::ldexp(value, frac) + 0.5);
    };
    if (r.use_normal_test) {
        r.normal_threshold = static_cast<typename P::Value>(
            threshold(*s.normal_threshold, profile.displaced_normal.frac));
    }
    if (r.use_view_test) {
        r.view_threshold =
            static_cast<typename P::Wide>(threshold(*s.view_threshold_px, profile.screen.frac));
    }
    HeightTestRegisters& h = r.height_test;
    h.width = inputs.map->width;
    h.height = inputs.map->height;
    h.wrap = inputs.map->wrap;
    h.box = s.box;
    h.mode = s.height_mode;
    // Thresholds are in 16-bit height LSB; a narrower height has coarser ones.
    h.threshold = static_cast<uint64_t>(
        std::floor(std::ldexp(s.height_threshold.value_or(0), profile.height.width - 16)));
}

// What the units ask of their inputs beyond formats.
template <class P>
Status check_domain(const Profile& profile, const AdaptiveDraw<P>& draw) {
    if (draw.map.filter == HeightFilter::Bilinear && profile.uv.frac == 0) {
        return Error{ErrorKind::Input,
                     {},
                     "bilinear reads between texel centres",
                     "at least one fraction bit of uv",
                     "read the nearest texel or choose a wider uv"};
    }
    if (!draw.registers.use_height_test) return done();
    HeightTest unit(profile);
    const Status registers = unit.check(draw.registers.height_test, draw.tables.sums.size());
    if (!registers) return registers.error();
    unit.configure(draw.registers.height_test, draw.tables.sums);
    for (const auto& triangle : draw.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Uv a = draw.vertices[triangle[k]].uv;
            const Uv b = draw.vertices[triangle[(k + 1) % 3]].uv;
            if (unit.accepts(a, b, a)) continue;
            return Error{ErrorKind::Input,
                         {},
                         "a base edge is too long for the height test, or lies too far outside "
                         "of a periodic map",
                         "at most " + std::to_string(unit.max_edge()) +
                             " texels, within half a period of the map",
                         "use a finer base mesh or a wider sat_width"};
        }
    }
    return done();
}

}  // namespace

Uv texel_uv(glm::dvec2 uv, const HeightMap& map, UvSpan span, int frac) {
    const glm::dvec2 texel = texel_coordinate(uv, map, span);
    return {static_cast<int32_t>(std::floor(std::ldexp(texel.x, frac))),
            static_cast<int32_t>(std::floor(std::ldexp(texel.y, frac)))};
}

int natural_cap(const DrawInputs& inputs, int uv_frac) {
    int64_t longest = 0;
    for (const auto& triangle : inputs.mesh->triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Uv a = texel_uv(inputs.mesh->uv[triangle[k]], *inputs.map, inputs.uv, uv_frac);
            const Uv b =
                texel_uv(inputs.mesh->uv[triangle[(k + 1) % 3]], *inputs.map, inputs.uv, uv_frac);
            longest =
                std::max({longest, std::abs(int64_t(a.x) - b.x), std::abs(int64_t(a.y) - b.y)});
        }
    }
    int cap = 0;
    while (cap < EdgeIter<Fixed>::kMaxCap && (int64_t(1) << (cap + uv_frac)) < longest) ++cap;
    return cap;
}

Profile reference_profile(Profile profile) {
    profile.height = Format{16, 16, false, Quantization::SC_TRN, Overflow::SC_WRAP, 0};
    profile.sat_width = 38;
    return profile;
}

template <class P>
Result<AdaptiveDraw<P>> make_draw(const Profile& profile, const DrawInputs& inputs) {
    AdaptiveDraw<P> draw;
    Encoder<P> encode(profile);
    encode_registers(profile, inputs, draw);
    encode_vertices(encode, profile, inputs, draw);
    encode_map(encode, profile, inputs, draw);
    if (draw.registers.use_view_test) encode_view(encode, inputs.view, draw);
    const Status fits = encode.status();
    if (!fits) return fits.error();
    const Status domain = check_domain(profile, draw);
    if (!domain) return domain.error();
    return draw;
}

template Result<AdaptiveDraw<Fixed>> make_draw(const Profile&, const DrawInputs&);
template Result<AdaptiveDraw<Real>> make_draw(const Profile&, const DrawInputs&);

}  // namespace repousse::host
