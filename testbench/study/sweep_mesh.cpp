#include "testbench/study/sweep_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "datapath/units/vertex_transform.h"
#include "testbench/host/view/camera.h"

namespace repousse::study {
namespace {

using reference::FineName;

constexpr int kTexels = 256;  // that texture coordinates count where there is no map

Format data_format(int frac) {
    Format format;
    format.width = 16 + frac > 32 ? 32 : 16 + frac;
    format.frac = frac;
    format.quantization = Quantization::SC_RND;
    format.overflow = Overflow::SC_SAT;
    return format;
}

FineName mesh_name(const VertexName& name, const SweepTriangle& triangle, uint32_t base) {
    const uint32_t id = triangle.corners[name.part].id;
    const uint32_t next = triangle.corners[(name.part + 1u) % 3].id;
    switch (name.kind) {
        case NameKind::Corner:
            return {FineName::Kind::Vertex, id, 0, 0, 0};
        case NameKind::Edge:
            return {FineName::Kind::Edge, std::min(id, next), std::max(id, next), name.a, 0};
        case NameKind::Interior:
            break;
    }
    return {FineName::Kind::Inside, base, 0, name.a, name.b};
}

// Position, normal, texture coordinates and c: all that a vertex is, behind `perspective`; and
// where `displace` puts it.
uint64_t digest_of(const FineVertex<Fixed>& vertex, int32_t c) {
    reference::Digest digest;
    const auto pair = [&](int32_t a, int32_t b) {
        digest.add(static_cast<uint64_t>(static_cast<uint32_t>(a)) << 32 |
                   static_cast<uint32_t>(b));
    };
    pair(vertex.position.x, vertex.position.y);
    pair(vertex.position.z, vertex.normal.x);
    pair(vertex.normal.y, vertex.normal.z);
    pair(vertex.uv.x, vertex.uv.y);
    pair(c, vertex.displaced.x);
    pair(vertex.displaced.y, vertex.displaced.z);
    return digest.value();
}

bool reads_footprints(const MeshSetting& setting) {
    return setting.map != nullptr && reads_levels(setting.map->filter);
}

int64_t steps_of(const SweepCorner& p, const SweepCorner& q) {
    int64_t steps = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        steps = std::max<int64_t>(steps, std::abs(p.slot[axis] - q.slot[axis]));
    }
    return steps;
}

// The edge is `part`, from corner part to corner part + 1; steps count from the lower id. n times
// the distance from the true value, of the worst component; 33 + 14 bits.
int64_t edge_distance(const SweepVertex& vertex, const SweepTriangle& triangle, int64_t& steps) {
    const SweepCorner* from = &triangle.corners[vertex.name.part];
    const SweepCorner* to = &triangle.corners[(vertex.name.part + 1u) % 3];
    if (to->id < from->id) std::swap(from, to);
    steps = steps_of(*from, *to);
    int64_t worst = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(triangle.components); ++i) {
        const int64_t exact =
            int64_t{from->data[i]} * (steps - vertex.name.a) + int64_t{to->data[i]} * vertex.name.a;
        worst = std::max(worst, std::abs(vertex.data[i] * steps - exact));
    }
    return worst;
}

// How far the vertex lies from where the edge's exact point is, times its c: in units of w_scale.
double edge_displacement(const SweepVertex& vertex, const FineVertex<Fixed>& fine,
                         const SweepTriangle& triangle, const Profile& profile) {
    const SweepCorner* from = &triangle.corners[vertex.name.part];
    const SweepCorner* to = &triangle.corners[(vertex.name.part + 1u) % 3];
    if (to->id < from->id) std::swap(from, to);
    const double t = vertex.name.a / double(steps_of(*from, *to));
    const auto exact = [&](std::size_t i, int frac) {
        return std::ldexp(from->data[i] + t * (double(to->data[i]) - from->data[i]), -frac);
    };
    const double c = exact(kInverseWComponent, profile.inverse_w.frac);
    const int32_t found[] = {fine.position.x, fine.position.y, fine.position.z};
    double square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double d = std::ldexp(double(found[i]), -profile.position.frac) * c -
                         exact(i, profile.sweep_data.frac);
        square += d * d;
    }
    return std::sqrt(square);
}

}  // namespace

MeshRemesher::MeshRemesher(const Profile& profile, const host::Mesh& mesh)
    : profile_(profile), mesh_(mesh) {}

// The base mesh on the grid of a camera, as the host's registers and the device's units place it.
void MeshRemesher::place_corners(const host::GridCamera& camera, const MeshSetting& setting,
                                 const Profile& profile, TriangleSetup& setup,
                                 MeshFigures& figures) {
    host::Encoder<Fixed> encode(profile);
    std::vector<uint32_t> table;
    const auto registers = host::make_grid_registers<Fixed>(profile, camera, table);
    VertexTransform<Fixed> transform(profile);
    GridTransform<Fixed> grid(profile);
    const ViewRegisters<Fixed> view = encode.camera(camera.view);
    transform.configure(view);
    eye_ = view.eye;
    if (registers) grid.configure(*registers);
    // The ball's middle, or what is at arm's length, lies in the middle of the depths.
    const double middle = std::max(glm::length(camera.view.eye), 4 * setting.w_min);
    setup.configure(
        {setting.guard_grid, static_cast<int32_t>(std::lround(host::grid_depth(camera, middle)))});
    corners_.resize(mesh_.positions.size());
    const glm::dvec2 texels = setting.map == nullptr
                                  ? glm::dvec2(kTexels)
                                  : glm::dvec2(setting.map->width, setting.map->height);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        Vertex<Fixed> vertex;
        vertex.position = encode.vector(mesh_.positions[i], &Profile::position, "position");
        vertex.normal = encode.vector(mesh_.normals[i], &Profile::normal, "normal");
        const glm::dvec2 uv = mesh_.uv[i] * texels;
        vertex.uv = {encode.value(uv.x, &Profile::uv, "u"), encode.value(uv.y, &Profile::uv, "v")};
        const GridPoint<Fixed> point = grid(transform.eye(vertex.position));
        corners_[i].id = static_cast<uint32_t>(i);
        corners_[i].slot = setup.slot(point.position);
        grid.scale(vertex, point.c, false, corners_[i].data);
    }
    figures.clamped_w = grid.counters().w_clamped;
    figures.overflows = grid.counters().data_saturated + !encode.status().ok() + !registers.ok();
}

host::GridCamera MeshRemesher::grid_camera(const host::CameraSettings& camera,
                                           const host::Viewport& viewport,
                                           const MeshSetting& setting) const {
    host::GridCamera grid;
    grid.view = host::view_frame(camera, viewport);
    grid.w_min = setting.w_min;
    grid.w_scale = camera.far;
    grid.far = camera.far;
    for (const glm::dvec3& p : mesh_.positions) {
        grid.w_scale = std::min(grid.w_scale, glm::dot(grid.view.forward, p - grid.view.eye));
    }
    grid.w_scale = std::max(grid.w_scale, setting.w_min);
    return grid;
}

void MeshRemesher::prepare(const Profile& profile, const MeshSetting& setting) {
    perspective_.emplace(profile);
    perspective_->configure(false);
    footprint_.reset();
    displace_.reset();
    if (setting.map == nullptr) return;
    displace_.emplace(profile);
    displace_->configure(*setting.map);
    if (!reads_footprints(setting)) return;
    footprint_.emplace(profile);
    const MapView<Fixed>& map = *setting.map;
    footprint_->configure({map.width, map.height, map.last_level, map.finer, eye_});
}

// What the device does with a new vertex, without bump.
void MeshRemesher::finish_vertex(const SweepVertex& vertex, const SweepTriangle& base,
                                 const MeshSetting& setting, FineVertex<Fixed>& fine) {
    (*perspective_)(vertex, fine);
    if (footprint_) {
        TexelSteps<int32_t> steps = base.texel_steps;
        if (!setting.edge_rule) steps.edges.fill(steps.sweep);
        (*footprint_)(vertex.data[kInverseWComponent], steps, fine);
    }
    if (displace_) fine.displaced = (*displace_)(fine.position, fine.normal, fine.uv, fine.read);
}

// Level changes along the edges of a fine triangle.
void MeshRemesher::count_jumps(const std::array<const Read*, 3>& reads, MeshFigures& figures) {
    for (std::size_t k = 0; k < 3; ++k) {
        const Read &a = *reads[k], &b = *reads[(k + 1) % 3];
        const auto jump = static_cast<std::size_t>(std::abs(int{a.read.level} - int{b.read.level}));
        ++figures.jumps[jump];
        figures.corner_jumps[jump] += a.is_corner || b.is_corner;
        figures.mixed += a.read.back != b.read.back;
    }
}

MeshFigures MeshRemesher::run(const host::CameraSettings& camera, const host::Viewport& viewport,
                              const MeshSetting& setting) {
    Profile profile = profile_;
    profile.sweep_data = data_format(setting.data_frac);
    TriangleSetup setup({setting.adder, setting.guard_bits, kPlainComponents,
                         reads_footprints(setting), profile.sweep_data.width,
                         profile.inverse_w.width});
    SweepLine sweep({setting.column_depth, {}});
    Strip<uint32_t> strip(static_cast<std::size_t>(std::max(1, setting.column_depth)));
    MeshFigures figures;
    const host::GridCamera grid = grid_camera(camera, viewport, setting);
    place_corners(grid, setting, profile, setup, figures);
    prepare(profile, setting);
    // A distance at c is so many pixels on the screen.
    const double pixels = grid.view.focal.x / grid.w_scale;

    checker_.start(mesh_.triangles);
    SweepTriangle base;
    StripTriangles<uint32_t> made;
    FineVertex<Fixed> fine;
    std::vector<FineName> names;
    std::vector<Read> reads;
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        const auto& v = mesh_.triangles[t];
        setup({corners_[v[0]], corners_[v[1]], corners_[v[2]]}, base);
        names.clear();
        reads.clear();
        sweep.run(base, [&](const SweepStep& step) {
            std::array<uint32_t, 4> numbers{};
            for (std::size_t i = 0; i < step.vertex_count; ++i) {
                const SweepVertex& vertex = step.vertices[i];
                finish_vertex(vertex, base, setting, fine);
                numbers[i] = static_cast<uint32_t>(names.size());
                reads.push_back({fine.read, vertex.name.kind == NameKind::Corner});
                names.push_back(mesh_name(vertex.name, base, t));
                checker_.add_vertex(names.back(), digest_of(fine, vertex.data[kInverseWComponent]));
                if (vertex.name.kind != NameKind::Edge) continue;
                int64_t steps = 1;
                const int64_t distance = edge_distance(vertex, base, steps);
                figures.edge_beyond_half += 2 * distance > steps;
                figures.edge_error_px = std::max(
                    figures.edge_error_px, pixels * edge_displacement(vertex, fine, base, profile));
                figures.edge_error_ulp =
                    std::max(figures.edge_error_ulp, double(distance) / double(steps));
            }
            strip(step.strip, {numbers.data(), step.vertex_count}, made);
            for (std::size_t i = 0; i < made.count; ++i) {
                const auto& [a, b, c] = made.triangles[i];
                checker_.add_triangle({names[a], names[b], names[c]});
                count_jumps({&reads[a], &reads[b], &reads[c]}, figures);
            }
        });
        checker_.finish_base();
    }
    figures.mesh = checker_.finish();
    figures.clamped_grid = setup.counters().clamped;
    figures.runaways = sweep.counters().runaways;
    if (footprint_) figures.footprints = footprint_->counters();
    figures.bad_refs = strip.counters().bad_refs;
    return figures;
}

}  // namespace repousse::study
