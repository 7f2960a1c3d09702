// Mesh files, good and bad: every refusal names the place in the file.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "testbench/host/mesh/mesh_reader.h"
#include "testbench/host/mesh/ply_writer.h"
#include "testbench/host/mesh/procedural_mesh.h"

namespace repousse::host {
namespace {

std::string message(const Result<Mesh>& result) {
    return result.ok() ? "(accepted)" : result.error().message();
}

void expect_starts(const Result<Mesh>& result, const std::string& start) {
    EXPECT_EQ(message(result).substr(0, start.size()), start);
}

TEST(Obj, ReadsTriplesFansAndNegativeIndices) {
    const auto mesh = read_obj(
        "# a quad and a triangle\nmtllib x.mtl\no thing\n"
        "v 0 0 0\nv 1 0 0\nv 1 1 0.125\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\n"
        "f 1/1/1 2/2/1 3/3/1 4/4/1\r\nf -4/1/-1 -2/3/-1 \\\n -1/4/-1\n",
        "m.obj");
    ASSERT_TRUE(mesh.ok()) << message(mesh);
    EXPECT_EQ(mesh->positions.size(), 4u);
    ASSERT_EQ(mesh->triangles.size(), 3u);
    EXPECT_EQ(mesh->triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
    EXPECT_EQ(mesh->positions[2], glm::dvec3(1.0, 1.0, 0.125));
    EXPECT_EQ(mesh->uv[3], glm::dvec2(0.0, 1.0));
    EXPECT_EQ(mesh->normals[0], glm::dvec3(0.0, 0.0, 1.0));  // made unit length
}

TEST(Obj, ASeamVertexIsStoredOncePerTextureCoordinate) {
    const auto mesh = read_obj(
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt .5 .5\n"
        "f 1/1 2/2 3/3\nf 1/4 3/3 2/2\n",
        "m.obj");
    ASSERT_TRUE(mesh.ok()) << message(mesh);
    EXPECT_EQ(mesh->positions.size(), 4u);
    EXPECT_EQ(std::memcmp(&mesh->positions[0], &mesh->positions[3], sizeof(glm::dvec3)), 0);
}

TEST(Obj, RefusesWithLineAndColumn) {
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_EQ(message(read_obj("v 0 0 0\nv 1 nan 0\n", "m.obj")),
              "m.obj:2:5: \"nan\" is not finite, expected a vertex coordinate");
    EXPECT_EQ(message(read_obj("v 0 0 1e999\n", "m.obj")),
              "m.obj:1:7: \"1e999\" is not a number, expected a vertex coordinate");
    EXPECT_EQ(message(read_obj("v 0 0 -inf\n", "m.obj")),
              "m.obj:1:7: \"-inf\" is not finite, expected a vertex coordinate");
    expect_starts(read_obj("v 0 0\n", "m.obj"), "m.obj:1:6: the line ends here");
    expect_starts(read_obj(three + "f 1 2 4\n", "m.obj"),
                  "m.obj:4:7: vertex index 4 is out of range");
    expect_starts(read_obj(three + "f 1 2 0\n", "m.obj"),
                  "m.obj:4:7: vertex index 0 is out of range");
    expect_starts(read_obj(three + "f 1 2 -4\n", "m.obj"), "m.obj:4:7: vertex index -4");
    expect_starts(read_obj(three + "f 1 2 x\n", "m.obj"), "m.obj:4:7: \"x\" is not an index");
    expect_starts(read_obj(three + "f 1 2\n", "m.obj"), "m.obj:4:6: a face with 2 corners");
    expect_starts(read_obj(three + "f 1 2 3/1\n", "m.obj"),
                  "m.obj:4:7: texture coordinate index 1");
    expect_starts(read_obj(three + "curv 0 1 1 2\n", "m.obj"),
                  "m.obj:4:1: unknown element \"curv\"");
    expect_starts(read_obj("", "m.obj"), "m.obj: the mesh has no triangles");
}

TEST(Off, ReadsCommentsColoursAndPrefixes) {
    const auto plain = read_off(
        "OFF # made by hand\n# counts\n4 1 0\n0 0 0\n1 0 0\n\n1 1 0 # corner\n"
        "0 1 0\n4 0 1 2 3 255 0 0\n",
        "m.off");
    ASSERT_TRUE(plain.ok()) << message(plain);
    EXPECT_EQ(plain->triangles.size(), 2u);
    const auto rich = read_off(
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 9 9 9 255 0.5 0.25\n"
        "1 0 0 0 0 1 9 9 9 255 1 0\n0 1 0 0 0 1 9 9 9 255 0 1\n3 0 1 2\n",
        "m.off");
    ASSERT_TRUE(rich.ok()) << message(rich);
    EXPECT_EQ(rich->uv[0], glm::dvec2(0.5, 0.25));
    EXPECT_EQ(rich->normals[0], glm::dvec3(0.0, 0.0, 1.0));
}

TEST(Off, RefusesWithLineAndColumn) {
    EXPECT_EQ(message(read_off("OFF\n2000000000 1 0\n0 0 0\n", "m.off")),
              "m.off:2:1: the vertex count 2000000000 is more than the file can hold, expected at "
              "most 1");
    expect_starts(read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "m.off"),
                  "m.off:6:7: \"3\" is out of range, expected a vertex index in 0..2");
    expect_starts(read_off("OFF\n3 1 0\n0 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n", "m.off"),
                  "m.off:4:3: \"inf\" is not finite");
    expect_starts(read_off("OFF\n3 1 0\n0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n", "m.off"),
                  "m.off:4:8: the vertex has 4 numbers");
    expect_starts(read_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1", "m.off"),
                  "m.off:6:6: the file ends here");
    expect_starts(read_off("4OFF\n", "m.off"), "m.off:1:1: OFF of another dimension");
    expect_starts(read_off("OFF BINARY\n", "m.off"), "m.off:1:5: binary OFF");
    expect_starts(read_off("PLY\n", "m.off"), "m.off:1:1: this is no OFF header");
    expect_starts(read_off("", "m.off"), "m.off:1:1: this is no OFF header");
}

/// Turns what `to_ply` writes into big-endian: reverses each double, index and nothing else.
std::string big_endian(std::string ply, std::size_t vertices, std::size_t per_vertex,
                       std::size_t triangles) {
    const std::string little = "little";
    ply.replace(ply.find(little), little.size(), "big");
    std::size_t at = ply.find("end_header\n") + 11;
    for (std::size_t i = 0; i < vertices * per_vertex; ++i, at += 8) {
        std::reverse(ply.begin() + static_cast<long>(at), ply.begin() + static_cast<long>(at + 8));
    }
    for (std::size_t i = 0; i < triangles; ++i) {
        ++at;
        for (int k = 0; k < 3; ++k, at += 4) {
            std::reverse(ply.begin() + static_cast<long>(at),
                         ply.begin() + static_cast<long>(at + 4));
        }
    }
    return ply;
}

TEST(Ply, WhatIsWrittenIsReadBackBitForBit) {
    const Mesh mesh = make_icosphere(2, 1.7);
    const std::string bytes = to_ply(mesh);
    for (const std::string& file :
         {bytes, big_endian(bytes, mesh.positions.size(), 8, mesh.triangles.size())}) {
        const auto again = read_ply(file, "m.ply");
        ASSERT_TRUE(again.ok()) << message(again);
        EXPECT_EQ(again->positions, mesh.positions);
        EXPECT_EQ(again->uv, mesh.uv);
        EXPECT_EQ(again->triangles, mesh.triangles);
    }
    EXPECT_EQ(to_ply(mesh), bytes);
}

const char* const kAsciiHeader =
    "ply\nformat ascii 1.0\ncomment a triangle\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
    "property list uchar int vertex_index\nelement edge 1\nproperty int vertex1\nend_header\n";

TEST(Ply, ReadsAsciiAndSkipsWhatItDoesNotNeed) {
    const auto mesh =
        read_ply(std::string(kAsciiHeader) + "0 0 0 9\n1 0 0 9\n0 1 .5 9\n3 0 1 2\n7\n", "m.ply");
    ASSERT_TRUE(mesh.ok()) << message(mesh);
    EXPECT_EQ(mesh->positions[2], glm::dvec3(0.0, 1.0, 0.5));
    EXPECT_EQ(mesh->triangles.size(), 1u);
}

TEST(Ply, RefusesText) {
    const std::string header = kAsciiHeader;
    expect_starts(read_ply(header + "0 0 0 9\n1 nan 0 9\n0 1 0 9\n3 0 1 2\n7\n", "m.ply"),
                  "m.ply:15:3: \"nan\" is not finite");
    expect_starts(read_ply(header + "0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1 5\n7\n", "m.ply"),
                  "m.ply:17:7: vertex index 5 of face 0 is out of range, expected 0..2");
    expect_starts(read_ply(header + "0 0 0 9\n1 0 0 9\n0 1 0 9\n3 0 1", "m.ply"),
                  "m.ply:17:6: the file ends here");
    expect_starts(read_ply("plx\n", "m.ply"), "m.ply:1:1: this is no PLY file");
    expect_starts(read_ply("ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n", "m.ply"),
                  "m.ply:4:10: unknown property type \"quad\"");
    expect_starts(read_ply("ply\nformat middle 1.0\n", "m.ply"), "m.ply:2:8: unknown format");
    expect_starts(read_ply("ply\nformat ascii 1.0\n", "m.ply"), "m.ply:");
}

TEST(Ply, RefusesBinaryWithOffsets) {
    const Mesh mesh = make_grid(1, 1);
    const std::string good = to_ply(mesh);
    const std::size_t body = good.find("end_header\n") + 11;
    // Truncated anywhere in the body.
    for (std::size_t size = body; size < good.size(); ++size) {
        const auto result = read_ply(good.substr(0, size), "m.ply");
        ASSERT_FALSE(result.ok()) << size;
        EXPECT_EQ(result.error().where.substr(0, 14), "m.ply: offset ");
    }
    std::string nan = good;
    const double not_a_number = std::nan("");
    std::memcpy(&nan[body + 8], &not_a_number, 8);
    EXPECT_EQ(message(read_ply(nan, "m.ply")), "m.ply: offset " + std::to_string(body + 8) +
                                                   ": y is not finite, expected a finite number");
    std::string far = good;
    far[good.size() - 4] = 99;
    expect_starts(read_ply(far, "m.ply"), "m.ply: offset " + std::to_string(good.size() - 4) +
                                              ": vertex index 99 of face 1");
    std::string claim = good;
    claim.replace(claim.find("element vertex 4"), 16, "element vertex 2000000000");
    const std::string at = "m.ply: offset " + std::to_string(body + 9);
    expect_starts(read_ply(claim, "m.ply"), at + ": the header claims 2000000000 vertex elements");
}

TEST(ReadMesh, DamagedFilesGiveAMeshOrAnError) {
    const Mesh mesh = make_grid(2, 2);
    const std::string files[] = {
        to_ply(mesh), std::string(kAsciiHeader) + "0 0 0 9\n1 0 0 9\n0 1 .5 9\n3 0 1 2\n7\n",
        "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"};
    std::mt19937 random(1);
    for (int round = 0; round < 20000; ++round) {
        std::string bytes = files[round % 4];
        for (int k = 0; k <= round % 5; ++k) {
            bytes[random() % bytes.size()] = static_cast<char>(
                random() % 3 == 0 ? random() % 256 : "0123456789 -.\n/e#\\"[random() % 18]);
        }
        if (round % 7 == 0) bytes.resize(random() % bytes.size());
        const int kind = round % 4;
        const auto read = kind < 2    ? read_ply(bytes, "m")
                          : kind == 2 ? read_off(bytes, "m")
                                      : read_obj(bytes, "m");
        if (!read.ok()) {
            ASSERT_EQ(read.error().where[0], 'm') << read.error().message();
            continue;
        }
        for (const auto& t : read->triangles) {
            for (const std::uint32_t corner : t) ASSERT_LT(corner, read->positions.size());
        }
        for (const glm::dvec3& p : read->positions) ASSERT_TRUE(p.x - p.x == 0.0);
    }
}

TEST(ReadMesh, NamesMissingAndUnknownFiles) {
    expect_starts(read_mesh("no/such.obj"), "no/such.obj: no such file");
    expect_starts(read_mesh("thing.stl"), "thing.stl: the mesh file is of an unknown type");
}

}  // namespace
}  // namespace repousse::host
