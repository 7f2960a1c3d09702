#pragma once

#include <cstdio>
#include <tuple>
#include <variant>
#include <vector>

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "tlm/platform/platform.h"

namespace repousse::test {

/// What a run must give: the bare loops over the same datapath.
struct Expected {
    std::vector<shell::DrawOutput> outputs;
    std::vector<CounterRow> counters;
};

namespace detail {

inline auto key(const Vec3<int32_t>& v) { return std::make_tuple(v.x, v.y, v.z); }
inline auto key(const Colour<int32_t>& c) { return std::make_tuple(c.red, c.green, c.blue); }

inline auto key(const OutputVertex<Fixed>& v) {
    return std::make_tuple(v.uv.x, v.uv.y, key(v.displaced), key(v.displaced_normal), key(v.colour),
                           v.generation);
}

inline auto key(const SweepOutputVertex<Fixed>& v) {
    return std::make_tuple(v.uv.x, v.uv.y, key(v.displaced), key(v.displaced_normal), key(v.colour),
                           v.name.kind, v.name.part, v.name.a, v.name.b);
}

inline auto key(const OutputTriangle<Fixed>& t) {
    return std::make_tuple(t.path.base, t.path.depth, t.path.digits);
}

}  // namespace detail

namespace detail {

template <class Triangle, class Pipeline>
void run_bare(Pipeline&& pipeline, Expected& expected) {
    std::vector<Triangle> triangles;
    pipeline.run([&](Span<const Triangle> some) {
        triangles.insert(triangles.end(), some.begin(), some.end());
    });
    merge_rows(expected.counters, pipeline.counters().rows());
    expected.outputs.emplace_back(std::move(triangles));
}

}  // namespace detail

inline Expected bare_loops(const Profile& profile, const std::vector<shell::Draw>& draws) {
    Expected expected;
    for (const shell::Draw& draw : draws) {
        if (const auto* adaptive = std::get_if<AdaptiveDraw<Fixed>>(&draw)) {
            detail::run_bare<OutputTriangle<Fixed>>(AdaptivePipeline<Fixed>(profile, *adaptive),
                                                    expected);
        } else {
            const auto& sweep = std::get<SweepDraw<Fixed>>(draw);
            SweepPipeline<Fixed> pipeline(profile, sweep);
            SweepMesh<Fixed> mesh;
            pipeline.run(mesh);
            merge_rows(expected.counters, pipeline.counters().rows());
            expected.outputs.emplace_back(std::move(mesh));
        }
    }
    return expected;
}

/// Whether two outputs have the same triangles, in the same order, to the bit.
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
    bool equal = a.size() == b.size();
    for (std::size_t i = 0; equal && i < a.size(); ++i) {
        equal = detail::key(a[i]) == detail::key(b[i]);
        for (std::size_t k = 0; equal && k < 3; ++k) {
            equal = detail::key(a[i].corners[k]) == detail::key(b[i].corners[k]);
        }
        if (!equal) std::fprintf(stderr, "triangle %zu differs\n", i);
    }
    return equal;
}

/// The same, and vertices are numbered in the same way.
inline bool same(const SweepMesh<Fixed>& a, const SweepMesh<Fixed>& b) {
    bool equal = a.vertices.size() == b.vertices.size() && a.triangles == b.triangles;
    for (std::size_t i = 0; equal && i < a.vertices.size(); ++i) {
        equal = detail::key(a.vertices[i]) == detail::key(b.vertices[i]);
        if (!equal) std::fprintf(stderr, "vertex %zu differs\n", i);
    }
    return equal;
}

inline bool same(const shell::DrawOutput& a, const shell::DrawOutput& b) {
    if (a.index() != b.index()) return false;
    return std::visit(
        [&b](const auto& x) { return same(x, std::get<std::decay_t<decltype(x)>>(b)); }, a);
}

/// The value of a row, 0 if there is none: a unit that is not there counts nothing.
inline uint64_t value_of(const std::vector<CounterRow>& rows, const CounterRow& which) {
    for (const CounterRow& row : rows) {
        if (row.unit == which.unit && row.name == which.name) return row.value;
    }
    return 0;
}

/// Whether the device counted what the bare loops did.
inline bool same_counters(const std::vector<CounterRow>& device,
                          const std::vector<CounterRow>& expected) {
    std::vector<CounterRow> all = device;
    merge_rows(all, expected);
    bool equal = true;
    for (const CounterRow& row : all) {
        const uint64_t found = value_of(device, row), wanted = value_of(expected, row);
        if (found == wanted) continue;
        equal = false;
        std::fprintf(stderr, "%s.%s: %llu, expected %llu\n", row.unit.data(), row.name.data(),
                     static_cast<unsigned long long>(found),
                     static_cast<unsigned long long>(wanted));
    }
    return equal;
}

/// The smallest device for the draws.
inline DeviceConfig config_for(const Profile& profile, const std::vector<shell::Draw>& draws) {
    DeviceConfig config;
    config.profile = profile;
    for (const shell::Draw& draw : draws) {
        DeviceConfig needs;
        if (const auto* adaptive = std::get_if<AdaptiveDraw<Fixed>>(&draw)) {
            const AdaptiveRegisters<Fixed>& r = adaptive->registers;
            needs.adaptive = true;
            needs.view_test = r.use_view_test;
            needs.normal_test = r.use_normal_test;
            needs.height_test = r.use_height_test;
            needs.bump = r.use_bump;
            needs.shade = r.use_shade;
        } else {
            const auto& sweep = std::get<SweepDraw<Fixed>>(draw);
            const SweepRegisters<Fixed>& r = sweep.registers;
            for (const SweepBase<Fixed>& triangle : sweep.triangles) {
                (triangle.direct ? needs.direct : needs.sweep) = true;
            }
            needs.view_clip = needs.sweep && r.use_clip;
            needs.levels = needs.sweep && reads_levels(sweep.map.filter);
            needs.bump = r.use_bump;
            needs.shade = r.use_shade;
        }
        config.include(needs);
    }
    return config;
}

/// Runs a platform in this process and compares it with the bare loops: 0 equal, 1 different,
/// 2 refused. Twice: a run leaves nothing behind that the next one could see.
inline int compare(const DeviceConfig& config, const std::vector<shell::Draw>& draws,
                   const shell::PlatformOptions& options = {}) {
    const Expected expected = bare_loops(config.profile, draws);
    auto platform = shell::Platform::create(config, draws, options);
    const auto first = platform->run(draws);
    const auto result = platform->run(draws);
    if (!first || !result) {
        std::fprintf(stderr, "%s\n", result.error().message().c_str());
        return 2;
    }
    bool equal = result->cycles > 0 && result->cycles == first->cycles &&
                 result->simulated_ns == first->simulated_ns &&
                 result->outputs.size() == draws.size();
    for (std::size_t i = 0; equal && i < draws.size(); ++i) {
        equal = same(result->outputs[i], expected.outputs[i]);
    }
    return equal && same_counters(result->counters, expected.counters) ? 0 : 1;
}

}  // namespace repousse::test
