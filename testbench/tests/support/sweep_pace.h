#pragma once

#include <random>
#include <vector>

#include "datapath/sweep_line_ports.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/engine.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/tests/support/rtl_passage.h"
#include "testbench/tests/support/sweep_run.h"

namespace repousse::cosim {

/// Base triangles on their way through RTL, and what the datapath's sweep line counted for them.
struct FlatRun {
    SweepLineCounters counters;
    Passage passage;

    /// So many, or all cycles from the first beat to the last, per fine triangle.
    double each(uint64_t n) const { return double(n) / double(counters.triangles); }
    double cycles() const { return each(passage.depart.back() - passage.depart.front() + 1); }
    double beats() const { return each(passage.depart.size()); }
};

/// Sends `count` flat triangles with corners uniform in a square of `size` through sweep_line, or
/// through a top that takes the same items: offered at once, their beats taken at once.
inline FlatRun run_flat(EngineInstance& unit, const UnitModel& model, int size, int count) {
    const Profile& profile = model.profile();
    std::mt19937_64 random(5);
    TriangleSetup setup({AdderKind::Exact, 0, profile.components});
    SweepLine counter({profile.column_depth, {}});
    std::vector<int64_t> in;
    std::size_t beats = 0;
    for (int n = 0; n < count; ++n) {
        SweepLineIn item;
        setup(test::corners_of(test::flat_triangle(size, random)), item.triangle);
        counter.run(item.triangle, [&](const SweepStep&) { ++beats; });
        const std::vector<Word> words = item.pack(profile);
        in.insert(in.end(), words.begin(), words.end());
    }
    return {counter.counters(), pass(unit, model, in, {}, {}, beats)};
}

}  // namespace repousse::cosim
