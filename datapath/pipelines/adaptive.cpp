#include "datapath/pipelines/adaptive.h"

namespace repousse {

template <class P>
AdaptivePipeline<P>::AdaptivePipeline(const Profile& profile, const AdaptiveDraw<P>& draw)
    : draw_(draw),
      registers_(draw.registers),
      mid_vertex_(profile),
      texcoord_test_(profile),
      displace_(profile),
      split_(profile) {
    const MapView<P> map = draw.view();
    edge_iter_.configure(registers_.cap);
    displace_.configure(map);
    split_.configure(registers_.use_normal_test || registers_.use_height_test);
    if (registers_.use_bump) {
        bump_.emplace(profile);
        bump_->configure(map);
    }
    if (registers_.use_normal_test) {
        normal_test_.emplace(profile);
        normal_test_->configure(registers_.normal_threshold, registers_.normal_space);
    }
    if (registers_.use_height_test) {
        height_test_.emplace(profile);
        height_test_->configure(registers_.height_test, map.sums);
    }
    if (registers_.use_view_test) {
        vertex_transform_.emplace(profile);
        vertex_transform_->configure(draw.camera);
        view_test_.emplace(profile);
        view_test_->configure(registers_.view_threshold);
    }
}

template <class P>
void AdaptivePipeline<P>::prepare_base(Triangle<P>& triangle) {
    for (Vertex<P>& v : triangle.corners) {
        v.displaced = displace_(v.position, v.normal, v.uv);
        if (bump_) (*bump_)(v);
        if (vertex_transform_) v.screen = (*vertex_transform_)(v.displaced);
    }
}

template <class P>
void AdaptivePipeline<P>::test_edges(Span<const Triangle<P>> triangles, Span<Edge<P>> edges) {
    const bool for_test = normal_test_.has_value();
    const bool eager = registers_.eager;
    const auto attributes = [&] {
        mid_vertex_.run_attributes(edges, for_test, eager);
        if (bump_) bump_->run(edges, for_test, eager);
    };
    edge_iter_.run(triangles, edges);
    mid_vertex_.run_topology(edges);
    texcoord_test_.run(edges, eager);
    if (view_test_) view_test_->run(edges, eager);
    if (for_test) {
        attributes();
        normal_test_->run(edges, eager);
    }
    if (height_test_) height_test_->run(edges, eager);
    split_.decide(edges);
    if (!for_test) attributes();
    displace_.run(edges);
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
        place = draw_.base_triangle(next++);
        prepare_base(place);
        return true;
    };
    bool fits = true;
    while (const std::size_t n = lanes.gather(triangles, fetch)) {
        const Span<Edge<P>> batch(edges.data(), 3 * n);
        test_edges(Span<const Triangle<P>>(triangles.data(), n), batch);
        for (std::size_t i = 0; i < n; ++i) {
            split_.tessellate(triangles[i], &edges[3 * i], children);
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
    counters.texcoord_test = texcoord_test_.counters();
    counters.displace = displace_.counters();
    counters.split = split_.counters();
    if (vertex_transform_) counters.vertex_transform = vertex_transform_->counters();
    if (view_test_) counters.view_test = view_test_->counters();
    if (bump_) counters.bump = bump_->counters();
    if (normal_test_) counters.normal_test = normal_test_->counters();
    if (height_test_) {
        counters.height_test = height_test_->counters();
        counters.height_test_reads = height_test_->stats().reads;
    }
    return counters;
}

template class AdaptivePipeline<Fixed>;
template class AdaptivePipeline<Real>;

}  // namespace repousse
