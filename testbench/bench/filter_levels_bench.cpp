// What the filter levels of a map cost: all levels of a megatexel of made landscape. Nanoseconds a
// texel are milliseconds a million texels.

#include <benchmark/benchmark.h>

#include "testbench/bench/best_rounds.h"
#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/procedural_map.h"

namespace {

using repousse::bench::Row;
using repousse::host::LevelFilter;

constexpr int kSide = 1024;

Row row(const char* name, LevelFilter kind) {
    static const repousse::host::HeightMap map = repousse::host::make_fbm_map(kSide, kSide, {});
    return {name, [kind] { benchmark::DoNotOptimize(repousse::host::filter_levels(map, kind)); }};
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<Row> rows = {row("all levels/average", LevelFilter::Average),
                                   row("all levels/box maximum", LevelFilter::BoxMaximum),
                                   row("all levels/variational", LevelFilter::Variational)};
    return repousse::bench::run_groups(argc, argv, {rows}, "a texel of the full map",
                                       double{kSide} * kSide, 5, 0.1);
}

// SystemC's library asks for it; nothing is elaborated here.
int sc_main(int, char**) { return 0; }
