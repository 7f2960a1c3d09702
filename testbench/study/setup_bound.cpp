#include "testbench/study/setup_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"

namespace repousse::study {
namespace {

/// The sweep's cycles of base triangles of one size, one after the other.
std::vector<uint64_t> sweep_lengths(const SetupBoundSettings& settings, int size,
                                    uint64_t& fine_triangles) {
    std::mt19937_64 random(settings.seed);
    TriangleSetup setup({AdderKind::Exact, 0, 0});  // topology needs no data
    SweepLine sweep({settings.column_depth, {}});
    SweepTriangle triangle;
    SweepStep step;
    std::vector<uint64_t> lengths;
    while (sweep.counters().triangles < settings.fine_triangles) {
        std::array<SweepCorner, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i].id = static_cast<uint32_t>(i);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                corners[i].slot[axis] =
                    static_cast<int32_t>(random() % static_cast<unsigned>(size + 1));
            }
        }
        setup(corners, triangle);
        sweep.load(triangle);
        uint64_t length = 0;
        while (sweep.step(step)) ++length;
        lengths.push_back(length);
    }
    fine_triangles = sweep.counters().triangles;
    return lengths;
}

/// The cycle in which the last step has left. Quotients of triangle i are worked out while triangle
/// i - 1 waits to be taken, which it is as soon as a buffer of the sweep line is free.
uint64_t run_time(const std::vector<uint64_t>& lengths, uint64_t setup) {
    uint64_t done = 0, taken = 0;     // of the setup with a triangle, and of the sweep line to it
    uint64_t started = 0, ended = 0;  // of the sweep
    for (const uint64_t length : lengths) {
        done = std::max(done + setup, taken);
        taken = std::max(done, started);  // the buffer of triangle i - 2, when i - 1 has started
        started = std::max(taken, ended);
        ended = started + length;
    }
    return ended;
}

}  // namespace

std::vector<SetupBoundRow> setup_bound(const SetupBoundSettings& settings) {
    std::vector<SetupBoundRow> rows;
    for (const int size : settings.sizes) {
        SetupBoundRow row;
        row.size = size;
        const std::vector<uint64_t> lengths = sweep_lengths(settings, size, row.fine_triangles);
        row.base_triangles = lengths.size();
        uint64_t sum = 0;
        for (const uint64_t length : lengths) sum += length;
        const auto base = static_cast<double>(row.base_triangles);
        const auto fine = static_cast<double>(row.fine_triangles);
        row.sweep = static_cast<double>(sum) / base;
        row.sweep_cycles = static_cast<double>(sum) / fine;
        for (const int dividers : settings.dividers) {
            row.dividers = dividers;
            row.setup = setup_cycles(settings.components, dividers);
            const auto setup = static_cast<uint64_t>(row.setup);
            const auto bound = std::count_if(lengths.begin(), lengths.end(),
                                             [&](uint64_t length) { return length < setup; });
            const uint64_t time = run_time(lengths, setup);
            row.bound_triangles = static_cast<double>(bound) / base;
            row.bound_time = static_cast<double>(time - sum) / static_cast<double>(time);
            row.cycles = static_cast<double>(time) / fine;
            rows.push_back(row);
        }
    }
    return rows;
}

std::string setup_bound_table(const std::vector<SetupBoundRow>& rows) {
    std::string text =
        "| px | dividers | setup, cycles | sweep, cycles | base triangles bound by setup "
        "| time bound by setup | cycles a fine triangle | sweep alone |\n"
        "|--:|--:|--:|--:|--:|--:|--:|--:|\n";
    for (const SetupBoundRow& row : rows) {
        text += fmt::format("| {} | {} | {} | {:.1f} | {:.1f} % | {:.1f} % | {:.3f} | {:.3f} |\n",
                            row.size, row.dividers, row.setup, row.sweep, 100 * row.bound_triangles,
                            100 * row.bound_time, row.cycles, row.sweep_cycles);
    }
    return text;
}

}  // namespace repousse::study
