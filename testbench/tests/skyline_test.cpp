// Silhouettes, peaks of curves and maps, and what part of their heights a surface keeps.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "testbench/host/map/procedural_map.h"
#include "testbench/study/skyline.h"

namespace repousse::study {
namespace {

/// A roof: its ridge runs from (0, 0, 1) to (0, 4, 2), its eaves are on the ground.
host::RenderMesh roof() {
    host::RenderMesh mesh;
    mesh.positions = {{-1, 0, 0}, {-1, 4, 0}, {0, 0, 1}, {0, 4, 2}, {1, 0, 0}, {1, 4, 0}};
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
    return mesh;
}

/// Looks along y from far away, 100 pixels a unit: columns 0 to 399 are x = -2 to 2, row 400 is
/// z = 0.
host::CameraSettings along_y() {
    host::CameraSettings camera;
    camera.eye = {0.0, -1e5, 2.0};
    camera.target = {0.0, 0.0, 2.0};
    camera.fov_deg = 2.0 * std::atan(2.0 / 1e5) * 180.0 / 3.14159265358979323846;
    camera.far = 1e6;
    return camera;
}

// The ridge is between columns 199 and 200; a roof as narrow as a pixel keeps its height too.
TEST(Skyline, IsTheHighestEdgeAnywhereInTheColumn) {
    const host::Viewport viewport{400, 400};
    const auto view = host::view_projection(along_y(), viewport);
    const auto curve = skyline(roof(), view, viewport);
    ASSERT_EQ(curve.size(), 400u);
    EXPECT_EQ(curve[50], 0.0);  // beside it
    for (int x = 110; x < 290; ++x) {
        // The end of the column that is nearer to the ridge.
        const double from_middle = (x < 200 ? 199.0 - x : x - 200.0) / 100.0;
        EXPECT_NEAR(curve[static_cast<std::size_t>(x)], 200.0 * (1.0 - from_middle), 0.02) << x;
    }
    host::RenderMesh needle = roof();
    for (glm::dvec3& p : needle.positions) p.x = 0.004 * p.x + 0.0051;  // within column 200
    const auto thin = skyline(needle, view, viewport);
    EXPECT_NEAR(thin[200], 200.0, 0.02);
    EXPECT_EQ(thin[199], 0.0);
    EXPECT_EQ(thin[201], 0.0);
}

TEST(Skyline, PeaksAreTheHighestWithinReachAndTheFirstOfEqualOnes) {
    const std::vector<double> curve{1, 3, 3, 2, 5, 4, 4, 1, 0, 2};
    const std::vector<double> flat(curve.size(), 0.0);
    const auto all = peaks_of(curve, flat, 1, 10);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].x, 4);
    EXPECT_EQ(all[1].x, 1);
    EXPECT_EQ(all[2].x, 9);
    EXPECT_EQ(peaks_of(curve, flat, 3, 10).size(), 1u);
    EXPECT_EQ(peaks_of(curve, flat, 1, 2).size(), 2u);
    // Above a ground of 1 the last one is 1 high, and a lower curve keeps part of it.
    const std::vector<double> ground(curve.size(), 1.0);
    const auto above = peaks_of(curve, ground, 1, 10);
    ASSERT_EQ(above.size(), 3u);
    std::vector<double> lower = curve;
    lower[4] = 3.0;  // 4 -> 3 beside it
    const PeaksKept part = kept(above, lower, ground, 1);
    EXPECT_NEAR(part.least, 3.0 / 4.0, 1e-12);
    EXPECT_NEAR(part.mean, (3.0 / 4.0 + 1.0 + 1.0) / 3.0, 1e-12);
    EXPECT_NEAR(part.lost, (1.0 / 4.0) / 3.0, 1e-12);
    EXPECT_EQ(part.most, 1.0);
    // What is higher than it was does not make good for what is lost.
    lower[9] = 4.0;
    EXPECT_NEAR(kept(above, lower, ground, 1).lost, part.lost, 1e-12);
    EXPECT_NEAR(kept(above, lower, ground, 1).most, 3.0, 1e-12);
}

TEST(Skyline, PeaksOfAMap) {
    host::HeightMap map = host::make_constant_map(12, 9, 10);
    map.texels[2 * 12 + 3] = 500;
    map.texels[2 * 12 + 5] = 400;  // within reach of the one before
    map.texels[7 * 12 + 10] = 300;
    const auto peaks = peaks_of(map, 2, 2);
    ASSERT_EQ(peaks.size(), 2u);
    EXPECT_EQ(peaks[0].x, 3);
    EXPECT_EQ(peaks[0].y, 2);
    EXPECT_EQ(peaks[0].height, 500.0);
    EXPECT_EQ(peaks[1].x, 10);
}

TEST(Skyline, KeptOfASurfaceLooksAroundEachPeak) {
    host::HeightMap map = host::make_constant_map(12, 9, 0);
    map.range_low = 1.0;
    map.range_high = 11.0;
    host::RenderMesh coarse;
    coarse.positions = {{0.5, 0.1, 4.5}, {0.9, 0.7, 2.5}, {0.6, 0.4, 9.0}};
    // Texels of 0.1, reach 2: the vertex of height 9 is outside of both. 13107 LSB are 2 units.
    const std::vector<Peak> peaks{{3, 2, 26214.0}, {10, 7, 13107.0}};
    const PeaksKept part = kept(peaks, coarse, {0.1, 0.1}, map, 2);
    EXPECT_NEAR(part.least, 1.5 / 2.0, 1e-12);
    EXPECT_NEAR(part.mean, (3.5 / 4.0 + 1.5 / 2.0) / 2.0, 1e-12);
}

}  // namespace
}  // namespace repousse::study
