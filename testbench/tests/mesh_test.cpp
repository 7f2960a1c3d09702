// Procedural meshes, their attributes and the manifold diagnosis.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "testbench/host/mesh/mesh_attributes.h"
#include "testbench/host/mesh/mesh_check.h"
#include "testbench/host/mesh/procedural_mesh.h"

namespace repousse::host {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

bool same_bits(const glm::dvec3& a, const glm::dvec3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

double uv_area(const Mesh& mesh, const Triangle& t) {
    const glm::dvec2 a = mesh.uv[t[1]] - mesh.uv[t[0]];
    const glm::dvec2 b = mesh.uv[t[2]] - mesh.uv[t[0]];
    return a.x * b.y - a.y * b.x;
}

/// Frames are orthonormal and turn the way the UV turn.
void expect_frames(const Mesh& mesh) {
    ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
    ASSERT_EQ(mesh.handedness.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0, 1e-12);
        EXPECT_NEAR(glm::length(mesh.tangents[i]), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(mesh.normals[i], mesh.tangents[i]), 0.0, 1e-12);
        EXPECT_EQ(std::fabs(mesh.handedness[i]), 1.0);
    }
}

TEST(Grid, IsTheReferenceBaseMesh) {
    const Mesh mesh = make_grid(3, 3);
    ASSERT_EQ(mesh.triangles.size(), 18u);
    EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 5}));
    EXPECT_EQ(mesh.triangles[1], (Triangle{0, 5, 4}));
    EXPECT_EQ(mesh.triangles[2], (Triangle{1, 2, 6}));
    EXPECT_EQ(mesh.positions[1].x, 1.0 / 3.0);
    EXPECT_EQ(mesh.positions[4 + 2], glm::dvec3(2.0 / 3.0, 1.0 / 3.0, 0.0));
    for (const Triangle& t : mesh.triangles) EXPECT_GT(uv_area(mesh, t), 0.0);
    EXPECT_EQ(mesh.world_per_uv, glm::dvec2(1.0, 1.0));
    expect_frames(mesh);
    const Mesh wide = make_grid(4, 2, {2.0, 0.5});
    EXPECT_EQ(wide.positions.back(), glm::dvec3(2.0, 0.5, 0.0));
    EXPECT_EQ(wide.uv.back(), glm::dvec2(1.0, 1.0));
    EXPECT_EQ(wide.triangles[0], (Triangle{0, 1, 6}));
}

TEST(Cylinder, ClosesBitForBitAtTheSeam) {
    const int segments = 12;
    const int rings = 4;
    const Mesh mesh = make_cylinder(segments, rings, 0.8, 2.0);
    for (std::size_t j = 0; j <= rings; ++j) {
        const std::size_t first = j * (segments + 1);
        EXPECT_TRUE(same_bits(mesh.positions[first], mesh.positions[first + segments]));
        EXPECT_TRUE(same_bits(mesh.normals[first], mesh.normals[first + segments]));
        EXPECT_TRUE(same_bits(mesh.tangents[first], mesh.tangents[first + segments]));
        EXPECT_EQ(mesh.uv[first].x, 0.0);
        EXPECT_EQ(mesh.uv[first + segments].x, 1.0);
    }
    const MeshDiagnosis d = mesh_check(mesh);
    EXPECT_EQ(d.boundary_edges, 2u * segments);
    EXPECT_EQ(d.components, 1u);
    EXPECT_TRUE(d.manifold() && d.oriented());
    EXPECT_EQ(d.euler, 0);
    expect_frames(mesh);
    // Outside is where the normals point.
    for (const Triangle& t : mesh.triangles) {
        const glm::dvec3 n = glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                        mesh.positions[t[2]] - mesh.positions[t[0]]);
        EXPECT_GT(glm::dot(n, mesh.normals[t[0]]), 0.0);
        EXPECT_GT(uv_area(mesh, t), 0.0);
    }
    EXPECT_NEAR(mesh.world_per_uv.y, 2.0, 1e-12);
    EXPECT_NEAR(mesh.world_per_uv.x, 12.0 * 2.0 * 0.8 * std::sin(3.14159265358979 / 12.0), 1e-9);
}

TEST(Icosphere, IsClosedAndItsSeamIsAWholeMapApart) {
    for (int subdivisions = 0; subdivisions <= 3; ++subdivisions) {
        const Mesh mesh = make_icosphere(subdivisions, 2.5);
        EXPECT_EQ(mesh.triangles.size(), 20u << (2 * subdivisions));
        const MeshDiagnosis d = mesh_check(mesh);
        EXPECT_TRUE(d.closed() && d.manifold() && d.oriented()) << describe(d);
        EXPECT_EQ(d.euler, 2);
        EXPECT_EQ(d.components, 1u);
        EXPECT_EQ(d.unused_vertices, 0u);
        expect_frames(mesh);
        const std::vector<std::uint32_t> welded = weld(mesh.positions);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            EXPECT_NEAR(glm::length(mesh.positions[i]), 2.5, 1e-12);
            EXPECT_LT(mesh.uv[i].x, 1.25);
            const bool pole = std::fabs(mesh.normals[i].z) > 1.0 - 1e-9;
            const double du = mesh.uv[i].x - mesh.uv[welded[i]].x;
            if (pole) continue;  // each triangle there has its own copy
            EXPECT_TRUE(du == 0.0 || std::fabs(du) == 1.0) << du;
            EXPECT_TRUE(same_bits(mesh.tangents[i], mesh.tangents[welded[i]]));
        }
        for (const Triangle& t : mesh.triangles) EXPECT_GT(uv_area(mesh, t), 0.0);
    }
}

TEST(Weld, JoinsSignedZerosAndNothingElse) {
    const std::vector<glm::dvec3> positions{
        {0.0, 1.0, 2.0}, {-0.0, 1.0, 2.0}, {0.0, 1.0, std::nextafter(2.0, 3.0)}};
    EXPECT_EQ(weld(positions), (std::vector<std::uint32_t>{0, 0, 2}));
}

TEST(MeshCheck, FindsEachKindOfDamage) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1},
                      {5, 5, 5}, {6, 5, 5}, {5, 6, 5}, {9, 9, 9}};
    mesh.triangles = {{0, 1, 2},
                      {1, 0, 3},
                      {0, 1, 4},   // three on edge 0-1: non-manifold
                      {5, 6, 7},   // a component of its own
                      {2, 2, 3}};  // degenerate
    MeshDiagnosis d = mesh_check(mesh);
    EXPECT_EQ(d.non_manifold_edges, 1u);
    EXPECT_EQ(d.degenerate_triangles, 1u);
    EXPECT_EQ(d.unused_vertices, 1u);
    EXPECT_EQ(d.components, 2u);
    EXPECT_FALSE(d.closed());
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};  // both run 0 -> 1
    d = mesh_check(mesh);
    EXPECT_EQ(d.inconsistent_edges, 1u);
    EXPECT_EQ(d.boundary_edges, 4u);
    EXPECT_EQ(describe(d),
              "open mesh, 2 triangles, 5 edges, 1 component, 4 boundary edges, "
              "1 inconsistent edge, 5 unused vertices");
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(mesh_check(mesh).degenerate_triangles, 1u);  // no area
}

TEST(Attributes, MissingNormalsAndTangentsAreMade) {
    Mesh mesh = make_grid(2, 2, {2.0, 2.0});
    const Mesh full = mesh;
    mesh.normals.clear();
    mesh.tangents.clear();
    mesh.handedness.clear();
    mesh.world_per_uv = {0.0, 0.0};
    ASSERT_TRUE(complete_mesh(mesh, UvProjection::None, "m").ok());
    EXPECT_EQ(mesh.normals, full.normals);
    EXPECT_EQ(mesh.tangents, full.tangents);
    EXPECT_EQ(mesh.handedness, full.handedness);
    EXPECT_EQ(mesh.world_per_uv, full.world_per_uv);
}

TEST(Attributes, AWrappedSeamSharesItsTangentAMirroredOneDoesNot) {
    Mesh cylinder = make_cylinder(8, 2, 1.0, 1.0);
    cylinder.tangents.clear();
    cylinder.normals.clear();
    ASSERT_TRUE(complete_mesh(cylinder, UvProjection::None, "m").ok());
    const std::vector<std::uint32_t> welded = weld(cylinder.positions);
    for (std::size_t i = 0; i < welded.size(); ++i) {
        EXPECT_TRUE(same_bits(cylinder.normals[i], cylinder.normals[welded[i]]));
        EXPECT_TRUE(same_bits(cylinder.tangents[i], cylinder.tangents[welded[i]]));
    }
    Mesh mirrored;  // two quads of one map, mirrored at x = 1, with separate seam vertices
    mirrored.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                          {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
    mirrored.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}, {0, 0}, {0, 1}, {1, 1}};
    mirrored.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
    ASSERT_TRUE(complete_mesh(mirrored, UvProjection::None, "m").ok());
    EXPECT_EQ(mirrored.tangents[1], glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(mirrored.tangents[4], glm::dvec3(-1.0, 0.0, 0.0));
    EXPECT_EQ(mirrored.handedness[1], 1.0);
    EXPECT_EQ(mirrored.handedness[4], -1.0);
}

TEST(Attributes, NoUvIsAnErrorUnlessProjected) {
    Mesh mesh = make_icosphere(1, 1.0);
    mesh.uv.clear();
    mesh.tangents.clear();
    const Status refused = complete_mesh(mesh, UvProjection::None, "m.off");
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().what, "the mesh has no texture coordinates");
    for (const UvProjection projection :
         {UvProjection::Spherical, UvProjection::Cylindrical, UvProjection::Planar}) {
        Mesh copy = mesh;
        ASSERT_TRUE(complete_mesh(copy, projection, "m.off").ok());
        EXPECT_EQ(copy.uv.size(), copy.positions.size());
        EXPECT_TRUE(mesh_check(copy).closed());
    }
}

}  // namespace
}  // namespace repousse::host
