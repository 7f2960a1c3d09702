// The filter study: its bounds are bounds, its peaks are counted right, and docs/filter.md says
// what it finds, that is, each level of each map comes to 70 % of the average's volume or is
// proven not to.
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "testbench/host/files.h"
#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/map/variational_level.h"
#include "testbench/study/filter.h"

namespace repousse::study {
namespace {

const auto kQuiet = [](const std::string&) {};

host::HeightMap noise(int width, int height, std::uint64_t seed, bool wrap) {
    host::FbmSettings settings;
    settings.seed = seed;
    settings.wrap = wrap;
    host::HeightMap map = host::make_fbm_map(width, height, settings);
    map.wrap = wrap;
    return map;
}

TEST(VolumeBound, BracketsEveryLevelThatIsFound) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const host::HeightMap map = noise(61, 40, seed, seed % 2 == 0);
        for (int level = 1; level <= 4; ++level) {
            const VolumeBound bound = bound_volume(map, level, 0, 0.99, 4000);
            const host::VariationalLevel fit = host::variational_level(map, level);
            EXPECT_LE(bound.least, bound.found);
            EXPECT_LE(bound.least, fit.volume);
            EXPECT_GE(bound.least, 0.97 * bound.found) << seed << " level " << level;
            EXPECT_LE(fit.volume, 1.03 * bound.found) << seed << " level " << level;
        }
    }
}

TEST(VolumeBound, IsExactWhereTheOptimumIsKnown) {
    // One vertex: the best height is a median, and the volume the sum of distances from it.
    host::HeightMap map = host::make_constant_map(4, 1, 0);
    map.texels = {100, 200, 700, 1000};
    const VolumeBound bound = bound_volume(map, 2, 0, 0.9999, 20000);
    EXPECT_NEAR(bound.least, 1400, 1);
    EXPECT_NEAR(bound.found, 1400, 1);
    const VolumeBound none = bound_volume(host::make_constant_map(9, 9, 7), 1, 0, 0.99, 100);
    EXPECT_EQ(none.least, 0);
    EXPECT_EQ(none.found, 0);
}

TEST(FilterStudy, BoxMaximumKeepsAllPeaksAndASpikeBetweenCentresIsLost) {
    host::HeightMap map = host::make_constant_map(32, 32, 100);
    map.texels[8 * 32 + 8] = 50000;  // no block centre at levels 1 and 2
    const FilteredMap study = study_map(map, "spike", "made", kQuiet);
    ASSERT_EQ(study.levels.size(), 5u);
    for (const FilterLevelReport& level : study.levels) {
        EXPECT_EQ(level.peaks.maximum, 1);
        EXPECT_EQ(level.skyline.maximum, 1);
        EXPECT_LT(level.peaks.variational, 0.01);
        EXPECT_LE(level.ratio, 1);
    }
    EXPECT_NEAR(study.levels[0].peaks.unfiltered, 100.0 / 50000, 1e-12);
    EXPECT_NEAR(study.levels[0].peaks.average, (50000 + 3 * 100) / 4 / 50000.0, 1e-12);
}

TEST(FilterStudy, AConstantMapHasNothingToReport) {
    const FilteredMap study = study_map(host::make_constant_map(16, 16, 0), "flat", "made", kQuiet);
    for (const FilterLevelReport& level : study.levels) {
        EXPECT_EQ(level.ratio, 0);
        EXPECT_TRUE(level.curve.empty());
        EXPECT_EQ(level.peaks.average, 1);
    }
    FilterReport report;
    report.maps = {study};
    report.missing = {"other.npz"};
    EXPECT_NE(filter_markdown(report, "f.svg").find("Missing: `other.npz`"), std::string::npos);
    EXPECT_NE(filter_figure(report).find("</svg>"), std::string::npos);
}

/// Rows "| level | W x H | start | **ratio %** | steps | proven | ..." of a map's volume table.
struct DocumentRow {
    int level = 0;
    double ratio = 0;
    double proven = 0;  ///< per cent; 0 without a bound
};

std::vector<DocumentRow> document_rows(const std::string& text, const std::string& map) {
    std::vector<DocumentRow> rows;
    std::size_t at = text.find("### " + map + " (");
    for (int level = 1; level <= FilterReport::kLevels && at != std::string::npos; ++level) {
        at = text.find("\n| " + std::to_string(level) + " | ", at + 1);
        if (at == std::string::npos) break;
        DocumentRow row;
        row.level = level;
        std::sscanf(text.c_str() + at, "\n| %*d | %*d x %*d | %*f | **%lf %%** | %*d | %lf",
                    &row.ratio, &row.proven);
        rows.push_back(row);
    }
    return rows;
}

TEST(FilterDocument, EveryLevelKeepsThePromiseOrIsProvenNotTo) {
    const auto text = host::read_file("docs/filter.md");
    ASSERT_TRUE(text) << text.error().message();
    EXPECT_EQ(text->find("Missing"), std::string::npos);
    for (const char* map : {"Jacksboro", "Mannequin", "ETOPO5"}) {
        const auto rows = document_rows(*text, map);
        ASSERT_EQ(rows.size(), 5u) << map;
        for (const DocumentRow& row : rows) {
            EXPECT_GT(row.ratio, 0);
            EXPECT_TRUE(row.ratio <= 70 || row.proven >= 70) << map << " level " << row.level;
            EXPECT_LE(row.proven, row.ratio + 0.05);
        }
    }
}

TEST(FilterDocument, IsNotStale) {
    const std::string path = "inputs/jacksboro_fault_dem.npz";
    if (!host::is_file(path)) GTEST_SKIP() << "the elevation file is absent: scenes/fetch.sh";
    const auto text = host::read_file("docs/filter.md");
    const auto bytes = host::read_file(path);
    ASSERT_TRUE(text.ok() && bytes.ok());
    const auto grid = host::read_npz(*bytes, path);
    ASSERT_TRUE(grid.ok());
    const host::HeightMap map = host::quantise(*grid);
    for (const DocumentRow& row : document_rows(*text, "Jacksboro")) {
        const host::VariationalLevel fit = host::variational_level(map, row.level);
        EXPECT_NEAR(100 * fit.volume / fit.volumes.front(), row.ratio, 0.06) << row.level;
    }
}

}  // namespace
}  // namespace repousse::study
