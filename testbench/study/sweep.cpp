#include "testbench/study/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "datapath/numbers/log2.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/host/z_table.h"
#include "testbench/study/closed_mesh.h"
#include "testbench/study/sweep_mesh.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

constexpr int kColumnDepth = 256;

using Corners = std::array<SweepCorner, 3>;

// As many triangles as make some 200,000 fine ones.
std::size_t count_of(int size_px) {
    return static_cast<std::size_t>(std::clamp(1'200'000 / (size_px * size_px), 60, 10'000));
}

// Facing the viewer, corners uniform in a square of `size_px`.
std::vector<Corners> flat_triangles(int size_px, uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<Corners> triangles(count_of(size_px));
    for (Corners& corners : triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i].id = static_cast<uint32_t>(i);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                corners[i].slot[axis] = static_cast<int32_t>(random() % (unsigned(size_px) + 1));
            }
        }
    }
    return triangles;
}

struct Swept {
    SweepLineCounters counters;
    int64_t doubled_area = 0;
};

Swept sweep(const std::vector<Corners>& triangles, int column_depth) {
    TriangleSetup setup({AdderKind::Exact, 0, 0});
    SweepLine sweep_line({column_depth, {}});
    SweepTriangle base;
    Swept swept;
    for (const Corners& corners : triangles) {
        setup(corners, base);
        if (!base.single) swept.doubled_area += base.determinant;
        sweep_line.run(base, [](const SweepStep&) {});
    }
    swept.counters = sweep_line.counters();
    return swept;
}

// Meshes that fill the picture, of large base triangles and small ones.
std::vector<host::Mesh> closed_meshes() {
    return {welded(host::make_icosphere(0, 1)), welded(host::make_icosphere(2, 1)),
            make_capped_cylinder(12, 6, 0.6, 1.6)};
}

}  // namespace

SweepSizeRow sweep_size_row(int size_px, uint64_t seed) {
    const std::vector<Corners> triangles = flat_triangles(size_px, seed);
    const Swept one_lane = sweep(triangles, 0), two_lanes = sweep(triangles, kColumnDepth);
    const SweepLineCounters &one = one_lane.counters, &two = two_lanes.counters;
    const auto each = [&](uint64_t n) { return double(n) / double(one.triangles); };
    SweepSizeRow row;
    row.size_px = size_px;
    row.base_triangles = triangles.size();
    row.fine_triangles = double(one.triangles) / double(triangles.size());
    row.to_area = double(one.triangles) / double(one_lane.doubled_area);
    row.additions_per_quad = double(one.additions) / double(one.quads);
    row.commands = each(one.commands);
    row.swaps = each(one.swaps);
    row.sent = each(one.displaced);
    row.displaced = each(two.displaced);
    row.additions_one = each(one.additions);
    row.additions_two = each(two.additions);
    row.steps_two = each(two.steps + two.ears);
    return row;
}

AdderRow adder_row(AdderKind kind, int guard_bits, int data_frac, uint64_t seed) {
    AdderRow row;
    row.kind = kind;
    row.guard_bits = guard_bits;
    row.data_frac = data_frac;
    const auto profile = shipped_profile("default");
    if (!profile) return row;
    for (const host::Mesh& mesh : closed_meshes()) {
        std::mt19937_64 random(seed);
        MeshRemesher remesher(*profile, mesh);
        for (int n = 0; n < 4; ++n) {
            MeshSetting setting;
            setting.adder = kind;
            setting.guard_bits = guard_bits;
            setting.data_frac = data_frac;
            setting.guard_grid = 400;
            const MeshFigures f =
                remesher.run(random_camera(random, 1, false), {400, 300}, setting);
            row.edge_ulp = std::max(row.edge_ulp, f.edge_error_ulp);
            row.edge_px = std::max(row.edge_px, f.edge_error_px);
            row.base_edges += f.mesh.base_edges;
            row.cracked_edges += f.mesh.cracked_base_edges;
            row.edge_vertices += f.mesh.edge_vertices;
            row.cracked_vertices += f.mesh.cracked_edge_vertices;
            row.inside_vertices += f.mesh.vertices - f.mesh.edge_vertices;
            row.cracked_inside += f.mesh.cracked - f.mesh.cracked_edge_vertices;
            row.open_edges += f.mesh.open_edges;
        }
    }
    const bool exact = kind == AdderKind::Exact;
    const int value_bits = 16 + data_frac + guard_bits;
    row.edge_bits = value_bits + (exact ? kGridRemainderBits : 0);
    row.inside_bits = value_bits + (exact ? kGridDeterminantBits - 1 : 0);
    return row;
}

std::vector<SetupBoundRow> setup_rows(uint64_t seed) {
    SetupBoundSettings settings;
    settings.seed = seed;
    return setup_bound(settings);
}

// Every clip value of the nearest octave, and 2^18 beyond it at equal
// ratios: the pieces of all tables are wide against both.
DepthRow depth_row(ZTableKind kind, int index_bits, double far_over_near) {
    DepthRow row;
    row.kind = kind;
    row.index_bits = index_bits;
    row.far_over_near = far_over_near;
    const auto shipped = shipped_profile("default");
    if (!shipped) return row;
    Profile profile = *shipped;
    profile.z_table_kind = static_cast<int>(kind);
    profile.z_table_index_bits = index_bits;
    host::CameraSettings camera;
    camera.fov_deg = DepthRow::kAngle_deg;
    camera.near = 1;
    camera.far = far_over_near;
    host::GridCamera grid;
    grid.view = host::view_frame(camera, {DepthRow::kLines, DepthRow::kLines});
    grid.w_min = grid.w_scale = camera.near;
    grid.far = camera.far;
    row.steps_per_octave = host::steps_per_octave(grid);
    std::vector<uint32_t> table;
    const auto registers = host::make_grid_registers<Fixed>(profile, grid, table);
    if (!registers) return row;
    GridTransform<Fixed> unit(profile);
    unit.configure(*registers);
    const auto measure = [&](int32_t w) {
        const double found = std::ldexp(unit({0, 0, w}).position[2], -kGridFractionBits);
        const double exact = host::grid_depth(grid, std::ldexp(w, -profile.clip.frac));
        row.error = std::max(row.error, std::abs(found - exact));
    };
    const int32_t near = 1 << profile.clip.frac;
    for (int32_t w = near; w < 2 * near; ++w) measure(w);
    for (int i = 0; i <= 1 << 18; ++i) {
        measure(static_cast<int32_t>(near * std::pow(far_over_near, std::ldexp(i, -18))));
    }
    const OctaveLog2 octaves(
        kind == ZTableKind::Linear ? OctaveLog2::Pieces::Linear : OctaveLog2::Pieces::Quadratic,
        index_bits);
    constexpr int64_t kUniformWordBits = 22;  // u14.8
    row.table_bits = kind == ZTableKind::Uniform
                         ? ((int64_t{1} << index_bits) + 1) * kUniformWordBits
                         : octaves.table_bits();
    return row;
}

SweepReport sweep_study(uint64_t seed, const std::function<void(const std::string&)>& progress) {
    SweepReport report;
    report.seed = seed;
    for (const int size : SweepReport::kSizes) {
        progress("triangles of " + std::to_string(size) + " pixels");
        report.sizes.push_back(sweep_size_row(size, seed));
    }
    progress("setup");
    report.setups = setup_rows(seed);
    progress("exact adders");
    report.adders.push_back(adder_row(AdderKind::Exact, 0, 16, seed));
    for (const AdderKind kind : {AdderKind::Canonical, AdderKind::Plain}) {
        for (const int guard : SweepReport::kGuardBits) {
            progress("adders with " + std::to_string(guard) + " guard bits");
            report.adders.push_back(adder_row(kind, guard, 16, seed));
        }
    }
    for (const int frac : SweepReport::kFractions) {
        progress("plain adders, " + std::to_string(frac) + " fraction bits");
        report.fractions.push_back(adder_row(AdderKind::Plain, 0, frac, seed));
        report.fractions.push_back(adder_row(AdderKind::Exact, 0, frac, seed));
    }
    for (const double ratio : {1e2, 1e4}) {
        for (const int bits : {8, 12, 16}) {
            progress("uniform depth tables");
            report.depths.push_back(depth_row(ZTableKind::Uniform, bits, ratio));
        }
    }
    for (const int bits : {4, 5, 6, 7}) {
        report.depths.push_back(depth_row(ZTableKind::Linear, bits, 1e4));
    }
    for (const int bits : {2, 3, 4}) {
        report.depths.push_back(depth_row(ZTableKind::Quadratic, bits, 1e4));
    }
    return report;
}

}  // namespace repousse::study
