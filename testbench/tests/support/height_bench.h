#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "datapath/units/height_test.h"
#include "testbench/reference/height_oracle.h"
#include "tlm/config/profile_reader.h"

namespace repousse::test {

/// A texel in the default profile's UV.
inline constexpr int kOne = 256;

/// A map with its table, the unit and the oracle on it.
struct HeightBench {
    HeightBench(int width, int height, const std::function<uint32_t(int, int)>& texel)
        : profile(*shipped_profile("default")), unit(profile) {
        registers.width = oracle.width = width;
        registers.height = oracle.height = height;
        oracle.frac = profile.uv.frac;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) oracle.heights.push_back(texel(x, y));
        }
        table.assign(std::size_t(width + 1) * std::size_t(height + 1), 0);
        const auto at = [&](int x, int y) -> uint64_t& {
            return table[std::size_t(y) * std::size_t(width + 1) + std::size_t(x)];
        };
        const uint64_t mask = (uint64_t{1} << profile.sat_width) - 1;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const uint64_t h = oracle.heights[std::size_t(y * width + x)];
                at(x + 1, y + 1) = (at(x, y + 1) + at(x + 1, y) - at(x, y) + h) & mask;
            }
        }
    }

    void configure(bool wrap, BoxKind box, HeightMode mode, uint64_t threshold) {
        registers.wrap = oracle.wrap = wrap;
        registers.box = box;
        registers.mode = mode;
        registers.threshold = oracle.threshold = threshold;
        oracle.literal = box == BoxKind::Literal;
        oracle.sum = mode == HeightMode::Sum;
        ASSERT_TRUE(unit.check(registers, table.size()).ok())
            << unit.check(registers, table.size()).error().message();
        unit.configure(registers, table);
    }

    bool operator()(Uv u1, Uv u2) {
        return unit(u1, u2, {(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1}, stats);
    }

    /// Unit and oracle agree, and do so from both sides of the edge.
    void expect_agreement(Uv u1, Uv u2) {
        const Uv u12{(u1.x + u2.x) >> 1, (u1.y + u2.y) >> 1};
        ASSERT_TRUE(unit.accepts(u1, u2, u12));
        const bool expected = oracle({u1.x, u1.y}, {u2.x, u2.y}, {u12.x, u12.y});
        EXPECT_EQ((*this)(u1, u2), expected) << u1.x << ',' << u1.y << " to " << u2.x << ',' << u2.y
                                             << ", threshold " << registers.threshold;
        EXPECT_EQ((*this)(u2, u1), expected) << "not symmetric";
    }

    Profile profile;
    HeightTest unit;
    HeightTestRegisters registers;
    HeightTestStats stats;
    reference::HeightOracle oracle;
    std::vector<uint64_t> table;
};

inline HeightBench noise_map(int width, int height) {
    std::mt19937 random(1);
    return HeightBench(width, height, [&](int, int) { return random() & 0xffff; });
}

}  // namespace repousse::test
