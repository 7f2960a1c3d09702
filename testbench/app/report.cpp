#include "testbench/app/report.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace repousse::app {
namespace {

using Json = nlohmann::ordered_json;

Json profile_part(const Job& job) {
    Json entries;
    std::vector<std::string_view> keys;
    for (const ProfileEntry& entry : profile_entries()) {
        entries[std::string(entry.key)] = entry_text(job.profile, entry);
        keys.push_back(entry.key);
    }
    return {{"name", job.profile_name},
            {"hash", fmt::format("{:016x}", profile_hash(job.profile, keys))},
            {"entries", entries}};
}

Json map_part(const LoadedObject& loaded) {
    const host::HeightMap& map = loaded.map;
    Json part = {{"width_texels", map.width},
                 {"height_texels", map.height},
                 {"range", {map.range_low, map.range_high}},
                 {"wrap", map.wrap},
                 {"fallback", loaded.object->map.used_fallback}};
    if (map.has_elevation) part["elevation_m"] = {map.elevation_low_m, map.elevation_high_m};
    return part;
}

Json object_part(const LoadedObject& loaded, const ObjectResult& object) {
    const host::MeshDiagnosis& d = loaded.diagnosis;
    Json part = {{"name", loaded.object->name},
                 {"method", loaded.object->method},
                 {"base",
                  {{"vertices", d.vertices},
                   {"triangles", object.base_triangles},
                   {"boundary_edges", d.boundary_edges},
                   {"non_manifold_edges", d.non_manifold_edges}}},
                 {"map", map_part(loaded)},
                 {"generation_cap", object.cap},
                 {"triangles", object.surface.triangles.size()},
                 {"vertices", object.surface.positions.size()}};
    if (object.invariants) {
        part["invariants"] = {{"open_edges", object.invariants->open_edges},
                              {"flipped", object.invariants->flipped},
                              {"zero_area", object.invariants->zero_area}};
    }
    return part;
}

uint64_t busy_cycles(const SimResult& result, std::string_view unit) {
    for (const shell::UnitBusy& row : result.busy) {
        if (row.unit->name == unit) return row.cycles;
    }
    return 0;
}

Json units_part(const Job& job, Level level, const SimResult& result) {
    Json elaborated = Json::array();
    Json omitted = Json::array();
    for (const UnitReason& reason : explain_units(job)) {
        if (!reason.built) {
            omitted.push_back({{"unit", reason.unit}, {"why", reason.why}});
            continue;
        }
        Json counters = Json::object();
        for (const CounterRow& row : result.counters) {
            if (row.unit == reason.unit) counters[std::string(row.name)] = row.value;
        }
        Json part = {{"unit", reason.unit}, {"why", reason.why}, {"counters", counters}};
        if (level == Level::Lt) part["busy_cycles"] = busy_cycles(result, reason.unit);
        elaborated.push_back(part);
    }
    return {{"elaborated", elaborated}, {"omitted", omitted}};
}

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown";
}

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

}  // namespace

std::string report_json(const Job& job, Level level, const SimResult& result) {
    Json report = {{"schema", "repousse-report/1"},
                   {"scene", {{"file", job.scene.file}, {"title", job.scene.title}}},
                   {"level", level_name(level)},
                   {"profile", profile_part(job)}};
    Json objects = Json::array();
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        objects.push_back(object_part(job.objects[i], result.objects[i]));
    }
    report["objects"] = objects;
    report["units"] = units_part(job, level, result);
    report["table_bytes"] = result.table_bytes;
    if (level == Level::Lt) {
        report["time"] = {{"clock_period_ns", job.device.clock_period_ns},
                          {"contexts", job.device.contexts},
                          {"device_cycles", result.cycles},
                          {"simulated_ns", result.simulated_ns}};
    }
    report["notes"] = job.notes;
    return report.dump(2) + "\n";
}

std::string timing_json(const std::vector<Phase>& phases, const SimResult& result) {
    Json wall = Json::object();
    for (const Phase& phase : phases) wall[phase.name] = phase.seconds;
    const double rate = static_cast<double>(triangle_count(result)) / result.tessellation_s;
    const Json timing = {{"schema", "repousse-timing/1"},
                         {"wall_s", wall},
                         {"tessellation_s", result.tessellation_s},
                         {"triangles_per_s", rate},
                         {"machine",
                          {{"processor", processor()},
                           {"threads", std::thread::hardware_concurrency()},
                           {"compiler", __VERSION__}}}};
    return timing.dump(2) + "\n";
}

std::string summary(const Job& job, Level level, const SimResult& result) {
    std::string text = fmt::format("{} at level {}, profile {}\n", job.scene.title,
                                   level_name(level), job.profile_name);
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        const ObjectResult& object = result.objects[i];
        text += fmt::format("  {}: {} base triangles -> {} triangles, {} vertices (cap {})\n",
                            job.objects[i].object->name, object.base_triangles,
                            object.surface.triangles.size(), object.surface.positions.size(),
                            object.cap);
        if (object.invariants) {
            text += fmt::format("    {} open edges, {} flipped, {} without area\n",
                                object.invariants->open_edges, object.invariants->flipped,
                                object.invariants->zero_area);
        }
    }
    text += fmt::format(
        "  tests: {} edges; tc {}, vt {}, nt {}, sht {}; {} table reads\n",
        counter(result, "edge_iter", "items"), counter(result, "texcoord_test", "tests"),
        counter(result, "view_test", "tests"), counter(result, "normal_test", "tests"),
        counter(result, "height_test", "tests"), counter(result, "height_test", "reads"));
    std::string omitted;
    for (const UnitReason& reason : explain_units(job)) {
        if (!reason.built) omitted += (omitted.empty() ? "" : ", ") + std::string(reason.unit);
    }
    text += "  not built: " + (omitted.empty() ? std::string("nothing") : omitted) + "\n";
    if (level == Level::Lt) {
        const auto triangles = static_cast<double>(triangle_count(result));
        text += fmt::format("  device: {} cycles, {:.1f} a triangle, {:.3f} ms at {} MHz\n",
                            result.cycles, static_cast<double>(result.cycles) / triangles,
                            static_cast<double>(result.cycles) * job.device.clock_period_ns * 1e-6,
                            static_cast<int>(1000 / job.device.clock_period_ns));
        std::vector<shell::UnitBusy> busy = result.busy;
        std::sort(busy.begin(), busy.end(),
                  [](const auto& p, const auto& q) { return p.cycles > q.cycles; });
        text += "  busiest:";
        for (std::size_t i = 0; i < std::min<std::size_t>(3, busy.size()); ++i) {
            text += fmt::format(
                "{} {} {:.0f} %", i == 0 ? "" : ",", busy[i].unit->name,
                100 * static_cast<double>(busy[i].cycles) / static_cast<double>(result.cycles));
        }
        text += "\n";
    }
    for (const std::string& note : job.notes) text += "  note: " + note + "\n";
    return text;
}

Status verdict(const Job& job, const SimResult& result) {
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        const auto& invariants = result.objects[i].invariants;
        if (!invariants || invariants->open_edges == 0) continue;
        return Error{ErrorKind::Mismatch, "object \"" + job.objects[i].object->name + "\"",
                     fmt::format("{} open edges: the surface has cracks", invariants->open_edges),
                     "none", "at a texture seam, make the map periodic with wrap = true"};
    }
    return done();
}

}  // namespace repousse::app
