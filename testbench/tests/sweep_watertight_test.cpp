// Remeshed closed meshes are closed, to the bit: every vertex has one name from all triangles
// around it, every fine edge two triangles by name, and every name one set of bits behind
// `perspective`. Each camera has one of the settings, by turns; with REPOUSSE_NIGHTLY=1 all.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <random>

#include <glm/geometric.hpp>

#include "testbench/host/files.h"
#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/procedural_mesh.h"
#include "testbench/study/closed_mesh.h"
#include "testbench/study/sweep_mesh.h"
#include "testbench/tests/support/profiles.h"

namespace repousse::study {
namespace {

constexpr int kCameras = 60;

bool nightly() { return std::getenv("REPOUSSE_NIGHTLY") != nullptr; }

// A mesh around the origin, and what a test runs it with.
struct Case {
    const char* name;
    host::Mesh mesh;
    double radius = 1;
    int height_px = 100;
    std::size_t rim = 0;  // base edges of one triangle
};

struct Total {
    std::size_t triangles = 0, vertices = 0, open = 0, rim_wrong = 0, degenerate = 0, cracked = 0;
    std::size_t edge_vertices = 0, beyond_half = 0, runaways = 0, bad_refs = 0, overflows = 0;
    std::size_t clamped_w = 0, clamped_grid = 0;
    double error_ulp = 0;
};

std::vector<MeshSetting> watertight_settings() {
    std::vector<MeshSetting> settings;
    for (const int frac : {8, 12, 16, 20}) {
        settings.push_back({AdderKind::Exact, 0, frac, 256});
        settings.push_back({AdderKind::Exact, 0, frac, 0});
        settings.push_back({AdderKind::Canonical, frac == 20 ? 4 : 0, frac, 256});
    }
    return settings;
}

// Every third camera is inside the mesh.
Total run(const Case& c, const std::vector<MeshSetting>& settings) {
    const host::MeshDiagnosis diagnosis = host::mesh_check(c.mesh);
    EXPECT_EQ(diagnosis.boundary_edges, c.rim) << c.name;
    EXPECT_TRUE(diagnosis.manifold()) << c.name;
    std::mt19937_64 random(3);
    MeshRemesher remesher(test::profile_with("default", {}), c.mesh);
    Total total;
    for (int n = 0; n < kCameras; ++n) {
        const auto camera = random_camera(random, c.radius, n % 3 == 2);
        const host::Viewport viewport = {c.height_px * 4 / 3, c.height_px};
        for (std::size_t i = 0; i < settings.size(); ++i) {
            if (!nightly() && i != std::size_t(n) % settings.size()) continue;
            MeshSetting setting = settings[i];
            setting.guard_grid = c.height_px;
            setting.w_min = 0.05 * c.radius;
            const MeshFigures f = remesher.run(camera, viewport, setting);
            total.triangles += f.mesh.triangles;
            total.vertices += f.mesh.vertices;
            total.edge_vertices += f.mesh.edge_vertices;
            total.open += f.mesh.open_edges - f.mesh.rim_edges;
            total.rim_wrong += f.mesh.rim_base_edges != c.rim;
            total.degenerate += f.mesh.degenerate;
            total.cracked += f.mesh.cracked;
            total.runaways += f.runaways;
            total.bad_refs += f.bad_refs;
            total.overflows += f.overflows;
            total.clamped_w += f.clamped_w;
            total.clamped_grid += f.clamped_grid;
            if (setting.adder == AdderKind::Exact) {
                total.beyond_half += f.edge_beyond_half;
                total.error_ulp = std::max(total.error_ulp, f.edge_error_ulp);
            }
        }
    }
    return total;
}

void expect_watertight(const Case& c) {
    const Total total = run(c, watertight_settings());
    std::printf(
        "%s: %d cameras, %zu base triangles, %zu fine ones, %zu vertices, %zu on edges; %zu base "
        "vertices at the clamp of w, %zu at the guard band; exact adders: %.6f ulp\n",
        c.name, kCameras, c.mesh.triangles.size(), total.triangles, total.vertices,
        total.edge_vertices, total.clamped_w, total.clamped_grid, total.error_ulp);
    EXPECT_EQ(total.open, 0u) << c.name << ": open edges or T-vertices";
    EXPECT_EQ(total.rim_wrong, 0u) << c.name;
    EXPECT_EQ(total.cracked, 0u) << c.name << ": one name, two sets of bits";
    EXPECT_EQ(total.degenerate, 0u) << c.name;
    EXPECT_EQ(total.beyond_half, 0u) << c.name << ": edge points beside the true v c";
    EXPECT_LE(total.error_ulp, 0.5) << c.name;
    EXPECT_EQ(total.runaways, 0u);
    EXPECT_EQ(total.bad_refs, 0u);
    EXPECT_EQ(total.overflows, 0u);
    EXPECT_GT(total.clamped_w, 0u) << c.name << ": no camera had a vertex behind it";
    EXPECT_GT(total.clamped_grid, 0u) << c.name;
    EXPECT_GT(total.edge_vertices, 10'000u);
}

Case icosphere(int subdivisions) {
    return {"icosphere", welded(host::make_icosphere(subdivisions, 1)), 1, 80, 0};
}

Case cylinder() { return {"capped cylinder", make_capped_cylinder(12, 6, 0.6, 1.6), 1, 80, 0}; }

TEST(Watertight, Icosphere) { expect_watertight(icosphere(2)); }

TEST(Watertight, Icosahedron) { expect_watertight(icosphere(0)); }

TEST(Watertight, CappedCylinder) { expect_watertight(cylinder()); }

TEST(Watertight, LongThinCylinder) {
    Case c = cylinder();
    c.mesh = make_capped_cylinder(16, 1, 0.6, 1.6);
    expect_watertight(c);
}

// A mesh of the CGAL library's examples, scaled into the unit ball around the origin.
void expect_file_watertight(const char* name, const char* file, std::size_t rim) {
    if (!host::is_file(file)) GTEST_SKIP() << file << " is absent: scenes/fetch.sh gets it";
    auto read = host::read_mesh(file);
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_TRUE(host::complete_mesh(*read, host::UvProjection::Spherical, file));
    Case c{name, welded(*read), 1, 40, rim};
    const host::MeshDiagnosis found = host::mesh_check(c.mesh);
    const glm::dvec3 centre = 0.5 * (found.low + found.high);
    double radius = 0;
    for (const auto& p : c.mesh.positions) radius = std::max(radius, glm::distance(p, centre));
    for (auto& p : c.mesh.positions) p = (p - centre) / radius;
    expect_watertight(c);
}

TEST(Watertight, Bunny) { expect_file_watertight("bunny00", "inputs/bunny00.off", 0); }

TEST(Watertight, MannequinIsOpenAtItsRimOnly) {
    expect_file_watertight("mannequin", "inputs/mannequin-devil.off", 64);
}

// Plain adders make the same triangles; their vertices crack whatever the guard bits.
TEST(Watertight, PlainAddersCrack) {
    for (const Case& c : {icosphere(2), cylinder()}) {
        MeshRemesher remesher(test::profile_with("default", {}), c.mesh);
        for (const int guard : {0, 4, 8, 13}) {
            std::mt19937_64 random(3);
            std::size_t edges = 0, cracked = 0, vertices = 0, cracked_vertices = 0, open = 0;
            double error = 0;
            for (int n = 0; n < 4; ++n) {
                const auto camera = random_camera(random, c.radius, false);
                MeshSetting setting;
                setting.adder = AdderKind::Plain;
                setting.guard_bits = guard;
                setting.guard_grid = 400;
                const MeshFigures f = remesher.run(camera, {400, 300}, setting);
                edges += f.mesh.base_edges;
                cracked += f.mesh.cracked_base_edges;
                vertices += f.mesh.edge_vertices;
                cracked_vertices += f.mesh.cracked_edge_vertices;
                open += f.mesh.open_edges;
                error = std::max(error, f.edge_error_ulp);
            }
            std::printf(
                "%s, plain adders, %2d guard bits: %.1f %% of %zu base edges and %.1f %% of "
                "%zu edge vertices crack, at most %.2f ulp from the true value\n",
                c.name, guard, 100.0 * double(cracked) / double(edges), edges,
                100.0 * double(cracked_vertices) / double(vertices), vertices, error);
            EXPECT_EQ(open, 0u) << "the triangles do not depend on the adder";
            EXPECT_GT(cracked, 0u) << c.name << ' ' << guard;
        }
    }
}

}  // namespace
}  // namespace repousse::study
