// The displacement bound of boxes of texels against a scan of the map, and against reads.

#include "testbench/host/map/displacement_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "testbench/cosim/random.h"
#include "tlm/config/profile_reader.h"

namespace repousse::host {
namespace {

using cosim::Random;

HeightMap random_map(Random& random, int width, int height, bool wrap) {
    HeightMap map;
    map.width = width;
    map.height = height;
    map.wrap = wrap;
    map.range_low = -0.3;
    map.range_high = 0.7;
    for (int i = 0; i < width * height; ++i) {
        map.texels.push_back(static_cast<uint16_t>(random.percent(5) ? random.below(65536)
                                                                     : 15000 + random.below(9000)));
    }
    return map;
}

int address(int i, int size, bool wrap) {
    return wrap ? (i % size + size) % size : std::clamp(i, 0, size - 1);
}

double height_at(const HeightMap& map, int x, int y) {
    const int h = map.at(address(x, map.width, map.wrap), address(y, map.height, map.wrap));
    return map.range_low + h * map.world_per_lsb();
}

/// max |D| of the texels from floor(low - 1.5) to floor(high + 1.5), one by one.
double scan(const HeightMap& map, glm::dvec2 low, glm::dvec2 high) {
    double most = 0;
    for (int y = int(std::floor(low.y - 1.5)); y <= int(std::floor(high.y + 1.5)); ++y) {
        for (int x = int(std::floor(low.x - 1.5)); x <= int(std::floor(high.x + 1.5)); ++x) {
            most = std::max(most, std::abs(height_at(map, x, y)));
        }
    }
    return most;
}

TEST(DisplacementBound, IsTheScanOfTheBox) {
    Random random(1);
    for (const bool wrap : {false, true}) {
        for (const auto& [width, height] : {std::pair{64, 64}, {37, 53}, {1, 9}, {128, 1}}) {
            const HeightMap map = random_map(random, width, height, wrap);
            const DisplacementBound bound(map);
            for (int i = 0; i < 500; ++i) {
                const auto coordinate = [&](int size) {
                    return double(random.between(-20 * size, 30 * size)) / 16;
                };
                glm::dvec2 a{coordinate(width), coordinate(height)};
                glm::dvec2 b = a + glm::dvec2{random.below(200) / 10.0, random.below(200) / 10.0};
                if (random.percent(5)) b += glm::dvec2{width, height};  // more than the map
                EXPECT_DOUBLE_EQ(bound(a, b), scan(map, a, b))
                    << width << "x" << height << " wrap " << wrap << " from " << a.x << ", " << a.y
                    << " to " << b.x << ", " << b.y;
            }
        }
    }
}

TEST(DisplacementBound, NoReadInsideATriangleExceedsIt) {
    Random random(2);
    for (const bool wrap : {false, true}) {
        const HeightMap map = random_map(random, 48, 32, wrap);
        const DisplacementBound bound(map);
        for (int i = 0; i < 2000; ++i) {
            std::array<Uv, 3> corners;
            for (Uv& uv : corners) {
                uv = {static_cast<int32_t>(random.between(-10 * 256, 58 * 256)),
                      static_cast<int32_t>(random.between(-10 * 256, 42 * 256))};
            }
            const double most = bound.of_triangle(corners, 8);
            for (int k = 0; k < 20; ++k) {
                const double a = random.below(1000) / 1000.0;
                const double b = random.below(1000) / 1000.0 * (1 - a);
                const double c = 1 - a - b;
                const auto at = [&](int32_t Uv::*m) {
                    return (a * corners[0].*m + b * corners[1].*m + c * corners[2].*m) / 256;
                };
                const double u = at(&Uv::x), v = at(&Uv::y);
                // Nearest, and between the four texels around.
                EXPECT_LE(std::abs(height_at(map, int(std::floor(u)), int(std::floor(v)))), most);
                for (const int dx : {0, 1}) {
                    for (const int dy : {0, 1}) {
                        EXPECT_LE(std::abs(height_at(map, int(std::floor(u - 0.5)) + dx,
                                                     int(std::floor(v - 0.5)) + dy)),
                                  most);
                    }
                }
            }
        }
    }
}

TEST(DisplacementBound, CellsAreTighterThanTheObject) {
    HeightMap map;
    map.width = map.height = 64;
    map.texels.assign(64 * 64, 0);
    map.texels[10 * 64 + 10] = 65535;  // one peak
    const DisplacementBound bound(map, 0.25);
    EXPECT_DOUBLE_EQ(bound.whole(), 1.25);
    EXPECT_DOUBLE_EQ(bound({8, 8}, {12, 12}), 1.25);
    EXPECT_DOUBLE_EQ(bound({30, 30}, {60, 60}), 0.25);
}

TEST(DisplacementBound, NegativeDisplacementCountsToo) {
    HeightMap map;
    map.width = map.height = 4;
    map.texels.assign(16, 0);
    map.range_low = -2;
    map.range_high = 1;
    EXPECT_DOUBLE_EQ(DisplacementBound(map).whole(), 2.0);
}

TEST(DisplacementBound, NarrowHeightsHaveSlack) {
    HeightMap map;
    map.range_high = 2.0;
    EXPECT_DOUBLE_EQ(stored_height_slack(*shipped_profile("narrow"), map), 2.0 / 4095);
    EXPECT_DOUBLE_EQ(stored_height_slack(*shipped_profile("default"), map), 2.0 / 65535);
}

}  // namespace
}  // namespace repousse::host
