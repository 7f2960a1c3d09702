// grid_transform's depth: the tables' errors and bits, and that they are monotone. Figures are
// printed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "testbench/tests/support/grid_unit.h"

namespace repousse {
namespace {

/// The largest |z_grid - exact| over `count` depths between near and far, evenly in z, and over
/// every depth of the first `near_ones` LSB behind near.
double worst_depth_error(test::GridUnit& unit, double near, double far, int count,
                         int near_ones = 0) {
    double worst = 0;
    const auto visit = [&](int32_t w) {
        worst = std::max(worst, std::abs(unit.z(w) - unit.exact_z(w)));
    };
    for (int i = 0; i <= count; ++i)
        visit(unit.raw_w(near * std::pow(far / near, double(i) / count)));
    for (int i = 0; i < near_ones; ++i) visit(unit.raw_w(near) + i);
    return worst;
}

TEST(OctaveLog2, ErrorsAndBitsOfTheTables) {
    // All 2^20 mantissas; the error holds the one of the dropped bits, none here.
    struct Row {
        OctaveLog2::Pieces kind;
        int index_bits;
        double bound;  // log2 of the error
        int64_t bits;
    };
    using P = OctaveLog2::Pieces;
    for (const Row& row : {Row{P::Linear, 4, -11.4, 368}, Row{P::Linear, 5, -13.4, 832},
                           Row{P::Linear, 6, -15.3, 1856}, Row{P::Linear, 8, -18.5, 8448},
                           Row{P::Quadratic, 2, -11.8, 148}, Row{P::Quadratic, 3, -14.6, 344},
                           Row{P::Quadratic, 4, -17.2, 784}}) {
        const OctaveLog2 table(row.kind, row.index_bits);
        double worst = 0;
        int64_t before = -1;
        int falls = 0;
        for (uint64_t x = 1 << 20; x <= 2 << 20; ++x) {
            const int64_t log = table(x);
            worst = std::max(worst, std::abs(std::ldexp(double(log), -20) - std::log2(double(x))));
            falls += log < before;
            before = log;
        }
        std::printf("%s, %d index bits: %lld bits, error 2^%.2f\n",
                    row.kind == P::Linear ? "linear" : "quadratic", row.index_bits,
                    (long long)table.table_bits(), std::log2(worst));
        EXPECT_LE(std::log2(worst), row.bound);
        EXPECT_GE(std::log2(worst), row.bound - 0.2) << "the bound is loose";
        EXPECT_EQ(table.table_bits(), row.bits);
        EXPECT_EQ(falls, 0);
    }
}

TEST(OctaveLog2, IsMonotoneAtEveryPositionOfTheLeadingOneAndInEverySize) {
    for (const auto kind : {OctaveLog2::Pieces::Linear, OctaveLog2::Pieces::Quadratic}) {
        for (int bits = 1; bits <= OctaveLog2::kMaxIndexBits; ++bits) {
            const OctaveLog2 table(kind, bits);
            for (std::size_t i = 0; i < table.pieces().size(); ++i) {
                const OctaveLog2::Piece& p = table.pieces()[i];
                ASSERT_LT(p.knot, 1u << table.knot_bits());
                ASSERT_LT(p.rise, 1u << table.rise_bits());
                ASSERT_LT(p.bend, 1u << table.bend_bits());
                ASSERT_TRUE(p.bend == 0 || p.rise > 2 * p.bend) << "a step could fall";
            }
            for (int exponent = 0; exponent < 40; ++exponent) {
                const uint64_t octave = uint64_t{1} << exponent;
                EXPECT_LE(table(octave - 1), table(octave)) << exponent;
                EXPECT_LE(table(2 * octave - 1), table(2 * octave)) << exponent;
            }
        }
    }
}

TEST(GridTransform, DepthIsWithinASixteenthOfAGridUnitInTwoKilobits) {
    double worst[2] = {};
    for (const double lines : {300.0, 720.0, 1080.0, 2160.0}) {
        for (const double range : {1e2, 1e3, 1e4}) {
            for (const double near : {0.05, 1.0}) {
                for (const auto kind : {ZTableKind::Linear, ZTableKind::Quadratic}) {
                    const bool linear = kind == ZTableKind::Linear;
                    test::GridUnit unit(test::with_table(kind, linear ? 6 : 3),
                                        test::grid_camera(lines, 90, near, near * range));
                    const double error = worst_depth_error(unit, near, near * range, 200'000);
                    EXPECT_LE(error, 1.0 / 16) << lines << " lines, far / near " << range;
                    worst[linear ? 0 : 1] = std::max(worst[linear ? 0 : 1], error);
                    EXPECT_EQ(unit->counters().grid_saturated, 0U);
                    EXPECT_EQ(unit.table_words(), 0U);
                }
            }
        }
    }
    const OctaveLog2 linear(OctaveLog2::Pieces::Linear, 6);
    const OctaveLog2 quadratic(OctaveLog2::Pieces::Quadratic, 3);
    std::printf(
        "up to 2160 lines, far / near <= 1e4, 90 degrees: linear %.4f grid units in %lld "
        "bits, quadratic %.4f in %lld; a camera changes 2 registers\n",
        worst[0], (long long)linear.table_bits(), worst[1], (long long)quadratic.table_bits());
    EXPECT_LE(linear.table_bits(), 2048);
    EXPECT_LE(quadratic.table_bits(), 400);
    EXPECT_GT(worst[0], 1.0 / 64) << "a test that cannot fail";
}

TEST(GridTransform, TheUniformTablesErrorIsThePapers) {
    // E_max = (m - 1 - ln m) / ln(1 + s) with r = 1 + (far/near - 1) / N, m = ln r / (r - 1), in
    // the first interval; besides it the words' rounding, 2^-9, and that of z, 2^-7; and a scale of
    // 20 bits, which makes intervals up to 2^-19 wider.
    struct Row {
        double lines, near, far, fov;
    };
    for (const Row& row : {Row{300, 1, 100, 90}, Row{1080, 1, 1e4, 90}, Row{2160, 1, 1e4, 90},
                           Row{1080, 0.1, 100, 60}}) {
        for (const int bits : {8, 10, 12, 14, 16}) {
            const host::GridCamera view = test::grid_camera(row.lines, row.fov, row.near, row.far);
            test::GridUnit unit(test::with_table(ZTableKind::Uniform, bits), view);
            const int first = static_cast<int>(std::ldexp((row.far - row.near) / (1 << bits), 16));
            const double error =
                worst_depth_error(unit, row.near, row.far, 100'000, std::min(first, 300'000));
            const double r = 1 + (row.far / row.near - 1) / (1 << bits);
            const double m = std::log(r) / (r - 1);
            const double formula =
                (m - 1 - std::log(m)) * host::steps_per_octave(view) / std::log(2.0);
            std::printf(
                "uniform, %g lines, %g degrees, w %g..%g, %5d intervals: %8.3f grid units, "
                "formula %8.3f; %zu words of 22 bits reloaded with every camera\n",
                row.lines, row.fov, row.near, row.far, 1 << bits, error, formula,
                unit.table_words());
            EXPECT_EQ(unit.table_words(), (std::size_t{1} << bits) + 1);
            EXPECT_LE(error, formula * 1.001 + 1.0 / 128 + 1.0 / 512 + 0.001);
            if (formula > 0.1) {
                EXPECT_GE(error, 0.9 * formula);
            }
        }
    }
}

TEST(GridTransform, DepthIsMonotoneOverAllMantissas) {
    // Every mantissa of 20 bits, with the leading one at bit 20 (no bits dropped), 10 (bits added)
    // and 30; and the borders of all octaves.
    for (const auto& [kind, bits] :
         {std::pair{ZTableKind::Uniform, 10}, std::pair{ZTableKind::Linear, 6},
          std::pair{ZTableKind::Quadratic, 3}}) {
        test::GridUnit unit(test::with_table(kind, bits),
                            test::grid_camera(2160, 90, 0.01, 20'000));
        unit.registers.w_min = 1;
        unit.configure();
        uint64_t falls = 0;
        for (const int exponent : {10, 20, 30}) {
            int32_t before = -(1 << 30);
            const uint64_t step = exponent > 20 ? uint64_t{1} << (exponent - 20) : 1;
            for (uint64_t w = uint64_t{1} << exponent; w < uint64_t{2} << exponent; w += step) {
                const int32_t z = unit.at(0, 0, static_cast<int32_t>(w)).position[2];
                falls += z < before;
                before = z;
            }
        }
        for (int exponent = 1; exponent < 31; ++exponent) {
            const auto w = static_cast<int32_t>(uint32_t{1} << exponent);
            falls += unit.at(0, 0, w).position[2] < unit.at(0, 0, w - 1).position[2];
        }
        EXPECT_EQ(falls, 0U) << "kind " << static_cast<int>(kind);
    }
}

}  // namespace
}  // namespace repousse
