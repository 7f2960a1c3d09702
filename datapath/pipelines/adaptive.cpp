#include "datapath/pipelines/adaptive.h"

namespace repousse {

template <class P>
AdaptivePipeline<P>::AdaptivePipeline(const Profile& profile, const AdaptiveDraw<P>& draw)
    : draw_(draw),
      registers_(draw.registers),
      mid_vertex_(profile),
      displace_(profile),
      tests_(profile, draw.registers, draw.tables.sums) {
    const MapView<P> map = draw.view();
    edge_iter_.configure(registers_.cap);
    displace_.configure(map);
    if (registers_.use_bump) {
        bump_.emplace(profile);
        bump_->configure(map);
    }
    if (registers_.use_shade) {
        shade_.emplace(profile);
        shade_->configure(registers_.shade, registers_.use_bump);
    }
    if (registers_.use_view_test) {
        vertex_transform_.emplace(profile);
        vertex_transform_->configure(draw.camera);
    }
}

template <class P>
void AdaptivePipeline<P>::attach(const TexelPorts& ports, BeginReads begin) {
    displace_.attach(ports.displace);
    if (bump_) bump_->attach(ports.bump);
    if (tests_.height_test()) tests_.height_test()->attach(ports.height_test);
    begin_reads_ = std::move(begin);
}

template <class P>
void AdaptivePipeline<P>::prepare_base(Triangle<P>& triangle) {
    for (Vertex<P>& v : triangle.corners) {
        v.displaced = displace_(v.position, v.normal, v.uv);
        if (bump_) (*bump_)(v);
        if (shade_) (*shade_)(v);
        if (vertex_transform_) v.screen = (*vertex_transform_)(v.displaced);
    }
}

template <class P>
void AdaptivePipeline<P>::test_edges(Span<const Triangle<P>> triangles, Span<Edge<P>> edges) {
    const bool for_test = registers_.use_normal_test;
    const auto attributes = [&] {
        mid_vertex_.run_attributes(edges, for_test, registers_.eager);
        if (bump_) bump_->run(edges, for_test, registers_.eager);
    };
    edge_iter_.run(triangles, edges);
    mid_vertex_.run_topology(edges);
    tests_.run(edges, attributes);
    if (observe_) observe_(edges);
    if (!for_test) attributes();
    displace_.run(edges);
    if (shade_) shade_->run(edges);
    if (vertex_transform_) vertex_transform_->run(edges);
}

template <class P>
bool AdaptivePipeline<P>::run(const Emit& emit, int contexts) {
    Contexts<P> lanes(contexts, registers_.order, registers_.cap);
    std::vector<Triangle<P>> triangles(kBatchTriangles);
    std::vector<Edge<P>> edges(3 * kBatchTriangles);
    Children<P> children;
    std::size_t next = 0;
    const auto fetch = [&](Triangle<P>& place) {
        if (next == draw_.triangles.size()) return false;
        if (begin_reads_) begin_reads_(Path{static_cast<uint32_t>(next), 0, {}});
        place = draw_.base_triangle(next++);
        prepare_base(place);
        return true;
    };
    bool fits = true;
    while (const std::size_t n = lanes.gather(triangles, fetch)) {
        const Span<Edge<P>> batch(edges.data(), 3 * n);
        if (begin_reads_) {  // triangle by triangle
            for (std::size_t i = 0; i < n; ++i) {
                begin_reads_(triangles[i].path);
                test_edges({&triangles[i], 1}, {&edges[3 * i], 3});
            }
        } else {
            test_edges(Span<const Triangle<P>>(triangles.data(), n), batch);
        }
        for (std::size_t i = 0; i < n; ++i) {
            tests_.split().tessellate(triangles[i], &edges[3 * i], children);
            fits = lanes.scatter(i, triangles[i], children) && fits;
        }
        lanes.flush(emit);
    }
    stack_peak_ = lanes.peak();
    return fits;
}

template <class P>
AdaptiveCounters AdaptivePipeline<P>::counters() const {
    AdaptiveCounters counters;
    counters.stack_peak = stack_peak_;
    counters.edge_iter = edge_iter_.counters();
    counters.mid_vertex = mid_vertex_.counters();
    counters.texcoord_test = tests_.texcoord_test().counters();
    counters.displace = displace_.counters();
    counters.split = tests_.split().counters();
    if (vertex_transform_) counters.vertex_transform = vertex_transform_->counters();
    if (tests_.view_test()) counters.view_test = tests_.view_test()->counters();
    if (bump_) counters.bump = bump_->counters();
    if (shade_) counters.shade = shade_->counters();
    if (tests_.normal_test()) counters.normal_test = tests_.normal_test()->counters();
    if (tests_.height_test()) {
        counters.height_test = tests_.height_test()->counters();
        counters.height_test_reads = tests_.height_test()->stats().reads;
    }
    return counters;
}

template class AdaptivePipeline<Fixed>;
template class AdaptivePipeline<Real>;

}  // namespace repousse
