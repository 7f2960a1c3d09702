#include "testbench/cosim/tested_edges.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "datapath/pipelines/adaptive.h"
#include "testbench/cosim/hash.h"

namespace repousse::cosim {
namespace {

/// An end of an edge: everything that the tests know of it.
using End = std::array<int64_t, 14>;

End end_of(const Vertex<Fixed>& v) {
    const auto& [n, m, b] = std::tie(v.displaced_normal, v.map_normal, v.normal);
    return {v.uv.x, v.uv.y, v.screen.near, v.screen.x, v.screen.y, n.x, n.y,
            n.z,    m.x,    m.y,           m.z,        b.x,        b.y, b.z};
}

/// FNV-1a, word by word, with the high bits folded back.
uint64_t hash_of(uint64_t hash, const int64_t* words, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        hash = (hash ^ static_cast<uint64_t>(words[i])) * 1099511628211ULL;
        hash ^= hash >> 29;
    }
    return hash;
}

}  // namespace

void TestedEdges::run(const AdaptiveDraw<Fixed>& draw,
                      const std::function<void(const Recorded&)>& take) {
    const AdaptiveRegisters<Fixed>& registers = draw.registers;
    const auto config = pack_registers(registers);
    const auto table = std::make_shared<Table>(
        Table{registers.height_test.width, registers.height_test.height, draw.tables.sums});
    Recorded recorded{{"scene", {config.begin(), config.end()}, table, {}}, {}, 0};
    uint64_t setting = hash_of(Hash().value(), config.data(), config.size());
    for (const uint64_t sum : draw.tables.sums) {
        const auto word = static_cast<int64_t>(sum);
        setting = hash_of(setting, &word, 1);
    }

    const auto send = [&] {
        if (!recorded.outputs.empty()) take(recorded);
        recorded.scenario.inputs.clear();
        recorded.outputs.clear();
    };
    std::size_t waiting = 0;
    const auto observe = [&](Span<const Edge<Fixed>> edges) {
        for (const Edge<Fixed>& edge : edges) {
            const bool has_normals =
                registers.use_normal_test && edge.wants_attributes(true, registers.eager);
            recorded.scenario.add(TessellationTestsIn::of(edge, has_normals));
            const auto said = TessellationTestsOut::of(edge).pack();
            recorded.outputs.insert(recorded.outputs.end(), said.begin(), said.end());
            End a = end_of(*edge.v1), b = end_of(*edge.v2);
            if (b < a) std::swap(a, b);
            seen_.insert(hash_of(hash_of(setting, a.data(), a.size()), b.data(), b.size()));
        }
        edges_ += edges.size();
        waiting += edges.size();
        if (waiting < kPortion) return;
        send();
        waiting = 0;
    };
    AdaptivePipeline<Fixed> pipeline(profile_, draw);
    pipeline.observe_tests(observe);
    pipeline.run([](Span<const OutputTriangle<Fixed>>) {});
    send();
}

}  // namespace repousse::cosim
