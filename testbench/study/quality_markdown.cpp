#include <fmt/format.h>

#include "testbench/study/paragraph.h"
#include "testbench/study/quality.h"

namespace repousse::study {
namespace {

const char* name_of(Tests tests) {
    switch (tests) {
        case Tests::Average:
            return "AVG";
        case Tests::Sum:
            return "SUM";
        case Tests::Normal:
            return "normal";
        case Tests::AverageNormal:
            return "AVG + normal";
        case Tests::SumNormal:
            return "SUM + normal";
    }
    return "";
}

std::string thresholds(const Setting& setting) {
    std::string text;
    if (setting.average_lsb) text += fmt::format("AVG {:.0f} LSB", *setting.average_lsb);
    if (setting.sum) text += fmt::format("SUM {:.3g} LSB texel^2", *setting.sum);
    if (setting.normal) {
        text += fmt::format("{}normal {:.3f}", text.empty() ? "" : ", ", *setting.normal);
    }
    return text.empty() ? "uniform" : text;
}

std::string row(const std::string& what, const Quality& q) {
    const std::string cap = q.setting.cap ? std::to_string(*q.setting.cap) : "-";
    return fmt::format("| {} | {} x {} | {} | {} | {} | {:.2f} | {:.0f} |\n", what, q.setting.quads,
                       q.setting.quads, cap, thresholds(q.setting), q.triangles, q.rms_m, q.max_m);
}

std::string size_table(const QualityReport& report) {
    std::string text =
        "| triangles up to (samples) | 3 x 3, natural cap: triangles | area | squared error | "
        "best: triangles | area | squared error |\n|---|---|---|---|---|---|---|\n";
    const auto cells = [](const SizeClass& c) {
        return fmt::format(" {:.1f} % | {:.1f} % | {:.1f} % |", 100 * c.triangle_share,
                           100 * c.area_share, 100 * c.error_share);
    };
    for (std::size_t i = 0; i < report.coarse_sizes.size(); ++i) {
        const SizeClass& a = report.coarse_sizes[i];
        const SizeClass& b = report.best_sizes[i];
        if (a.triangle_share == 0 && b.triangle_share == 0) continue;
        text += fmt::format("| {:.0f} |{}{}\n", a.longest, cells(a), cells(b));
    }
    return text;
}

// The shares of the 3 x 3 grid's triangles that are at most, or more than, so many samples large.
SizeClass share(const std::vector<SizeClass>& classes, double limit, bool larger) {
    SizeClass sum;
    for (const SizeClass& c : classes) {
        if ((c.longest > limit) != larger) continue;
        sum.triangle_share += c.triangle_share;
        sum.area_share += c.area_share;
        sum.error_share += c.error_share;
    }
    return sum;
}

std::string reasons(const QualityReport& report) {
    const SizeClass fine = share(report.coarse_sizes, 8, false);
    const SizeClass rough = share(report.coarse_sizes, 32, true);
    return "## Why the base grid and the cap matter more than the thresholds\n\n" +
           paragraph(fmt::format(
               "The natural cap lets every edge be split down to one sample. From 3 x 3 quads, the "
               "{:.1f} % of the triangles that stay more than 32 samples large cover {:.0f} % of "
               "the terrain and hold {:.0f} % of the squared error, while the {:.0f} % that are at "
               "most eight samples large hold {:.1f} %.",
               100 * rough.triangle_share, 100 * rough.area_share, 100 * rough.error_share,
               100 * fine.triangle_share, 100 * fine.error_share)) +
           size_table(report) + "\n" +
           paragraph(
               "Two things make it so. A test looks at the middle and the two ends of an edge: a "
               "long edge across a valley is not split when those three places happen to agree, "
               "and nothing ever looks inside the triangle. And the difference of two averages "
               "says how rough the ground is, not how far the triangle is from it, so that rough "
               "ground is refined long after little is left to win there. A finer base grid "
               "leaves no long edge to misjudge; a low cap stops the waste.") +
           paragraph(
               "SUM's difference fades with the square of the edge's length, which does part of "
               "that by itself and makes it the better test on coarse base grids. On grids that "
               "do not divide the 256 intervals (24, 40, 48) it is the worse one: its boxes then "
               "have areas that are not 4 : 1, and level ground looks rough.");
}

}  // namespace

std::string quality_markdown(const QualityReport& report) {
    using R = QualityReport;
    std::string text = "# Quality: error against triangle count\n\n";
    text += paragraph(
        "Made by `repousse study quality -o docs/quality.md` (after `scenes/fetch.sh`); no figure "
        "in it is typed by hand.");
    text += paragraph(fmt::format(
        "The {} x {} samples of the Jacksboro elevations from column {}, row {}; bilinear reads; "
        "grid vertices at samples; samples taken as {:.0f} m apart. The error is the vertical "
        "distance of the mesh from the elevation at every sample, in metres. Level `lt`, default "
        "profile, square boxes. `cap` is the generation cap. AVG thresholds are in height LSB, "
        "1/65535 of the file's range of 840 m.",
        R::kSize, R::kSize, R::kColumn, R::kRow, R::kSpacing_m));
    text += fmt::format(
        "## At {} triangles\n\n"
        "| | base grid | cap | thresholds | triangles | rms (m) | max (m) |\n"
        "|---|---|---|---|---|---|---|\n",
        R::kBudget);
    text += row("uniform grid", report.uniform);
    text += row("best adaptive", report.best);
    text += row("the same at level `ref`", report.best_ref);
    text += row("natural cap, 3 x 3 quads", report.coarse);
    text +=
        "\n" +
        paragraph(fmt::format(
            "The best adaptive mesh has {:.0f} % less rms error than the uniform grid of as many "
            "triangles.",
            100 * (1 - report.best.rms_m / report.uniform.rms_m)));
    text += "## By base grid and test\n\n" +
            paragraph(fmt::format("The least rms error (m) within {} triangles: with the natural "
                                  "cap, and after the slash "
                                  "with the best cap (in brackets) of 1, 2, 3 and the natural one, "
                                  "as far as they reach that "
                                  "count.",
                                  R::kBudget));
    text += "| base grid |";
    for (const BestOf& best : report.bases.front().best) {
        text += fmt::format(" {} |", name_of(best.tests));
    }
    text += "\n|---|---|---|---|---|---|\n";
    for (const BaseGrid& base : report.bases) {
        text +=
            fmt::format("| {} x {}, natural cap {} |", base.quads, base.quads, base.natural_cap);
        for (const BestOf& best : base.best) {
            text += fmt::format(" {:.2f} / {:.2f} ({}) |", best.natural.rms_m, best.any.rms_m,
                                *best.any.setting.cap);
        }
        text += "\n";
    }
    text += "\n" + reasons(report);
    text += "## At other triangle counts\n\n" + paragraph(
                                                    "AVG alone, best of base grids 8, 16, 32, 64 "
                                                    "and caps 1 to 3, beside the largest uniform "
                                                    "grid within the same count.");
    text +=
        "| at most | uniform: triangles | rms (m) | adaptive: base, cap | triangles | rms (m) |\n"
        "|---|---|---|---|---|---|\n";
    for (const CurvePoint& p : report.curve) {
        text += fmt::format("| {} | {} | {:.2f} | {} x {}, {} | {} | {:.2f} |\n", p.budget,
                            p.uniform.triangles, p.uniform.rms_m, p.adaptive.setting.quads,
                            p.adaptive.setting.quads, p.adaptive.setting.cap.value_or(0),
                            p.adaptive.triangles, p.adaptive.rms_m);
    }
    return text;
}

}  // namespace repousse::study
