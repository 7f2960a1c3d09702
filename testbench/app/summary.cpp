// What a run gave, for the terminal.

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "testbench/app/report.h"

namespace repousse::app {
namespace {

uint64_t counter(const SimResult& result, std::string_view unit, std::string_view name) {
    for (const CounterRow& row : result.counters) {
        if (row.unit == unit && row.name == name) return row.value;
    }
    return 0;
}

std::size_t triangle_count(const SimResult& result) {
    std::size_t triangles = 0;
    for (const ObjectResult& object : result.objects) triangles += object.surface.triangles.size();
    return triangles;
}

std::string object_lines(const host::Object& object, const ObjectResult& result) {
    std::string how;
    if (object.method == host::Method::Adaptive) how = fmt::format(" (cap {})", result.cap);
    if (object.method == host::Method::Sweep) {
        how = fmt::format(" (grid of {} px)", object.sweep.coarseness_px);
    }
    std::string text =
        fmt::format("  {}: {} base triangles -> {} triangles, {} vertices{}\n", object.name,
                    result.base_triangles, result.surface.triangles.size(),
                    result.surface.positions.size(), how);
    if (const auto* leaves = std::get_if<reference::LeafReport>(&result.invariants)) {
        text += fmt::format("    {} open edges, {} flipped, {} without area\n", leaves->open_edges,
                            leaves->flipped, leaves->zero_area);
    }
    if (const auto* sweep = std::get_if<host::SweepInvariants>(&result.invariants)) {
        text += fmt::format("    {} open edges, {} cracked vertices, {} without area\n",
                            sweep->open_edges, sweep->cracked, sweep->degenerate);
        if (sweep->seam_cracked != 0) {
            text += fmt::format("    {} vertices on texture seams lie apart from their copies\n",
                                sweep->seam_cracked);
        }
    }
    return text;
}

double ratio(uint64_t a, uint64_t b) {
    return static_cast<double>(a) / static_cast<double>(std::max<uint64_t>(b, 1));
}

std::string work_lines(const Job& job, const SimResult& result) {
    std::string text;
    if (job.needed.adaptive) {
        text += fmt::format(
            "  tests: {} edges; tc {}, vt {}, nt {}, sht {}; {} table reads\n",
            counter(result, "edge_iter", "items"), counter(result, "texcoord_test", "tests"),
            counter(result, "view_test", "tests"), counter(result, "normal_test", "tests"),
            counter(result, "height_test", "tests"), counter(result, "height_test", "reads"));
    }
    if (const uint64_t triangles = counter(result, "sweep_line", "triangles"); triangles != 0) {
        text += fmt::format(
            "  sweep: {} of {} base triangles, {} outside the view, {} corners clamped; a fine "
            "triangle takes {:.2f} additions, {:.2f} commands, {:.2f} displaced vertices\n",
            counter(result, "sweep_line", "items"), counter(result, "controller", "items"),
            counter(result, "view_clip", "rejected"), counter(result, "triangle_setup", "clamped"),
            ratio(counter(result, "sweep_line", "additions"), triangles),
            ratio(counter(result, "sweep_line", "commands"), triangles),
            ratio(counter(result, "sweep_line", "displaced"), triangles));
    }
    return text;
}

std::string device_lines(const Job& job, const SimResult& result) {
    std::string text =
        fmt::format("  device: {} cycles, {:.1f} a triangle, {:.3f} ms at {} MHz\n", result.cycles,
                    ratio(result.cycles, triangle_count(result)),
                    static_cast<double>(result.cycles) * job.device.clock_period_ns * 1e-6,
                    static_cast<int>(1000 / job.device.clock_period_ns));
    std::vector<shell::UnitBusy> busy = result.busy;
    std::sort(busy.begin(), busy.end(),
              [](const auto& p, const auto& q) { return p.cycles > q.cycles; });
    text += "  busiest:";
    for (std::size_t i = 0; i < std::min<std::size_t>(3, busy.size()); ++i) {
        text += fmt::format("{} {} {:.0f} %", i == 0 ? "" : ",", busy[i].unit->name,
                            100 * ratio(busy[i].cycles, result.cycles));
    }
    return text + "\n";
}

}  // namespace

std::string summary(const Job& job, Level level, const SimResult& result) {
    std::string text = fmt::format("{} at level {}, profile {}\n", job.scene.title,
                                   level_name(level), job.profile_name);
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        text += object_lines(*job.objects[i].object, result.objects[i]);
    }
    text += work_lines(job, result);
    std::string omitted;
    for (const UnitReason& reason : explain_units(job)) {
        if (!reason.built) omitted += (omitted.empty() ? "" : ", ") + std::string(reason.unit);
    }
    text += "  not built: " + (omitted.empty() ? std::string("nothing") : omitted) + "\n";
    if (level == Level::Lt) text += device_lines(job, result);
    for (const std::string& note : job.notes) text += "  note: " + note + "\n";
    return text;
}

}  // namespace repousse::app
