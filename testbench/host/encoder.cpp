#include "testbench/host/encoder.h"

#include <algorithm>
#include <utility>

#include "testbench/host/map/level_table.h"

namespace repousse::host {

template <class P>
std::vector<Vertex<P>> Encoder<P>::vertices(const DrawInputs& inputs) {
    const Mesh& mesh = *inputs.mesh;
    const Format& uv = profile_.uv;
    std::vector<Vertex<P>> vertices(mesh.positions.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        Vertex<P>& v = vertices[i];
        v.uv = texel_uv(mesh.uv[i], *inputs.map, inputs.uv, uv.frac);
        const bool fits = v.uv.x >= uv.min_raw() && v.uv.x <= uv.max_raw() &&
                          v.uv.y >= uv.min_raw() && v.uv.y <= uv.max_raw();
        if (!fits) refuse("a texture coordinate does not fit " + to_string(uv));
        v.position = vector(mesh.positions[i], &Profile::position, "position");
        v.normal = vector(mesh.normals[i], &Profile::normal, "normal");
        v.tangent = vector(mesh.tangents[i], &Profile::normal, "tangent");
        v.handedness = mesh.handedness[i] < 0 ? -1 : 1;
    }
    return vertices;
}

// D = h * scale + bias. Fixed: 16-bit heights lose their low bits to a narrower format first, and
// the scale becomes kScaleBits significant bits, fewer where the exponent would not fit a cast.
template <class P>
void Encoder<P>::map(const DrawInputs& inputs, bool with_bump, MapView<P>& view,
                     MapTables<P>& tables) {
    const HeightMap& source = *inputs.map;
    view.width = source.width;
    view.height = source.height;
    view.wrap = source.wrap;
    view.filter = inputs.filter;
    view.finer = inputs.finer_levels;
    view.bias = value(source.range_low, &Profile::displacement, "displacement");
    value(source.range_high, &Profile::displacement, "displacement");
    tables.heights = source.texels;
    if (inputs.levels) {
        LevelTable levels = make_level_table(source, *inputs.levels);
        tables.heights = std::move(levels.heights);
        view.last_level = levels.last_level;
        view.has_minima = levels.has_minima;
    }
    const double range = source.range_high - source.range_low;
    if constexpr (std::is_same_v<P, Real>) {
        view.scale_mantissa = range / 65535.0;
    } else {
        const Cast narrow(16, profile_.height);
        for (uint16_t& h : tables.heights) h = static_cast<uint16_t>(narrow(h));
        const double scale = range / static_cast<double>(profile_.height.max_raw());
        int exponent = 0;
        std::frexp(scale, &exponent);
        const int filter_bits = profile_.filtered_height.frac - profile_.height.frac;
        view.scale_exponent = std::clamp(kScaleBits - 1 - exponent, 0, 62 - filter_bits);
        view.scale_mantissa =
            static_cast<int32_t>(std::lround(std::ldexp(scale, view.scale_exponent)));
    }
    if (with_bump) bump(inputs, view, tables);
}

template <class P>
ViewRegisters<P> Encoder<P>::camera(const ViewFrame& view) {
    ViewRegisters<P> r;
    r.eye = vector(view.eye, &Profile::position, "camera position");
    r.right = vector(view.right, &Profile::view_row, "camera axis");
    r.up = vector(view.up, &Profile::view_row, "camera axis");
    r.forward = vector(view.forward, &Profile::view_row, "camera axis");
    r.near = value(view.near, &Profile::clip, "near distance");
    r.focal_x = value(view.focal.x, &Profile::focal, "focal length in pixels");
    r.focal_y = value(view.focal.y, &Profile::focal, "focal length in pixels");
    r.centre_x = value(view.centre.x, &Profile::focal, "viewport centre");
    r.centre_y = value(view.centre.y, &Profile::focal, "viewport centre");
    return r;
}

template class Encoder<Fixed>;
template class Encoder<Real>;

}  // namespace repousse::host
