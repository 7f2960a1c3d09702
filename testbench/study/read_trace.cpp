#include "testbench/study/read_trace.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "datapath/pipelines/adaptive.h"
#include "datapath/pipelines/sweep.h"
#include "testbench/host/draw.h"
#include "testbench/host/sweep_draw.h"
#include "testbench/study/scene_run.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

unsigned digit(const Path& path, unsigned at) {
    return static_cast<unsigned>(path.digits[at / 32] >> 2 * (at % 32) & 3);
}

/// The traces of an object's units.
struct ObjectTraces {
    ReadTrace displace, bump, height_test;

    TexelPorts ports() { return {&displace, &bump, &height_test}; }
};

/// Adds an object's reads to a unit's; a unit that has none is not in the scene.
void append(SceneReads& scene, const char* unit, const ReadTrace& trace) {
    if (trace.addresses().empty()) return;
    auto found = std::find_if(scene.units.begin(), scene.units.end(),
                              [unit](const UnitReads& reads) { return reads.unit == unit; });
    if (found == scene.units.end()) found = scene.units.insert(found, {unit, {}});
    found->objects.push_back(trace.addresses());
}

Error lost(const std::string& object) {
    return {ErrorKind::Mismatch, object, "the units lost a triangle", {}, {}};
}

Status trace_object(const Profile& profile, const host::DrawInputs& inputs,
                    const host::Object& object, ObjectTraces& traces, uint64_t& triangles) {
    if (object.method == host::Method::Adaptive) {
        const auto draw = host::make_draw<Fixed>(profile, inputs);
        if (!draw) return draw.error();
        AdaptivePipeline<Fixed> pipeline(profile, *draw);
        pipeline.attach(traces.ports());
        const auto count = [&](Span<const OutputTriangle<Fixed>> some) {
            triangles += some.size();
        };
        return pipeline.run(count, 1) ? done() : Status(lost(object.name));
    }
    const auto draw = host::make_sweep_draw<Fixed>(profile, inputs);
    if (!draw) return draw.error();
    SweepPipeline<Fixed> pipeline(profile, *draw);
    pipeline.attach(traces.ports());
    const auto count = [&](Span<const SweepOutputVertex<Fixed>>, Span<const FineTriangle> some) {
        triangles += some.size();
    };
    return pipeline.run(count) ? done() : Status(lost(object.name));
}

}  // namespace

// A stack pushes a triangle's parts in the order of their digits and gives back the last one first,
// with all that it turns into; a queue goes level by level.
bool comes_before(const Path& a, const Path& b, StackOrder order) {
    if (a.base != b.base) return a.base < b.base;
    if (order == StackOrder::Fifo && a.depth != b.depth) return a.depth < b.depth;
    const unsigned common = std::min(a.depth, b.depth);
    for (unsigned at = 0; at < common; ++at) {
        const unsigned of_a = digit(a, at), of_b = digit(b, at);
        if (of_a != of_b) return order == StackOrder::Lifo ? of_a > of_b : of_a < of_b;
    }
    return a.depth < b.depth;
}

std::vector<uint32_t> ReadTrace::in_order(StackOrder order) const {
    std::vector<std::size_t> parts(parts_.size());
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    std::stable_sort(parts.begin(), parts.end(), [&](std::size_t i, std::size_t j) {
        return comes_before(parts_[i].path, parts_[j].path, order);
    });
    std::vector<uint32_t> sorted;
    sorted.reserve(addresses_.size());
    for (const std::size_t i : parts) {
        const std::size_t end = i + 1 < parts_.size() ? parts_[i + 1].from : addresses_.size();
        for (std::size_t at = parts_[i].from; at < end; ++at) sorted.push_back(addresses_[at]);
    }
    return sorted;
}

uint64_t UnitReads::count() const {
    uint64_t reads = 0;
    for (const std::vector<uint32_t>& object : objects) reads += object.size();
    return reads;
}

Result<SceneReads> scene_reads(const std::string& scene_file, bool eager) {
    const auto run = SceneRun::open(scene_file);
    if (!run) return run.error();
    const auto profile = find_profile(run->scene.profile);
    if (!profile) return profile.error();
    SceneReads scene;
    scene.scene = std::filesystem::path(scene_file).stem().string();
    scene.source = run->source(0);
    scene.eager = eager;
    for (std::size_t i = 0; i < run->scene.objects.size(); ++i) {
        host::Object object = run->scene.objects[i];
        object.adaptive.eager = eager;
        scene.adaptive |= object.method == host::Method::Adaptive;
        const host::DrawInputs inputs =
            host::draw_inputs(run->scene, object, run->mesh(i), run->map(i));
        ObjectTraces traces;
        const Status traced = trace_object(*profile, inputs, object, traces, scene.triangles);
        if (!traced) return traced.error();
        append(scene, "displace", traces.displace);
        append(scene, "bump", traces.bump);
        append(scene, "height_test", traces.height_test);
    }
    return scene;
}

}  // namespace repousse::study
