// The view's fill rule: every pixel's centre belongs to one triangle of those that share an edge.
// The oracle is the winding number of closed polygons, by crossings of a ray, which shares neither
// edge functions nor biases with the rasteriser. Meshes: fill_rule_mesh_test.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "testbench/host/view/rasteriser.h"
#include "testbench/tests/support/triangulation.h"
#include "testbench/tests/support/winding.h"

namespace repousse::host {
namespace {

using test::HalfEdge;
using test::winding;

TEST(FillRule, TopAndLeftEdgesAreInBottomAndRightOnesOut) {
    // A square from the centre of pixel (0, 0) to that of (2, 2), as two triangles each way round.
    const SnappedVertex a{128, 128}, b{640, 128}, c{640, 640}, d{128, 640};
    int seen[4][4] = {};
    const auto visit = [&](int x, int y, const Weights& w) {
        ++seen[y][x];
        EXPECT_NEAR(w.a + w.b + w.c, 1.0, 1e-12);
    };
    rasterise(a, b, c, {0, 0, 4, 4}, visit);
    rasterise(d, c, a, {0, 0, 4, 4}, visit);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(seen[y][x], x < 2 && y < 2 ? 1 : 0);
    }
}

TEST(FillRule, EveryTriangleCoversWhatItWindsAround) {
    std::mt19937_64 random(17);
    constexpr int kSide = 12;
    std::size_t on_edge = 0, covered = 0;
    for (int n = 0; n < 200'000; ++n) {
        // Corners on centres and corners of pixels, on a finer raster, anywhere, and far outside.
        const std::int64_t grain = std::array<std::int64_t, 4>{128, 64, 1, 128}[n % 4];
        const std::int64_t reach = n % 16 == 3 ? std::int64_t{1} << 27 : 14 * kSubpixels;
        const auto corner = [&] {
            const auto any = [&] {
                const auto spread = static_cast<std::uint64_t>(2 * reach / grain);
                return grain * static_cast<std::int64_t>(random() % spread) - reach +
                       6 * kSubpixels;
            };
            return SnappedVertex{any(), any()};
        };
        const SnappedVertex a = corner(), b = corner();
        // Every third is a sliver: nearly on a line with the other two, or exactly.
        const SnappedVertex c =
            n % 3 == 0 ? SnappedVertex{(a.x + b.x) / 2 + grain * (n % 2), (a.y + b.y) / 2}
                       : corner();
        int seen[kSide][kSide] = {};
        rasterise(a, b, c, {0, 0, kSide, kSide}, [&](int x, int y, const Weights& w) {
            ++seen[y][x];
            on_edge += w.a == 0 || w.b == 0 || w.c == 0;
        });
        const std::vector<HalfEdge> edges{{a, b}, {b, c}, {c, a}};
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                ASSERT_EQ(seen[y][x], std::abs(winding(edges, x, y))) << n << ": " << x << " " << y;
                covered += seen[y][x] != 0;
            }
        }
    }
    EXPECT_GT(on_edge, 10'000u);
    EXPECT_GT(covered, 1'000'000u);
}

/// Centres of a square of `side` pixels that a triangulation of it covers wrongly.
struct Wrong {
    std::size_t twice = 0;
    std::size_t missed = 0;
    std::size_t centres = 0;
};

using Inside = std::function<bool(const EdgeFunction&, const EdgeFunction&, const EdgeFunction&)>;

/// By a rule of one's own, from the edge functions at each centre.
Wrong judge_rule(const test::Triangulation& sheet, const Inside& inside) {
    const auto at = [&](std::size_t v) {
        const auto& p = sheet.points[v];
        return SnappedVertex{p[0] * kSubpixels + kSubpixels / 2,
                             p[1] * kSubpixels + kSubpixels / 2};
    };
    Wrong wrong;
    for (int y = 0; y < sheet.side; ++y) {
        for (int x = 0; x < sheet.side; ++x) {
            int count = 0;
            for (const auto& t : sheet.triangles) {
                const SnappedVertex a = at(t[0]), b = at(t[1]), c = at(t[2]);
                count += inside({a, b, x, y}, {b, c, x, y}, {c, a, x, y});
            }
            wrong.twice += count > 1;
            wrong.missed += count == 0;
            ++wrong.centres;
        }
    }
    return wrong;
}

/// The square's corners are on centres, so those of its right and lower border are outside.
Wrong judge_rasteriser(const test::Triangulation& sheet) {
    const int side = sheet.side + 2;
    std::vector<int> counts(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    const auto at = [&](std::size_t v) {
        const auto& p = sheet.points[v];
        return SnappedVertex{p[0] * kSubpixels + kSubpixels / 2,
                             p[1] * kSubpixels + kSubpixels / 2};
    };
    for (const auto& t : sheet.triangles) {
        rasterise(at(t[0]), at(t[1]), at(t[2]), {0, 0, side, side},
                  [&](int x, int y, const Weights&) {
                      ++counts[static_cast<std::size_t>(y * side + x)];
                  });
    }
    Wrong wrong;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const int expected = x < sheet.side && y < sheet.side ? 1 : 0;
            const int count = counts[static_cast<std::size_t>(y * side + x)];
            wrong.twice += count > expected;
            wrong.missed += count < expected;
            ++wrong.centres;
        }
    }
    return wrong;
}

TEST(FillRule, TriangulationsWithAllVerticesOnCentres) {
    std::mt19937_64 random(29);
    Wrong total;
    std::size_t triangles = 0;
    for (int n = 0; n < 400; ++n) {
        const int side = 8 + n % 25;
        const test::Triangulation sheet = test::random_triangulation(side, 4 + n % 150, random);
        const Wrong wrong = judge_rasteriser(sheet);
        total.twice += wrong.twice;
        total.missed += wrong.missed;
        total.centres += wrong.centres;
        triangles += sheet.triangles.size();
    }
    std::printf("400 triangulations, %zu triangles, %zu centres: %zu twice, %zu missed\n",
                triangles, total.centres, total.twice, total.missed);
    EXPECT_EQ(total.twice, 0u);
    EXPECT_EQ(total.missed, 0u);
    EXPECT_GT(triangles, 40'000u);
}

TEST(FillRule, WithoutItCentresOnEdgesAreDrawnTwiceOrMissed) {
    std::mt19937_64 random(29);
    Wrong closed, open, ruled;
    for (int n = 0; n < 20; ++n) {
        const test::Triangulation sheet = test::random_triangulation(16, 60, random);
        const auto add = [&](Wrong& sum, const Inside& inside) {
            const Wrong wrong = judge_rule(sheet, inside);
            sum.twice += wrong.twice;
            sum.missed += wrong.missed;
            sum.centres += wrong.centres;
        };
        add(closed, [](const auto& a, const auto& b, const auto& c) {
            return a.at_start >= 0 && b.at_start >= 0 && c.at_start >= 0;
        });
        add(open, [](const auto& a, const auto& b, const auto& c) {
            return a.at_start > 0 && b.at_start > 0 && c.at_start > 0;
        });
        add(ruled, [](const auto& a, const auto& b, const auto& c) {
            return a.at_start + a.bias >= 0 && b.at_start + b.bias >= 0 && c.at_start + c.bias >= 0;
        });
    }
    std::printf("%zu centres: >= covers %zu twice, > misses %zu\n", closed.centres, closed.twice,
                open.missed);
    EXPECT_GT(closed.twice, closed.centres / 10);
    EXPECT_GT(open.missed, open.centres / 10);
    EXPECT_EQ(ruled.twice + ruled.missed, 0u);
}

}  // namespace
}  // namespace repousse::host
