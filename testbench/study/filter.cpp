#include "testbench/study/filter.h"

#include <algorithm>
#include <ctime>

#include "testbench/host/files.h"
#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/netcdf_reader.h"
#include "testbench/host/map/npz_reader.h"
#include "testbench/host/map/range_map.h"
#include "testbench/host/map/variational_level.h"
#include "testbench/host/mesh/mesh_reader.h"

namespace repousse::study {
namespace {

using host::HeightMap;
using Progress = std::function<void(const std::string&)>;

/// The texel at the centre of each block: what a coarse grid reads of a map without levels.
HeightMap centres(const HeightMap& map, int level) {
    HeightMap result = host::average_level(map, level);
    const int half = 1 << (level - 1);
    for (int j = 0; j < result.height; ++j) {
        for (int i = 0; i < result.width; ++i) {
            const int x = std::min((i << level) + half, map.width - 1);
            const int y = std::min((j << level) + half, map.height - 1);
            result.texels[static_cast<std::size_t>(j * result.width + i)] = map.at(x, y);
        }
    }
    return result;
}

/// Calls `block(i, j)` for a block and those around it that are inside the map.
template <class Block>
void around(const HeightMap& level, int i, int j, Block block) {
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, level.height - 1); ++b) {
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, level.width - 1); ++a) block(a, b);
    }
}

/// `maxima` are the blocks' highest texels.
double peaks_kept(const HeightMap& maxima, const HeightMap& level) {
    double kept = 0;
    int peaks = 0;
    for (int j = 0; j < maxima.height; ++j) {
        for (int i = 0; i < maxima.width; ++i) {
            const int top = maxima.at(i, j);
            bool is_peak = top > 0;
            int highest = 0;
            around(maxima, i, j, [&](int a, int b) {
                is_peak = is_peak && ((a == i && b == j) || maxima.at(a, b) < top);
                highest = std::max(highest, static_cast<int>(level.at(a, b)));
            });
            if (!is_peak) continue;
            kept += static_cast<double>(highest) / top;
            ++peaks;
        }
    }
    return peaks > 0 ? kept / peaks : 1.0;
}

double skyline_kept(const HeightMap& maxima, const HeightMap& level) {
    double kept = 0;
    int columns = 0;
    for (int i = 0; i < maxima.width; ++i) {
        int top = 0;
        int highest = 0;
        for (int j = 0; j < maxima.height; ++j) {
            top = std::max(top, static_cast<int>(maxima.at(i, j)));
            highest = std::max(highest, static_cast<int>(level.at(i, j)));
        }
        if (top == 0) continue;
        kept += static_cast<double>(highest) / top;
        ++columns;
    }
    return columns > 0 ? kept / columns : 1.0;
}

FilterLevelReport study_level(const HeightMap& map, int level, const std::string& name,
                              const Progress& progress) {
    progress(name + ", level " + std::to_string(level));
    const host::VariationalLevel fit = host::variational_level(map, level);
    const HeightMap average = host::average_level(map, level);
    const HeightMap maximum = host::maximum_level(map, level);
    const HeightMap unfiltered = centres(map, level);
    FilterLevelReport report;
    report.level = level;
    report.width = fit.map.width;
    report.height = fit.map.height;
    const double start = fit.volumes.front();
    report.start_lsb = start / static_cast<double>(map.texels.size());
    if (start > 0) {
        for (const double volume : fit.volumes) report.curve.push_back(volume / start);
        report.ratio = fit.volume / start;
        report.maximum_ratio = host::difference_volume(map, maximum, level) / start;
    }
    report.peaks = {peaks_kept(maximum, unfiltered), peaks_kept(maximum, average),
                    peaks_kept(maximum, fit.map), peaks_kept(maximum, maximum)};
    report.skyline = {skyline_kept(maximum, unfiltered), skyline_kept(maximum, average),
                      skyline_kept(maximum, fit.map), skyline_kept(maximum, maximum)};
    if (report.ratio > FilterReport::kPromised) {
        progress(name + ", level " + std::to_string(level) + ": bound of the optimum");
        // Of a large map, no more than that the optimum is above 70 %; else also how far above.
        const double near = map.texels.size() > 4'000'000 ? 0.0 : 0.99;
        report.bound = bound_volume(map, level, FilterReport::kPromised * start, near, 4000);
        report.least_ratio = report.bound->least / start;
        report.found_ratio = report.bound->found / start;
    }
    return report;
}

}  // namespace

FilteredMap study_map(const HeightMap& map, const std::string& name, const std::string& source,
                      const Progress& progress) {
    FilteredMap result{name, source, map.width, map.height, map.wrap, {}, 0};
    const int levels = std::min(FilterReport::kLevels, host::level_count(map.width, map.height));
    for (int level = 1; level <= levels; ++level) {
        result.levels.push_back(study_level(map, level, name, progress));
    }
    progress(name + ", time");
    const std::clock_t begin = std::clock();
    host::filter_levels(map, host::LevelFilter::Variational);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result.seconds_per_megatexel = seconds * 1e6 / static_cast<double>(map.texels.size());
    return result;
}

Result<FilterReport> filter_study(const std::string& folder, const Progress& progress) {
    FilterReport report;
    const auto present = [&](const std::string& file) {
        if (host::is_file(folder + "/" + file)) return true;
        report.missing.push_back(file);
        return false;
    };
    // All clamp: a map that wraps does so in v too, and no map here is periodic in v.
    const auto read = [&](const std::string& file, auto reader) -> Result<HeightMap> {
        const auto bytes = host::read_file(folder + "/" + file);
        if (!bytes) return bytes.error();
        const auto grid = reader(*bytes, folder + "/" + file);
        if (!grid) return grid.error();
        return host::quantise(*grid);
    };
    if (const std::string file = "jacksboro_fault_dem.npz"; present(file)) {
        const auto map = read(file, host::read_npz);
        if (!map) return map.error();
        report.maps.push_back(study_map(*map, "Jacksboro", file, progress));
    }
    if (const std::string file = "mannequin-devil.off"; present(file)) {
        const auto mesh = host::read_mesh(folder + "/" + file);
        if (!mesh) return mesh.error();
        const host::RangeAxis axis{{0, 0, -20}, {0, 0, 20}, {0, 1, 0}};
        const HeightMap map = host::quantise(host::range_map(*mesh, axis, 512, 456));
        report.maps.push_back(study_map(map, "Mannequin", file + ", range map", progress));
    }
    if (const std::string file = "etopo5.cdf"; present(file)) {
        const auto map = read(file, host::read_netcdf);
        if (!map) return map.error();
        report.maps.push_back(study_map(*map, "ETOPO5", file, progress));
    }
    return report;
}

}  // namespace repousse::study
