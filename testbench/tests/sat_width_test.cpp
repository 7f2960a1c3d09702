// How many bits the summed-area table needs: 32 stored bits at 512 x 512 and 38 at 4096 x 4096, one
// more in SUM's signed difference, for edges no longer than the map. One bit fewer fails each.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "datapath/units/height_test.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/map/summed_area_table.h"
#include "testbench/tests/support/profiles.h"

namespace repousse {
namespace {

constexpr uint64_t kSeed = 512;

struct Case {
    int size;
    int bits;
    int boxes;
};
const Case kCases[] = {{512, 32, 20'000}, {4096, 38, 20'000}};

struct Rect {
    int x0, y0, x1, y1;
};

// Exact prefix sums, made here: int64 has room for 2^24 texels of 16 bits.
class Exact {
public:
    explicit Exact(const host::HeightMap& map)
        : stride_(std::size_t(map.width) + 1), table_(stride_ * (std::size_t(map.height) + 1)) {
        for (std::size_t y = 1; y * stride_ < table_.size(); ++y) {
            for (std::size_t x = 1; x < stride_; ++x) {
                at(x, y) =
                    at(x - 1, y) + at(x, y - 1) - at(x - 1, y - 1) + map.at(int(x) - 1, int(y) - 1);
            }
        }
    }
    int64_t sum(const Rect& r) const {
        return corner(r.x1, r.y1) - corner(r.x0, r.y1) - corner(r.x1, r.y0) + corner(r.x0, r.y0);
    }

private:
    int64_t& at(std::size_t x, std::size_t y) { return table_[y * stride_ + x]; }
    int64_t corner(int x, int y) const { return table_[std::size_t(y) * stride_ + std::size_t(x)]; }

    std::size_t stride_;
    std::vector<int64_t> table_;
};

// The three boxes of an edge of full length at random places, clipped to the map.
struct Boxes {
    Rect mid, end1, end2;
};

Boxes random_boxes(std::mt19937_64& random, int size) {
    const auto box = [&](int side) {
        const int x = int(random() % uint64_t(size - side + 1));
        const int y = int(random() % uint64_t(size - side + 1));
        return Rect{x, y, x + side, y + side};
    };
    // Half of them as large as they can be, the rest of any size.
    const int edge = random() % 2 ? size : 4 + int(random() % uint64_t(size - 3));
    return {box(edge / 2), box(edge / 4), box(edge / 4)};
}

uint64_t low_bits(uint64_t x, int bits) { return x & ((uint64_t(1) << bits) - 1); }

int64_t as_signed(uint64_t x, int bits) {
    return static_cast<int64_t>(x << (64 - bits)) >> (64 - bits);
}

class SatWidth : public testing::TestWithParam<Case> {
protected:
    // Bright: all heights at the maximum, which fills a table the most. Quadrants: dark and
    // bright by turns, which makes differences the largest.
    enum class Fill { Bright, Random, Quadrants };

    host::HeightMap map(Fill fill) const {
        const int size = GetParam().size;
        host::HeightMap map = host::make_constant_map(size, size, 65535);
        std::mt19937_64 random(kSeed);
        if (fill == Fill::Random) {
            for (uint16_t& h : map.texels) h = uint16_t(random());
        }
        if (fill == Fill::Quadrants) map = host::make_checker_map(size, size, size / 2, 0, 65535);
        return map;
    }
};

TEST_P(SatWidth, BoxSumsAndTheirDifferenceAreExactAndOneBitFewerFails) {
    const auto [size, bits, boxes] = GetParam();
    EXPECT_EQ(host::summed_area_bits(size, size), bits);
    std::size_t wrong_sums = 0, wrong_differences = 0;
    for (const Fill fill : {Fill::Bright, Fill::Random, Fill::Quadrants}) {
        const host::HeightMap heights = map(fill);
        const Exact exact(heights);
        const std::vector<uint64_t> table = host::summed_area_table(heights, bits);
        const auto stored = [&, n = std::size_t(size) + 1](const Rect& r, int width) {
            const auto t = [&](int x, int y) { return table[std::size_t(y) * n + std::size_t(x)]; };
            return low_bits(t(r.x1, r.y1) - t(r.x0, r.y1) - t(r.x1, r.y0) + t(r.x0, r.y0), width);
        };
        std::mt19937_64 random(kSeed + 1);
        for (int i = 0; i < boxes; ++i) {
            const Boxes b = random_boxes(random, size);
            const int64_t s12 = exact.sum(b.mid), s1 = exact.sum(b.end1), s2 = exact.sum(b.end2);
            ASSERT_EQ(stored(b.mid, bits), uint64_t(s12));
            ASSERT_EQ(stored(b.end1, bits), uint64_t(s1));
            wrong_sums += stored(b.mid, bits - 1) != uint64_t(s12);
            const uint64_t difference =
                stored(b.mid, bits) - 2 * (stored(b.end1, bits) + stored(b.end2, bits));
            ASSERT_EQ(as_signed(difference, bits + 1), s12 - 2 * (s1 + s2));
            wrong_differences += as_signed(difference, bits) != s12 - 2 * (s1 + s2);
        }
    }
    std::printf(
        "%d x %d, seed %llu: with %d stored bits %zu of %d sums are wrong, with %d bits "
        "%zu differences\n",
        size, size, (unsigned long long)kSeed, bits - 1, wrong_sums, 3 * boxes, bits,
        wrong_differences);
    EXPECT_GT(wrong_sums, 0u);
    EXPECT_GT(wrong_differences, 0u);
}

// The unit itself, on edges up to its limit, against exact arithmetic.
TEST_P(SatWidth, TheUnitDecidesAsExactArithmeticDoes) {
    const auto [size, bits, boxes] = GetParam();
    const Profile profile =
        test::profile_with("default", {{"sat_width", std::to_string(bits)}, {"uv", "s14.0"}});
    const host::HeightMap heights = map(Fill::Random);
    const Exact exact(heights);
    const std::vector<uint64_t> table = host::summed_area_table(heights, bits);
    for (const HeightMode mode : {HeightMode::Sum, HeightMode::Average}) {
        HeightTest unit(profile);
        HeightTestRegisters registers;
        registers.width = registers.height = size;
        registers.mode = mode;
        std::mt19937_64 random(kSeed + 2);
        HeightTestStats stats;
        int positives = 0;
        for (int i = 0; i < boxes; ++i) {
            const auto place = [&, s = size] { return int(random() % uint64_t(s + 1)); };
            const Uv u1{place(), place()}, u2{place(), place()};
            const Uv u12{(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
            const int e = std::max(std::abs(u1.x - u2.x), std::abs(u1.y - u2.y));
            if (e < 8) continue;  // such boxes are widened: height_test_test's concern
            const auto box = [s = size](Uv u, int half) {
                const auto clip = [s](int x) { return std::clamp(x, 0, s); };
                return Rect{clip(u.x - half), clip(u.y - half), clip(u.x + half), clip(u.y + half)};
            };
            const auto area = [](const Rect& r) { return int64_t(r.x1 - r.x0) * (r.y1 - r.y0); };
            const Rect b12 = box(u12, e >> 2), b1 = box(u1, e >> 3), b2 = box(u2, e >> 3);
            const auto ends = exact.sum(b1) + exact.sum(b2);
            const int64_t both = area(b1) + area(b2);
            // As near to the exact difference as the register allows: one threshold that just
            // fires and one that just does not.
            const int64_t scaled = mode == HeightMode::Sum
                                       ? exact.sum(b12) - 2 * ends
                                       : exact.sum(b12) * both - ends * area(b12);  // 61 bits
            const int64_t unit_of = mode == HeightMode::Sum ? 2 : area(b12) * both;
            const int64_t magnitude = std::abs(scaled);
            const auto at_most = uint64_t(magnitude / unit_of);
            const bool is_exact = magnitude % unit_of == 0;
            for (const int64_t step : {-1, 0, 1}) {
                if (step < 0 && at_most == 0) continue;
                registers.threshold = at_most + uint64_t(step);
                unit.configure(registers, table);
                const bool expected = step < 0 || (step == 0 && !is_exact);
                ASSERT_EQ(unit(u1, u2, u12, stats), expected) << i;
                positives += expected;
            }
        }
        EXPECT_EQ(stats.refused, 0u);
        EXPECT_GT(positives, boxes);
    }
}

TEST_P(SatWidth, EdgesLongerThanTheMapAreRefused) {
    const auto [size, bits, boxes] = GetParam();
    (void)boxes;
    HeightTestRegisters registers;
    registers.width = registers.height = size;
    registers.wrap = true;
    const std::vector<uint64_t> table(std::size_t(size + 1) * std::size_t(size + 1));
    for (int fewer = 0; fewer < 3; ++fewer) {
        const Profile profile =
            test::profile_with("default", {{"sat_width", std::to_string(bits - fewer)}});
        HeightTest unit(profile);
        ASSERT_TRUE(unit.check(registers, table.size()));
        unit.configure(registers, table);
        EXPECT_EQ(unit.max_edge() == size, fewer == 0);
        EXPECT_LE(unit.max_edge(), size);
        const int longest = unit.max_edge() << profile.uv.frac;
        HeightTestStats stats;
        EXPECT_TRUE(unit.accepts({0, 0}, {longest, longest}, {longest / 2, longest / 2}));
        EXPECT_FALSE(unit.accepts({0, 0}, {longest + 1, 0}, {longest / 2, 0}));
        EXPECT_FALSE(unit({0, 0}, {0, longest + 1}, {0, longest / 2}, stats));
        EXPECT_EQ(stats.refused, 1u);
        EXPECT_EQ(stats.reads, 0u);
    }
}

INSTANTIATE_TEST_SUITE_P(Map, SatWidth, testing::ValuesIn(kCases),
                         [](const auto& c) { return "Side" + std::to_string(c.param.size); });

}  // namespace
}  // namespace repousse
