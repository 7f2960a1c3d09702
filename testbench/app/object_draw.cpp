#include "testbench/app/object_draw.h"

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "testbench/host/leaves.h"
#include "testbench/host/surface.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/host/sweep_judge.h"

namespace repousse::app {
namespace {

// One function object of several: the visitor of a variant.
template <class... F>
struct Overload : F... {
    using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

template <class P>
Result<ObjectDraw<P>> make_object_draw(const Profile& profile, const host::DrawInputs& inputs) {
    if (inputs.method == host::Method::Adaptive) {
        auto draw = host::make_draw<P>(profile, inputs);
        if (!draw) return draw.error();
        return ObjectDraw<P>(std::move(*draw));
    }
    auto draw = host::make_sweep_draw<P>(profile, inputs);
    if (!draw) return draw.error();
    return ObjectDraw<P>(std::move(*draw));
}

template <class P>
std::vector<OutputTriangle<P>> tessellate(AdaptivePipeline<P>& pipeline) {
    std::vector<OutputTriangle<P>> triangles;
    pipeline.run([&](Span<const OutputTriangle<P>> some) {
        triangles.insert(triangles.end(), some.begin(), some.end());
    });
    return triangles;
}

// The displaced base mesh is what a generation cap of 0 leaves.
template <class P>
reference::LeafReport judge(const Profile& profile, AdaptiveDraw<P> draw,
                            const std::vector<OutputTriangle<P>>& triangles) {
    draw.registers.cap = 0;
    draw.registers.use_shade = false;
    AdaptivePipeline<P> base(profile, draw);
    return reference::check_leaves(host::leaves_of<P>(triangles, profile),
                                   host::leaves_of<P>(tessellate(base), profile));
}

}  // namespace

template <class P>
Result<std::vector<ObjectDraw<P>>> make_draws(const Job& job, const Profile& profile) {
    std::vector<ObjectDraw<P>> draws;
    for (std::size_t i = 0; i < job.objects.size(); ++i) {
        Result<ObjectDraw<P>> draw = make_object_draw<P>(profile, job.inputs(i));
        if (!draw) {
            Error error = draw.error();
            if (error.where.empty()) error.where = job.objects[i].object->mark.text();
            error.what = "object \"" + job.objects[i].object->name + "\": " + error.what;
            return error;
        }
        draws.push_back(std::move(*draw));
    }
    return draws;
}

template <class P>
ObjectOutput<P> run_bare(const Profile& profile, const ObjectDraw<P>& draw,
                         std::vector<CounterRow>& counters) {
    const auto adaptive = [&](const AdaptiveDraw<P>& d) -> ObjectOutput<P> {
        AdaptivePipeline<P> pipeline(profile, d);
        auto triangles = tessellate(pipeline);
        merge_rows(counters, pipeline.counters().rows());
        return triangles;
    };
    const auto sweep = [&](const SweepDraw<P>& d) -> ObjectOutput<P> {
        SweepPipeline<P> pipeline(profile, d);
        SweepMesh<P> mesh;
        pipeline.run(mesh);
        merge_rows(counters, pipeline.counters().rows());
        return mesh;
    };
    return std::visit(Overload{adaptive, sweep}, draw);
}

template <class P>
ObjectResult object_result(const Job& job, std::size_t i, const Profile& profile,
                           const ObjectDraw<P>& draw, const ObjectOutput<P>& output, bool check) {
    ObjectResult result;
    const host::DrawInputs inputs = job.inputs(i);
    const auto adaptive = [&](const AdaptiveDraw<P>& d) {
        const auto& triangles = std::get<std::vector<OutputTriangle<P>>>(output);
        result.base_triangles = d.triangles.size();
        result.cap = d.registers.cap;
        result.surface = host::surface_mesh(triangles, profile, inputs);
        if (check) result.invariants = judge(profile, d, triangles);
    };
    const auto sweep = [&](const SweepDraw<P>& d) {
        const auto& mesh = std::get<SweepMesh<P>>(output);
        result.base_triangles = d.triangles.size();
        result.surface = host::surface_mesh(mesh, profile, inputs);
        if (check) {
            result.invariants = host::SweepJudge<P>(profile, d, *inputs.mesh).judge(mesh);
        }
    };
    std::visit(Overload{adaptive, sweep}, draw);
    return result;
}

template <class P>
uint64_t table_bytes(const ObjectDraw<P>& draw) {
    const auto of_tables = [](const MapTables<P>& tables) {
        return tables.heights.size() * sizeof(uint16_t) +
               tables.normals.size() * sizeof(Vec3<typename P::Texel>) +
               tables.turns.size() * sizeof(Turn<typename P::Texel>) +
               tables.sums.size() * sizeof(uint64_t);
    };
    const auto adaptive = [&](const AdaptiveDraw<P>& d) { return of_tables(d.tables); };
    const auto sweep = [&](const SweepDraw<P>& d) {
        return of_tables(d.tables) + d.z_table.size() * sizeof(uint32_t);
    };
    return std::visit(Overload{adaptive, sweep}, draw);
}

template Result<std::vector<ObjectDraw<Fixed>>> make_draws(const Job&, const Profile&);
template Result<std::vector<ObjectDraw<Real>>> make_draws(const Job&, const Profile&);
template ObjectOutput<Fixed> run_bare(const Profile&, const ObjectDraw<Fixed>&,
                                      std::vector<CounterRow>&);
template ObjectOutput<Real> run_bare(const Profile&, const ObjectDraw<Real>&,
                                     std::vector<CounterRow>&);
template ObjectResult object_result(const Job&, std::size_t, const Profile&,
                                    const ObjectDraw<Fixed>&, const ObjectOutput<Fixed>&, bool);
template ObjectResult object_result(const Job&, std::size_t, const Profile&,
                                    const ObjectDraw<Real>&, const ObjectOutput<Real>&, bool);
template uint64_t table_bytes(const ObjectDraw<Fixed>&);
template uint64_t table_bytes(const ObjectDraw<Real>&);

}  // namespace repousse::app
