#include "testbench/study/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace repousse::study {
namespace {

constexpr std::array kAllTests = {Tests::Average, Tests::Sum, Tests::Normal, Tests::AverageNormal,
                                  Tests::SumNormal};
constexpr std::array kBases = {3, 4, 8, 16, 24, 32, 40, 48};

using Threshold = std::optional<double> Setting::*;

// Searches settings for the least error within a budget. The first error of a run is kept; what is
// found after it means nothing.
class Search {
public:
    Search(const HeightField& field, std::size_t budget) : field_(field), budget_(budget) {}

    /// Over one threshold: the triangle count falls as the threshold rises (all but strictly), so
    /// bisection finds where the budget is just met; the error does not, so a few larger ones are
    /// tried as well.
    Quality over(Setting setting, Threshold threshold) {
        const double ends[] = {threshold == &Setting::normal ? 1e-3 : 1.0,
                               threshold == &Setting::normal ? 2.0
                               : threshold == &Setting::sum  ? 1e9
                                                             : 65535.0};
        double low = std::log(ends[0]);
        double high = std::log(ends[1]);
        Quality best;
        best.rms_m = std::numeric_limits<double>::infinity();
        const auto try_at = [&](double logarithm) {
            setting.*threshold = std::exp(logarithm);
            const Quality found = measure(setting);
            const bool fits = found.triangles <= budget_;
            if (fits && found.rms_m < best.rms_m) best = found;
            return fits;
        };
        while (high - low > 4e-3 && ok()) {
            const double middle = (low + high) / 2;
            (try_at(middle) ? high : low) = middle;
        }
        const double edge = high;
        for (int i = 1; i <= 6 && ok(); ++i) try_at(std::min(edge + 0.03 * i, std::log(ends[1])));
        return best;
    }

    /// Over both thresholds of a pair: multiples of the normal threshold that would do alone.
    Quality over_pair(Setting setting, Threshold height, double normal_alone) {
        Quality best;
        best.rms_m = std::numeric_limits<double>::infinity();
        for (const double factor : {1.2, 1.5, 2.0, 2.5}) {
            setting.normal = std::min(2.0, factor * normal_alone);
            const Quality found = over(setting, height);
            if (found.rms_m < best.rms_m) best = found;
        }
        return best;
    }

    Quality measure(const Setting& setting) {
        const auto found = field_.measure(setting, budget_);
        if (found) return *found;
        if (ok()) status_ = found.error();
        return Quality{setting, ~std::size_t{0}, 0, 0};
    }

    bool ok() const { return status_.ok(); }
    const Status& status() const { return status_; }

private:
    const HeightField& field_;
    std::size_t budget_;
    Status status_ = done();
};

int natural_cap(int quads) {
    return static_cast<int>(std::ceil(std::log2((QualityReport::kSize - 1.0) / quads)));
}

BaseGrid search_base(Search& search, int quads) {
    BaseGrid base;
    base.quads = quads;
    base.natural_cap = natural_cap(quads);
    for (const Tests tests : kAllTests) {
        BestOf best;
        best.tests = tests;
        best.any.rms_m = std::numeric_limits<double>::infinity();
        for (int cap = 1; cap <= base.natural_cap; ++cap) {
            // A cap that cannot reach the budget even when everything is split has nothing to
            // choose; between 3 and the natural cap nothing new happens.
            const double most = 2.0 * quads * quads * std::exp2(2 * cap);
            if (cap != base.natural_cap && (most < QualityReport::kBudget || cap > 3)) continue;
            Setting setting;
            setting.quads = quads;
            setting.cap = cap;
            Quality found;
            if (tests == Tests::Average) found = search.over(setting, &Setting::average_lsb);
            if (tests == Tests::Sum) found = search.over(setting, &Setting::sum);
            if (tests == Tests::Normal) found = search.over(setting, &Setting::normal);
            if (tests >= Tests::AverageNormal) {
                const double alone = *search.over(setting, &Setting::normal).setting.normal;
                found = search.over_pair(
                    setting, tests == Tests::SumNormal ? &Setting::sum : &Setting::average_lsb,
                    alone);
            }
            if (cap == base.natural_cap) best.natural = found;
            if (found.rms_m < best.any.rms_m) best.any = found;
        }
        base.best.push_back(best);
    }
    return base;
}

// The best setting found so far, with both thresholds tried on a finer raster.
Quality refine(Search& search, Quality best) {
    const Setting start = best.setting;
    const Threshold height = start.sum ? &Setting::sum : &Setting::average_lsb;
    if (!start.normal || !(start.*height)) return best;
    for (int i = -12; i <= 12 && search.ok(); ++i) {
        Setting setting = start;
        setting.normal = std::min(2.0, *start.normal * std::exp(0.025 * i));
        const Quality found = search.over(setting, height);
        if (found.rms_m < best.rms_m) best = found;
    }
    return best;
}

CurvePoint compare(const HeightField& field, std::size_t budget, Status& status) {
    Search search(field, budget);
    CurvePoint point;
    point.budget = budget;
    Setting grid;
    grid.quads = static_cast<int>(std::sqrt(static_cast<double>(budget) / 2.0));
    point.uniform = search.measure(grid);
    point.adaptive.rms_m = std::numeric_limits<double>::infinity();
    for (const int quads : {8, 16, 32, 64}) {
        for (int cap = 1; cap <= 3; ++cap) {
            const auto base = static_cast<std::size_t>(2 * quads * quads);
            if (base >= budget || base << (2 * cap) < budget) continue;
            Setting setting;
            setting.quads = quads;
            setting.cap = cap;
            const Quality found = search.over(setting, &Setting::average_lsb);
            if (found.rms_m < point.adaptive.rms_m) point.adaptive = found;
        }
    }
    if (!search.ok()) status = search.status();
    return point;
}

}  // namespace

Result<QualityReport> quality_study(const std::string& npz_path,
                                    const std::function<void(const std::string&)>& progress) {
    using R = QualityReport;
    const auto field = HeightField::open(npz_path, R::kColumn, R::kRow, R::kSize, R::kSpacing_m);
    if (!field) return field.error();
    QualityReport report;
    Search search(*field, R::kBudget);
    Setting uniform;
    uniform.quads = 50;
    report.uniform = search.measure(uniform);
    report.best.rms_m = std::numeric_limits<double>::infinity();
    for (const int quads : kBases) {
        progress("base grid " + std::to_string(quads) + " x " + std::to_string(quads));
        report.bases.push_back(search_base(search, quads));
        if (!search.ok()) return search.status().error();
        for (const BestOf& best : report.bases.back().best) {
            if (best.any.rms_m < report.best.rms_m) report.best = best.any;
        }
    }
    progress("refining the best");
    report.best = refine(search, report.best);
    Setting ref = report.best.setting;
    ref.ref = true;
    const auto at_ref = field->measure(ref);
    if (!at_ref) return at_ref.error();
    report.best_ref = *at_ref;
    report.coarse = report.bases.front().best.front().natural;
    const auto best_sizes = field->by_size(report.best.setting);
    const auto coarse_sizes = field->by_size(report.coarse.setting);
    if (!best_sizes) return best_sizes.error();
    if (!coarse_sizes) return coarse_sizes.error();
    report.best_sizes = *best_sizes;
    report.coarse_sizes = *coarse_sizes;
    Status status = search.status();
    for (const std::size_t budget : {500, 1000, 2000, 5000, 10000, 20000}) {
        progress("at most " + std::to_string(budget) + " triangles");
        report.curve.push_back(compare(*field, budget, status));
        if (!status) return status.error();
    }
    return report;
}

}  // namespace repousse::study
