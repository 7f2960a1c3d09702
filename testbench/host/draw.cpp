#include "testbench/host/draw.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "datapath/units/bump_desc.h"
#include "datapath/units/edge_iter.h"
#include "testbench/host/encoder.h"
#include "testbench/host/map/summed_area_table.h"
#include "testbench/host/scene/assets.h"
#include "testbench/host/shade_registers.h"

namespace repousse::host {
namespace {

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
    if (draw.registers.use_normal_test && draw.registers.normal_space == NormalSpace::Map &&
        profile.bump_kind == static_cast<int>(BumpKind::Slopes)) {
        return Error{ErrorKind::Input,
                     {},
                     "bump by differences of heights makes no normal in map space",
                     "bump_kind = 0 or 2 in the profile",
                     "compare in world space or choose another profile"};
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

DrawInputs draw_inputs(const Scene& scene, const Object& object, const Mesh& mesh,
                       const HeightMap& map) {
    DrawInputs inputs;
    inputs.mesh = &mesh;
    inputs.map = &map;
    inputs.method = object.method;
    inputs.settings = object.adaptive;
    inputs.sweep = object.sweep;
    inputs.filter = object.map.filter;
    inputs.levels = object.map.levels;
    inputs.finer_levels = object.map.finer_levels;
    inputs.uv = object.map.uv;
    inputs.bump = object.bump;
    inputs.shade = object.shade;
    inputs.lights = scene.lights;
    inputs.texel_size = texel_size(mesh, map, object.map.uv);
    inputs.view = view_frame(scene.camera, scene.viewport);
    inputs.camera = scene.camera;
    inputs.viewport = scene.viewport;
    return inputs;
}

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
    draw.triangles = inputs.mesh->triangles;
    draw.vertices = encode.vertices(inputs);
    encode.map(inputs, draw.registers.use_bump, draw.map, draw.tables);
    if (draw.registers.use_height_test) {
        HeightMap stored = *inputs.map;
        stored.texels = draw.tables.heights;
        draw.tables.sums = summed_area_table(stored, profile.sat_width);
    }
    if (draw.registers.use_view_test) draw.camera = encode.camera(inputs.view);
    if (inputs.shade) {
        const Result<ShadeRegisters<P>> shade = make_shade_registers<P>(profile, inputs);
        if (!shade) return shade.error();
        draw.registers.use_shade = true;
        draw.registers.shade = *shade;
        draw.camera.eye = shade->eye;
    }
    const Status fits = encode.status();
    if (!fits) return fits.error();
    const Status domain = check_domain(profile, draw);
    if (!domain) return domain.error();
    return draw;
}

template Result<AdaptiveDraw<Fixed>> make_draw(const Profile&, const DrawInputs&);
template Result<AdaptiveDraw<Real>> make_draw(const Profile&, const DrawInputs&);

}  // namespace repousse::host
