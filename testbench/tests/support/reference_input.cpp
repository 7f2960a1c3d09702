#include "testbench/tests/support/reference_input.h"

#include <cmath>
#include <cstdio>

#include "testbench/host/files.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/scene/assets.h"

namespace repousse::test {

reference::TessellatorInput reference_input(const host::DrawInputs& inputs, int uv_frac) {
    const host::Mesh& mesh = *inputs.mesh;
    const host::HeightMap& map = *inputs.map;
    const host::AdaptiveSettings& s = inputs.settings;
    reference::TessellatorInput out;
    out.triangles = mesh.triangles;
    const bool edges = inputs.uv == host::UvSpan::Edges;
    const auto texels = [&](double t, int size) {
        const double at = edges ? t * size : t * (size - 1) + 0.5;
        return static_cast<int64_t>(std::floor(at * std::exp2(uv_frac)));
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        out.vertices.push_back({{texels(mesh.uv[i].x, map.width), texels(mesh.uv[i].y, map.height)},
                                mesh.positions[i],
                                mesh.normals[i],
                                mesh.tangents[i],
                                mesh.handedness[i]});
    }
    out.map = {map.width,     map.height,
               map.wrap,      inputs.filter == host::HeightFilter::Bilinear,
               map.texels,    (map.range_high - map.range_low) / 65535.0,
               map.range_low, inputs.texel_size};
    out.uv_frac = uv_frac;
    out.cap = s.generation_cap ? *s.generation_cap : host::natural_cap(inputs, uv_frac);
    out.normal_threshold = s.normal_threshold;
    out.map_space = s.normal_space == host::NormalSpace::Map;
    if (s.height_threshold) {
        out.height_threshold = static_cast<int64_t>(std::floor(*s.height_threshold));
    }
    out.sum = s.height_mode == host::HeightMode::Sum;
    out.literal = s.box == host::BoxKind::Literal;
    if (s.view_threshold_px) {
        const host::ViewFrame& v = inputs.view;
        out.view = reference::TessellatorView{v.eye,  v.right, v.up,     v.forward,
                                              v.near, v.focal, v.centre, *s.view_threshold_px};
    }
    return out;
}

Relief jacksboro_relief(int x, int y, int width, int height) {
    const std::string path = "inputs/jacksboro_fault_dem.npz";
    if (host::is_file(path)) {
        const auto bytes = host::read_file(path);
        const auto grid =
            bytes ? host::read_npz(*bytes, path) : Result<host::ElevationGrid>(bytes.error());
        if (grid) {
            const auto part = host::crop(host::quantise(*grid), x, y, width, height);
            if (part) return {*part, true};
        }
    }
    std::printf("%s is not there: made relief stands in\n", path.c_str());
    host::FbmSettings fbm;
    fbm.seed = 7;
    fbm.octaves = 8;
    fbm.ridged = true;
    return {host::make_fbm_map(width, height, fbm), false};
}

host::DrawInputs Object::inputs() const {
    host::DrawInputs in;
    in.mesh = &mesh;
    in.map = &map;
    in.settings = settings;
    in.filter = filter;
    in.uv = uv;
    in.texel_size = host::texel_size(mesh, map, uv);
    return in;
}

}  // namespace repousse::test
