#include "datapath/units/split.h"

namespace repousse {
namespace {

// Bits of Triangle::unsplit_edges: an edge that a child shares whole with its parent.
enum UnsplitEdge : uint8_t { kNone = 0, kFirst = 1, kSecond = 2, kThird = 4 };

template <class P>
void add(Children<P>& children, const Triangle<P>& parent, const Vertex<P>& v1, const Vertex<P>& v2,
         const Vertex<P>& v3, unsigned unsplit) {
    const auto digit = static_cast<unsigned>(children.count);
    Child<P>& child = children.triangles[static_cast<std::size_t>(children.count++)];
    child.corners = {&v1, &v2, &v3};
    child.path = parent.path.child(digit);
    child.unsplit_edges = static_cast<uint8_t>(unsplit);
}

}  // namespace

template <class P>
Split<P>::Split(const Profile& profile) : to_diagonal_(profile.position.frac, profile.diagonal) {}

template <class P>
void Split<P>::decide(Span<Edge<P>> edges) const {
    for (Edge<P>& edge : edges) {
        const bool detailed = edge.nt | edge.sht | !has_surface_test_;
        edge.split = edge.eligible & edge.ct & edge.vt & detailed;
    }
}

// Squares of 30 bits are 60 wide, their sum 62.
template <class P>
typename P::Wide Split<P>::squared_length(const Vec3<V>& p, const Vec3<V>& q) {
    const auto square = [this](V a, V b) {
        const V d = P::quantize(to_diagonal_, typename P::Wide(a) - b, counters_.overflows);
        return P::mul(d, d);
    };
    return square(p.x, q.x) + square(p.y, q.y) + square(p.z, q.z);
}

template <class P>
bool Split<P>::first_diagonal_is_shorter(const Vertex<P>& a, const Vertex<P>& m1,
                                         const Vertex<P>& b, const Vertex<P>& m2) {
    return squared_length(a.displaced, m1.displaced) <= squared_length(b.displaced, m2.displaced);
}

template <class P>
void Split<P>::tessellate(const Triangle<P>& triangle, const Edge<P>* edges,
                          Children<P>& children) {
    children.count = 0;
    const auto count = static_cast<std::size_t>(edges[0].split + edges[1].split + edges[2].split);
    ++counters_.items;
    ++counters_.edges_split[count];
    const auto& c = triangle.corners;
    if (count == 3) {
        const Vertex<P>&m12 = edges[0].mid, &m23 = edges[1].mid, &m31 = edges[2].mid;
        add(children, triangle, c[0], m12, m31, kNone);
        add(children, triangle, m12, c[1], m23, kNone);
        add(children, triangle, m31, m23, c[2], kNone);
        add(children, triangle, m12, m23, m31, kNone);
    } else if (count == 2) {
        // A-B is the unsplit edge, M1 lies on BC, M2 on CA.
        const unsigned i = !edges[0].split ? 0 : !edges[1].split ? 1 : 2;
        const Vertex<P>&a = c[i], &b = c[(i + 1) % 3], &corner = c[(i + 2) % 3];
        const Vertex<P>&m1 = edges[(i + 1) % 3].mid, &m2 = edges[(i + 2) % 3].mid;
        add(children, triangle, m2, m1, corner, kNone);
        if (first_diagonal_is_shorter(a, m1, b, m2)) {
            add(children, triangle, a, b, m1, kFirst);
            add(children, triangle, a, m1, m2, kNone);
        } else {
            add(children, triangle, a, b, m2, kFirst);
            add(children, triangle, b, m1, m2, kNone);
        }
    } else if (count == 1) {
        // A-B is the split edge, M its new vertex.
        const unsigned i = edges[0].split ? 0 : edges[1].split ? 1 : 2;
        const Vertex<P>&a = c[i], &b = c[(i + 1) % 3], &corner = c[(i + 2) % 3];
        const Vertex<P>& m = edges[i].mid;
        add(children, triangle, a, m, corner, kThird);
        add(children, triangle, m, b, corner, kSecond);
    }
}

template <class P>
SplitBeats Split<P>::operator()(const SplitIn& in) {
    Triangle<P> triangle;
    std::array<Edge<P>, 3> edges;
    const auto vector = [&in](std::size_t i) {
        const Vec3<int32_t>& p = in.displaced[i];
        return Vec3<V>{static_cast<V>(p.x), static_cast<V>(p.y), static_cast<V>(p.z)};
    };
    for (unsigned e = 0; e < 3; ++e) {
        const auto bit = [e](uint8_t bits) { return (bits >> e & 1) != 0; };
        triangle.corners[e].displaced = vector(e);
        edges[e].mid.displaced = vector(3 + e);
        edges[e].eligible = bit(in.eligible);
        edges[e].ct = bit(in.ct), edges[e].vt = bit(in.vt);
        edges[e].nt = bit(in.nt), edges[e].sht = bit(in.sht);
    }
    decide(Span<Edge<P>>(edges.data(), edges.size()));
    Children<P> children;
    tessellate(triangle, edges.data(), children);

    const auto number = [&](const Vertex<P>* v) {
        uint8_t n = 0;
        while (v != (n < 3 ? &triangle.corners[n] : &edges[n - 3U].mid)) ++n;
        return n;
    };
    SplitBeats out;
    out.count = children.count == 0 ? 1 : children.count;
    for (int i = 0; i < children.count; ++i) {
        const Child<P>& child = children.triangles[static_cast<std::size_t>(i)];
        SplitOut& beat = out.beats[static_cast<std::size_t>(i)];
        beat.digit = static_cast<uint8_t>(i);
        for (std::size_t c = 0; c < 3; ++c) beat.vertices[c] = number(child.corners[c]);
        beat.unsplit = child.unsplit_edges;
    }
    out.beats[0].pass = children.count == 0;
    out.beats[static_cast<std::size_t>(out.count - 1)].last = true;
    return out;
}

template class Split<Fixed>;
template class Split<Real>;

}  // namespace repousse
