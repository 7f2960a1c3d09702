#include "testbench/app/report.h"

#include <fstream>
#include <thread>
#include <utility>
#include <variant>

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
    if (const auto& levels = loaded.object->map.levels) {
        const bool maximum = loaded.object->map.filter == HeightFilter::Maximum;
        part["levels"] = {{"kind", host::level_filter_name(*levels)},
                          {"filter", maximum ? "maximum" : "average"},
                          {"finer", loaded.object->map.finer_levels},
                          {"last", host::level_count(map.width, map.height)}};
    }
    if (map.has_elevation) part["elevation_m"] = {map.elevation_low_m, map.elevation_high_m};
    if (map.filled_texels > 0) part["filled_texels"] = map.filled_texels;
    return part;
}

// What the invariants say, by method; null if the check was not wanted.
Json invariants_part(const ObjectResult& object) {
    if (const auto* leaves = std::get_if<reference::LeafReport>(&object.invariants)) {
        return {{"open_edges", leaves->open_edges},
                {"flipped", leaves->flipped},
                {"zero_area", leaves->zero_area}};
    }
    if (const auto* sweep = std::get_if<host::SweepInvariants>(&object.invariants)) {
        return {{"open_edges", sweep->open_edges},
                {"cracked", sweep->cracked},
                {"seam_cracked", sweep->seam_cracked},
                {"degenerate", sweep->degenerate},
                {"uncovered", sweep->uncovered}};
    }
    return nullptr;
}

Json object_part(const LoadedObject& loaded, const ObjectResult& object) {
    const host::MeshDiagnosis& d = loaded.diagnosis;
    const host::Method method = loaded.object->method;
    Json part = {{"name", loaded.object->name},
                 {"method", host::method_name(method)},
                 {"base",
                  {{"vertices", d.vertices},
                   {"triangles", object.base_triangles},
                   {"boundary_edges", d.boundary_edges},
                   {"non_manifold_edges", d.non_manifold_edges}}}};
    if (method != host::Method::Direct) part["map"] = map_part(loaded);
    if (method == host::Method::Adaptive) part["generation_cap"] = object.cap;
    if (method == host::Method::Sweep) {
        part["coarseness_px"] = loaded.object->sweep.coarseness_px;
        part["guard_grid"] = loaded.object->sweep.guard_grid;
    }
    part["triangles"] = object.surface.triangles.size();
    part["vertices"] = object.surface.positions.size();
    if (Json invariants = invariants_part(object); !invariants.is_null()) {
        part["invariants"] = std::move(invariants);
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

Status verdict(const Job& job, const SimResult& result) {
    for (std::size_t i = 0; i < result.objects.size(); ++i) {
        const auto& invariants = result.objects[i].invariants;
        const std::string where = "object \"" + job.objects[i].object->name + "\"";
        if (const auto* leaves = std::get_if<reference::LeafReport>(&invariants)) {
            if (leaves->open_edges == 0) continue;
            return Error{ErrorKind::Mismatch, where,
                         fmt::format("{} open edges: the surface has cracks", leaves->open_edges),
                         "none", "at a texture seam, make the map periodic with wrap = true"};
        }
        const auto* sweep = std::get_if<host::SweepInvariants>(&invariants);
        if (sweep == nullptr || sweep->hold()) continue;
        return Error{
            ErrorKind::Mismatch, where,
            fmt::format("{} open edges, {} vertices in more than one place, {} fine "
                        "triangles without area, {} base triangles not covered once",
                        sweep->open_edges, sweep->cracked, sweep->degenerate, sweep->uncovered),
            "none", "choose exact adders: adder_kind = 2 in the profile"};
    }
    return done();
}

}  // namespace repousse::app
