// sweep_line's three kinds of adder: exact vertices, edges from both sides, and a closed mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <tuple>

#include "datapath/units/sweep_line.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse {
namespace {

using test::SweepChain;
using test::TriangleKind;
using test::VertexData;
using test::VertexKey;

const SweepLineOptions kTwoLanes = {256, {}};

__extension__ using Wide = __int128;

// floor(numerator / denominator + 1/2) for a positive denominator.
int32_t rounded(Wide numerator, Wide denominator) {
    const Wide a = 2 * numerator + denominator, b = 2 * denominator;
    return static_cast<int32_t>(a / b - (a % b < 0));
}

// The value of a vertex straight from its corners.
int32_t closed_form(const SweepChain& chain, const VertexName& name, std::size_t i) {
    const auto& c = chain.base().corners;
    const auto vertex = test::cover_vertex(name, chain.base());
    if (name.kind == NameKind::Corner) return c[name.part].data[i];
    if (name.kind == NameKind::Edge) {
        const auto &p = c[name.part], &q = c[(name.part + 1u) % 3];
        int32_t n = 1;
        for (std::size_t x = 0; x < 3; ++x) n = std::max(n, std::abs(q.slot[x] - p.slot[x]));
        return rounded(Wide(p.data[i]) * (n - vertex.a) + Wide(q.data[i]) * vertex.a, n);
    }
    const std::size_t s = chain.base().sweep_axis, y = chain.base().side_axis;
    const auto cross = [](int64_t ax, int64_t ay, int64_t bx, int64_t by) {
        return ax * by - ay * bx;
    };
    Wide numerator = 0, denominator = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto &p = c[(k + 1) % 3].slot, &q = c[(k + 2) % 3].slot;
        const int64_t w = cross(p[s] - name.a, p[y] - name.b, q[s] - name.a, q[y] - name.b);
        numerator += Wide(w) * c[k].data[i];
        denominator += w;
    }
    return denominator < 0 ? rounded(-numerator, -denominator) : rounded(numerator, denominator);
}

TEST(SweepAdders, ExactVerticesAreTheTrueOnesRounded) {
    std::mt19937_64 random(2);
    for (const auto& lanes : {SweepLineOptions(), kTwoLanes}) {
        SweepChain chain(lanes);
        for (int n = 0; n < 1000; ++n) {
            chain.remesh(test::with_data(test::mixed_triangle(n, random), random));
            for (const auto& triangle : chain.triangles()) {
                for (const SweepVertex& v : triangle) {
                    for (std::size_t i = 0; i < 13; i += 6) {
                        ASSERT_EQ(v.data[i], closed_form(chain, v.name, i)) << n;
                    }
                }
            }
        }
    }
}

TEST(SweepAdders, EdgesOfFullLengthAreExactToo) {
    std::mt19937_64 random(3);
    SweepChain chain(kTwoLanes);
    for (int n = 0; n < 20; ++n) {
        chain.remesh(test::with_data(test::random_triangle(TriangleKind::FarThin, random), random));
        for (const auto& triangle : chain.triangles()) {
            for (const SweepVertex& v : triangle) {
                ASSERT_EQ(v.data[n % 13], closed_form(chain, v.name, std::size_t(n % 13))) << n;
            }
        }
    }
}

// What two triangles with a common edge make of it.
struct EdgeCracks {
    std::size_t edges = 0, cracked_edges = 0, vertices = 0, cracked_vertices = 0, inside = 0;
    std::size_t inside_vertices = 0;
    int64_t widest = 0;  // LSB
};

EdgeCracks compare_edges(AdderKind adder, int guard_bits, int pairs) {
    std::mt19937_64 random(4);
    SweepChain left({}, {adder, guard_bits, 13}), right({}, {adder, guard_bits, 13});
    EdgeCracks found;
    for (int n = 0; n < pairs; ++n) {
        // Two triangles of different size and plane on the edge from corner 0 to corner 1.
        auto a = test::with_data(test::random_triangle(TriangleKind::Medium, random), random, 17);
        auto b = test::with_data(test::random_triangle(TriangleKind::Medium, random), random, 17);
        a[0].id = static_cast<uint32_t>(random() % 2) * 2 + 1;
        a[1].id = 2;
        a[2].id = b[2].id = static_cast<uint32_t>(random() % 2) * 9;
        b[0] = a[1];
        b[1] = a[0];
        left.remesh(a);
        right.remesh(b);
        std::map<VertexKey, VertexData> of_left, of_right;
        found.inside += test::collect_vertices(left, of_left);
        found.inside += test::collect_vertices(right, of_right);
        found.inside_vertices += of_left.size() + of_right.size();
        std::size_t cracked = 0, common = 0;
        for (const auto& [key, data] : of_left) {
            if (std::get<0>(key) != int(NameKind::Edge) || std::get<1>(key) != 0) continue;
            const auto other = of_right.find(key);
            if (other == of_right.end()) {
                ADD_FAILURE() << "an edge vertex is missing on the other side";
                continue;
            }
            ++common;
            cracked += data != other->second;
            for (std::size_t i = 0; i < 13; ++i) {
                const int64_t d = int64_t(data[i]) - other->second[i];
                found.widest = std::max(found.widest, d < 0 ? -d : d);
            }
        }
        found.vertices += common;
        found.cracked_vertices += cracked;
        found.edges += common > 0;
        found.cracked_edges += cracked > 0;
    }
    return found;
}

TEST(SweepAdders, ExactAndCanonicalEdgesAreTheSameFromBothSides) {
    for (const auto& [adder, guard] :
         {std::pair(AdderKind::Exact, 0), {AdderKind::Canonical, 0}, {AdderKind::Canonical, 8}}) {
        const EdgeCracks found = compare_edges(adder, guard, 200);
        EXPECT_EQ(found.cracked_vertices, 0u);
        EXPECT_EQ(found.inside, 0u) << "one name, two values in a base triangle";
        EXPECT_GT(found.vertices, 10'000u);
    }
}

TEST(SweepAdders, PlainEdgesCrackWithAndWithoutGuardBits) {
    for (const int guard : {0, 4, 8, 12}) {
        const EdgeCracks found = compare_edges(AdderKind::Plain, guard, 200);
        std::printf(
            "plain, %2d guard bits: %.1f %% of edge vertices, %.1f %% of base edges crack, "
            "at most %lld LSB; %.2f %% of vertices differ within a triangle\n",
            guard, 100.0 * double(found.cracked_vertices) / double(found.vertices),
            100.0 * double(found.cracked_edges) / double(found.edges),
            static_cast<long long>(found.widest),
            100.0 * double(found.inside) / double(found.inside_vertices));
        EXPECT_GT(found.cracked_edges, 0u);
    }
}

// What the canonical kind pays for having no remainder: it drifts by half a step's rounding each,
// that is by up to half the steps in LSB without guard bits.
TEST(SweepAdders, CanonicalEdgesDrift) {
    for (const int guard : {0, 4, 8, 13}) {
        std::mt19937_64 random(14);
        SweepChain chain({}, {AdderKind::Canonical, guard, 13});
        int64_t worst = 0;
        for (int n = 0; n < 400; ++n) {
            const auto points = test::random_triangle(TriangleKind::Medium, random);
            chain.remesh(test::with_data(points, random, 17));
            for (const auto& triangle : chain.triangles()) {
                for (const SweepVertex& v : triangle) {
                    if (v.name.kind != NameKind::Edge) continue;
                    const int64_t d = int64_t(v.data[0]) - closed_form(chain, v.name, 0);
                    worst = std::max(worst, d < 0 ? -d : d);
                }
            }
        }
        std::printf("canonical, %2d guard bits: at most %lld LSB beside the true value, rounded\n",
                    guard, static_cast<long long>(worst));
        EXPECT_LE(worst, (100 >> (guard + 1)) + 1) << guard;
        EXPECT_GT(worst, 0);
    }
}

// A tie: data 0 and 1 at the ends of two steps. Half up, whichever end is first.
TEST(SweepAdders, ExactHalfTiesRoundTheSameFromBothEnds) {
    for (const AdderKind adder : {AdderKind::Exact, AdderKind::Canonical}) {
        for (const int first : {0, 1}) {
            auto corners = test::corners_of({{{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}});
            corners[0].id = static_cast<uint32_t>(first);
            corners[1].id = static_cast<uint32_t>(1 - first);
            corners[static_cast<std::size_t>(first)].data.fill(1);
            SweepChain chain({}, {adder, 4, 13});
            chain.remesh(corners);
            std::map<VertexKey, VertexData> vertices;
            EXPECT_EQ(test::collect_vertices(chain, vertices), 0u);
            EXPECT_EQ(vertices.at({int(NameKind::Edge), 0, 1, 0})[5], 1);
        }
    }
}

// ---- a closed mesh ------------------------------------------------------------------------------

// Kind; base vertex, or both ends of the edge, or triangle; step, or grid point.
using MeshName = std::tuple<int, uint32_t, uint32_t, int, int>;

MeshName mesh_name(const VertexName& name, const SweepTriangle& triangle, uint32_t number) {
    const auto& c = triangle.corners;
    const uint32_t id = c[name.part].id, next = c[(name.part + 1u) % 3].id;
    if (name.kind == NameKind::Corner) return {0, id, 0, 0, 0};
    if (name.kind == NameKind::Interior) return {2, number, 0, name.a, name.b};
    return {1, std::min(id, next), std::max(id, next), name.a, 0};
}

struct MeshReport {
    std::size_t vertices = 0, open_edges = 0, cracked = 0;
};

// Octahedra with corners anywhere, many of them flat or folded: closed whatever the corners are.
MeshReport remesh_octahedra(const TriangleSetupOptions& adder, const SweepLineOptions& lanes) {
    static constexpr uint32_t kFaces[8][3] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                              {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    MeshReport report;
    std::mt19937_64 random(12);
    SweepChain chain(lanes, adder);
    for (int n = 0; n < 60; ++n) {
        std::array<SweepCorner, 6> corners;
        for (uint32_t i = 0; i < 6; ++i) {
            corners[i].id = i;
            for (int32_t& x : corners[i].slot) x = int(random() % (n % 3 == 0 ? 7u : 60u));
            for (int32_t& x : corners[i].data) x = static_cast<int32_t>(random()) >> 14;
        }
        std::map<MeshName, VertexData> vertices;
        std::map<std::pair<MeshName, MeshName>, int> balance;
        for (uint32_t f = 0; f < 8; ++f) {
            chain.remesh({corners[kFaces[f][0]], corners[kFaces[f][1]], corners[kFaces[f][2]]});
            for (const auto& triangle : chain.triangles()) {
                std::array<MeshName, 3> names;
                for (std::size_t k = 0; k < 3; ++k) {
                    names[k] = mesh_name(triangle[k].name, chain.base(), f);
                    const auto [at, is_new] = vertices.emplace(names[k], triangle[k].data);
                    report.cracked += !is_new && at->second != triangle[k].data;
                }
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto &p = names[k], &q = names[(k + 1) % 3];
                    p < q ? ++balance[{p, q}] : --balance[{q, p}];
                }
            }
        }
        for (const auto& edge : balance) report.open_edges += edge.second != 0;
        report.vertices += vertices.size();
    }
    return report;
}

TEST(SweepAdders, AClosedMeshStaysClosed) {
    for (const auto& lanes : {SweepLineOptions(), kTwoLanes}) {
        for (const auto& adder : {TriangleSetupOptions{AdderKind::Exact, 0, 13},
                                  {AdderKind::Canonical, 0, 13},
                                  {AdderKind::Canonical, 13, 13}}) {
            const MeshReport report = remesh_octahedra(adder, lanes);
            EXPECT_GT(report.vertices, 50'000u);
            EXPECT_EQ(report.open_edges, 0u);
            EXPECT_EQ(report.cracked, 0u);
        }
    }
    const MeshReport plain = remesh_octahedra({AdderKind::Plain, 0, 13}, {});
    EXPECT_EQ(plain.open_edges, 0u) << "the triangles do not depend on the adder";
    EXPECT_GT(plain.cracked, 0u);
}

}  // namespace
}  // namespace repousse
