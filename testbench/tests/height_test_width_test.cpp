// How many bits the summed-area table and SUM's difference need (adaptive-tessellation.md,
// section 4): 32 stored and 33 signed at 512 x 512, 38 and 39 at 4096 x 4096, for 16-bit heights
// and edges of up to W texels. One bit fewer fails, each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "datapath/units/height_test.h"
#include "tlm/config/profile_reader.h"

namespace repousse {
namespace {

struct Size {
    int texels;     // of the map, both ways
    int sat_width;  // stored bits
};

uint64_t mask(int bits) { return (uint64_t{1} << bits) - 1; }

int64_t sign_extend(uint64_t value, int bits) {
    return static_cast<int64_t>(value << (64 - bits)) >> (64 - bits);
}

/// Unreduced prefix sums, 64 bits.
std::vector<uint64_t> full_table(int size, const std::function<uint64_t()>& texel) {
    const auto columns = static_cast<std::size_t>(size + 1);
    std::vector<uint64_t> table(columns * columns, 0);
    for (std::size_t y = 1; y < columns; ++y) {
        uint64_t row = 0;
        for (std::size_t x = 1; x < columns; ++x) {
            row += texel();
            table[y * columns + x] = table[(y - 1) * columns + x] + row;
        }
    }
    return table;
}

class HeightTestWidth : public testing::TestWithParam<Size> {
protected:
    /// The sum of [x0, x1) x [y0, y1) from a table of `bits` stored bits.
    uint64_t box(const std::vector<uint64_t>& table, int x0, int y0, int x1, int y1,
                 int bits) const {
        const auto at = [&](int x, int y) {
            const auto columns = static_cast<std::size_t>(GetParam().texels + 1);
            return table[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] &
                   mask(bits);
        };
        return (at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0)) & mask(bits);
    }

    Profile profile(int sat_width) const {
        Profile p = *shipped_profile("default");
        p.sat_width = sat_width;
        return p;
    }
};

INSTANTIATE_TEST_SUITE_P(Maps, HeightTestWidth, testing::Values(Size{512, 32}, Size{4096, 38}),
                         [](const testing::TestParamInfo<Size>& size) {
                             return "Of" + std::to_string(size.param.texels);
                         });

TEST_P(HeightTestWidth, TheLargestBoxFillsTheTableAndOneBitFewerLosesIt) {
    const auto [size, stored] = GetParam();
    const auto table = full_table(size, [] { return 65535; });
    const auto half = static_cast<uint64_t>(size / 2);
    const uint64_t truth = half * half * 65535;
    const int a = size / 4;
    const int b = a + size / 2;
    EXPECT_EQ(box(table, a, a, b, b, stored), truth);
    EXPECT_NE(box(table, a, a, b, b, stored - 1), truth);
}

TEST_P(HeightTestWidth, TheSignedDifferenceNeedsOneBitMore) {
    const auto [size, stored] = GetParam();
    // The extremes: everything around U12 and nothing around the ends, and the reverse.
    const uint64_t mid = uint64_t(size / 2) * uint64_t(size / 2) * 65535;
    const uint64_t ends = 2 * (uint64_t(size / 4) * uint64_t(size / 4) * 65535);
    const auto difference = [](uint64_t s12, uint64_t s, int bits) {
        return sign_extend((s12 - 2 * s) & mask(bits), bits);
    };
    EXPECT_EQ(difference(mid, 0, stored + 1), int64_t(mid));
    EXPECT_NE(difference(mid, 0, stored), int64_t(mid));
    EXPECT_EQ(difference(0, ends, stored + 1), -int64_t(2 * ends));
    EXPECT_NE(difference(0, ends, stored), -int64_t(2 * ends));
}

TEST_P(HeightTestWidth, TheLongestEdgeIsTheMapsWidth) {
    const auto [size, stored] = GetParam();
    const std::vector<uint64_t> table(std::size_t(size + 1) * std::size_t(size + 1));
    HeightTestRegisters registers;
    registers.width = registers.height = size;
    for (const bool wrap : {false, true}) {
        registers.wrap = wrap;
        HeightTest unit(profile(stored));
        unit.configure(registers, table);
        EXPECT_EQ(unit.max_edge(), size);
        const int32_t w = size << 8;
        EXPECT_TRUE(unit.accepts({0, 0}, {w, w}, {w / 2, w / 2}));
        EXPECT_FALSE(unit.accepts({0, 0}, {w + 1, w}, {w / 2, w / 2}));
        HeightTest narrower(profile(stored - 1));
        narrower.configure(registers, table);
        EXPECT_LT(narrower.max_edge(), size) << "one bit fewer must not accept the same edges";
    }
}

/// Random edges of up to W texels: decisions with the stored width against those of true sums.
TEST_P(HeightTestWidth, DecisionsAreExactOnConstantAndRandomMaps) {
    const auto [size, stored] = GetParam();
    std::mt19937 random(5);
    for (const bool constant : {true, false}) {
        const auto full = full_table(size, [&] { return constant ? 65535 : random() & 0xffff; });
        std::vector<uint64_t> table = full;
        for (uint64_t& entry : table) entry &= mask(stored);
        HeightTest unit(profile(stored));
        HeightTestRegisters registers;
        registers.width = registers.height = size;
        HeightTestStats stats;
        int fired = 0;
        for (int i = 0; i < 20000; ++i) {
            registers.mode = i % 2 == 0 ? HeightMode::Sum : HeightMode::Average;
            registers.threshold =
                registers.mode == HeightMode::Sum ? random() >> random() % 32 : random() % 50;
            unit.configure(registers, table);
            const auto c = [&] { return int32_t(random() % uint32_t((size << 8) + 1)); };
            const Uv u1{c(), c()}, u2{c(), c()}, u12{(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
            const int32_t e = std::max(std::abs(u1.x - u2.x), std::abs(u1.y - u2.y));
            uint64_t area[3];
            uint64_t sums[3];
            int k = 0;
            for (const auto& [u, half] : {std::pair{u1, e >> 3}, {u2, e >> 3}, {u12, e >> 2}}) {
                const auto side = [&](int32_t x) {
                    int lo = std::clamp((x - half) >> 8, 0, size);
                    int hi = std::clamp((x + half) >> 8, 0, size);
                    if (lo == hi && registers.mode == HeightMode::Average) {
                        lo == size ? --lo : ++hi;
                    }
                    return std::pair{lo, hi};
                };
                const auto [x0, x1] = side(u.x);
                const auto [y0, y1] = side(u.y);
                area[k] = uint64_t(x1 - x0) * uint64_t(y1 - y0);
                sums[k++] = box(full, x0, y0, x1, y1, 63);
            }
            const bool expected =
                registers.mode == HeightMode::Sum
                    ? uint64_t(std::abs(int64_t(sums[2]) - 2 * int64_t(sums[0] + sums[1]))) >
                          2 * registers.threshold
                    : std::abs(int64_t(sums[2] * (area[0] + area[1])) -
                               int64_t((sums[0] + sums[1]) * area[2])) >
                          int64_t(registers.threshold * area[2] * (area[0] + area[1]));
            ASSERT_EQ(unit(u1, u2, u12, stats), expected) << "sum around U12 " << sums[2];
            fired += expected;
        }
        EXPECT_EQ(stats.refused, 0U);
        EXPECT_GT(fired, 100);
    }
}

}  // namespace
}  // namespace repousse
