#include "datapath/units/normal_test.h"

namespace repousse {
namespace {

// Components have at most 20 bits, so their difference fits the 32 of a value.
template <class W, class V>
bool differs(const Vec3<V>& a, const Vec3<V>& b, W threshold) {
    const auto beyond = [threshold](V p, V q) {
        const W d = W(p) - q;
        return (d < 0 ? -d : d) > threshold;
    };
    return beyond(a.x, b.x) | beyond(a.y, b.y) | beyond(a.z, b.z);
}

}  // namespace

template <class P>
NormalTest<P>::NormalTest(const Profile& profile)
    : align_map_(profile.map_normal.frac - profile.displaced_normal.frac),
      align_base_(profile.normal.frac - profile.displaced_normal.frac) {}

template <class P>
void NormalTest<P>::configure(V threshold, NormalSpace space) {
    space_ = space;
    threshold_ = threshold;
    base_threshold_ = P::align(threshold, align_base_);
    // A coarser map normal differs by multiples of its own LSB: dropping the threshold's lower
    // bits changes no decision.
    map_threshold_ = P::align(threshold, align_map_);
}

template <class P>
bool NormalTest<P>::operator()(const Vertex<P>& v1, const Vertex<P>& v2,
                               const Vertex<P>& mid) const {
    if (space_ == NormalSpace::World) {
        return differs(mid.displaced_normal, v1.displaced_normal, threshold_) |
               differs(mid.displaced_normal, v2.displaced_normal, threshold_);
    }
    return differs(mid.map_normal, v1.map_normal, map_threshold_) |
           differs(mid.map_normal, v2.map_normal, map_threshold_) |
           differs(mid.normal, v1.normal, base_threshold_) |
           differs(mid.normal, v2.normal, base_threshold_);
}

template <class P>
NormalTestOut NormalTest<P>::operator()(const NormalTestIn& in) const {
    const auto vector = [](const Vec3<int32_t>& n) {
        return Vec3<V>{static_cast<V>(n.x), static_cast<V>(n.y), static_cast<V>(n.z)};
    };
    std::array<Vertex<P>, 3> v;
    for (std::size_t i = 0; i < v.size(); ++i) {
        v[i].displaced_normal = vector(in.vertices[i].displaced_normal);
        v[i].map_normal = vector(in.vertices[i].map_normal);
        v[i].normal = vector(in.vertices[i].normal);
    }
    return {!in.skip && (*this)(v[0], v[1], v[2])};
}

template <class P>
void NormalTest<P>::run(Span<Edge<P>> edges, bool eager) {
    counters_.items += edges.size();
    for (Edge<P>& edge : edges) {
        if (!edge.undecided && !eager) continue;
        ++counters_.tests;
        edge.nt = (*this)(*edge.v1, *edge.v2, edge.mid);
        counters_.positives += edge.nt;
    }
}

template class NormalTest<Fixed>;
template class NormalTest<Real>;

}  // namespace repousse
