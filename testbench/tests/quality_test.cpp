// The quality study's figures that others rely on: the uniform grid, the best adaptive mesh, and
// docs/quality.md still says what the study finds.

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "testbench/host/files.h"
#include "testbench/study/quality.h"

namespace repousse::study {
namespace {

using R = QualityReport;

class QualityStudy : public testing::Test {
protected:
    static constexpr const char* kFile = "inputs/jacksboro_fault_dem.npz";

    void SetUp() override {
        if (!host::is_file(kFile)) {
            GTEST_SKIP() << "the elevation file is absent: scenes/fetch.sh gets it";
        }
        auto field = HeightField::open(kFile, R::kColumn, R::kRow, R::kSize, R::kSpacing_m);
        ASSERT_TRUE(field) << field.error().message();
        field_ = *field;
    }
    Quality measure(const Setting& setting) const {
        const auto found = field_->measure(setting);
        EXPECT_TRUE(found) << found.error().message();
        return found ? *found : Quality{};
    }
    std::optional<HeightField> field_;
};

Setting grid(int quads) {
    Setting setting;
    setting.quads = quads;
    return setting;
}

TEST_F(QualityStudy, UniformGridIsTheIndependentlyMeasuredOne) {
    const Quality uniform = measure(grid(50));
    EXPECT_EQ(uniform.triangles, 5000u);
    EXPECT_NEAR(uniform.rms_m, 22.93, 0.005);
    // Every sample a vertex: what is left is quantisation to 16 bits of 840 m, and D's rounding.
    EXPECT_LT(measure(grid(256)).max_m, 0.5 * 840 / 65535 + 1e-4);
}

TEST_F(QualityStudy, AdaptiveBeatsUniformFromAFineBaseGridOnly) {
    Setting fine = grid(32);
    fine.cap = 1;
    fine.average_lsb = 1676;
    fine.normal = 0.527;
    const Quality best = measure(fine);
    EXPECT_LE(best.triangles, 5010u);
    EXPECT_LE(best.rms_m, 19.0);
    fine.ref = true;
    EXPECT_NEAR(measure(fine).rms_m, best.rms_m, 0.1);
    Setting coarse = grid(3);
    coarse.average_lsb = 2150;
    const Quality natural = measure(coarse);
    EXPECT_NEAR(double(natural.triangles), 5000, 100);
    EXPECT_GT(natural.rms_m, 40);
}

TEST_F(QualityStudy, SizeClassesAddUp) {
    Setting setting = grid(8);
    setting.average_lsb = 3000;
    const auto classes = field_->by_size(setting);
    ASSERT_TRUE(classes);
    double triangles = 0, area = 0, error = 0;
    for (const SizeClass& c : *classes) {
        triangles += c.triangle_share;
        area += c.area_share;
        error += c.error_share;
    }
    EXPECT_NEAR(triangles, 1, 1e-12);
    EXPECT_NEAR(area, 1, 1e-12);
    EXPECT_NEAR(error, 1, 1e-9);
}

TEST_F(QualityStudy, TheDocumentIsNotStale) {
    const auto text = host::read_file("docs/quality.md");
    ASSERT_TRUE(text) << text.error().message();
    const std::size_t at = text->find("| best adaptive |");
    ASSERT_NE(at, std::string::npos);
    int base = 0, cap = 0, triangles = 0;
    double average = 0, normal = 0, rms = 0, max = 0;
    ASSERT_EQ(
        std::sscanf(text->c_str() + at,
                    "| best adaptive | %d x %*d | %d | AVG %lf LSB, normal %lf | %d | %lf | %lf",
                    &base, &cap, &average, &normal, &triangles, &rms, &max),
        7);
    Setting setting = grid(base);
    setting.cap = cap;
    setting.average_lsb = average;
    setting.normal = normal;
    const Quality found = measure(setting);
    // The document's thresholds are rounded.
    EXPECT_NEAR(double(found.triangles), triangles, 10);
    EXPECT_NEAR(found.rms_m, rms, 0.03);
    EXPECT_LE(triangles, 5000);
    EXPECT_LE(rms, 19.7);
}

TEST(QualityStudyErrors, AMissingFileAndAPartOutsideAreErrors) {
    EXPECT_FALSE(HeightField::open("no/such.npz", 0, 0, 10, 1));
    if (!host::is_file("inputs/jacksboro_fault_dem.npz")) GTEST_SKIP() << "no elevation file";
    EXPECT_FALSE(HeightField::open("inputs/jacksboro_fault_dem.npz", 300, 0, 257, 1));
}

}  // namespace
}  // namespace repousse::study
