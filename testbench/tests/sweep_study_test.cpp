// The sweep study: its bounds, and docs/sweep.md still says what it finds.

#include <gtest/gtest.h>

#include "testbench/host/files.h"
#include "testbench/study/sweep.h"

namespace repousse::study {
namespace {

constexpr uint64_t kSeed = 1;  // the document's

bool document_has(const std::string& row) {
    const auto text = host::read_file("docs/sweep.md");
    EXPECT_TRUE(text) << text.error().message();
    return text && text->find("\n" + row) != std::string::npos;
}

// Promised work by size of triangle; 9: nothing promised.
TEST(SweepStudy, WorkBySize) {
    struct Bounds {
        int size_px;
        double additions, commands, sent, displaced, one_lane, two_lanes;
    };
    for (const Bounds& most :
         {Bounds{8, 9, 9, 9, 9, 9, 0.70}, Bounds{16, 9, 9, 1.05, 9, 9, 0.62},
          Bounds{64, 9, 1.25, 1.005, 0.58, 1.15, 0.56}, Bounds{256, 2.1, 1.07, 9, 0.53, 9, 0.52}}) {
        const SweepSizeRow row = sweep_size_row(most.size_px, kSeed);
        EXPECT_LE(row.additions_per_quad, most.additions) << most.size_px;
        EXPECT_LE(row.commands, most.commands) << most.size_px;
        EXPECT_LE(row.sent, most.sent) << most.size_px;
        EXPECT_LE(row.displaced, most.displaced) << most.size_px;
        EXPECT_LE(row.additions_one, most.one_lane) << most.size_px;
        EXPECT_LE(row.steps_two, most.two_lanes) << most.size_px;
        EXPECT_TRUE(document_has(markdown_row(row))) << markdown_row(row);
    }
}

TEST(SweepStudy, SetupBound) { EXPECT_TRUE(document_has(setup_bound_table(setup_rows(kSeed)))); }

TEST(SweepStudy, DepthTables) {
    for (const DepthRow& row :
         {depth_row(ZTableKind::Linear, 6, 1e4), depth_row(ZTableKind::Quadratic, 3, 1e4)}) {
        EXPECT_LE(row.error, 1.0 / 16);
        EXPECT_LE(row.table_bits, 2048);
        EXPECT_TRUE(document_has(markdown_row(row))) << markdown_row(row);
    }
}

TEST(SweepStudy, AddersExactAndPlain) {
    const AdderRow exact = adder_row(AdderKind::Exact, 0, 16, kSeed);
    EXPECT_LE(exact.edge_ulp, 0.5);
    EXPECT_EQ(exact.cracked_vertices + exact.cracked_inside + exact.open_edges, 0u);
    EXPECT_TRUE(document_has(markdown_row(exact))) << markdown_row(exact);
    const AdderRow plain = adder_row(AdderKind::Plain, 0, 16, kSeed);
    EXPECT_GT(plain.cracked_edges, plain.base_edges / 3);
    EXPECT_EQ(plain.open_edges, 0u);
    EXPECT_TRUE(document_has(markdown_row(plain))) << markdown_row(plain);
}

TEST(SweepStudy, TheSameSeedGivesTheSameRow) {
    EXPECT_EQ(markdown_row(sweep_size_row(32, 7)), markdown_row(sweep_size_row(32, 7)));
    EXPECT_NE(markdown_row(sweep_size_row(32, 7)), markdown_row(sweep_size_row(32, 8)));
}

}  // namespace
}  // namespace repousse::study
