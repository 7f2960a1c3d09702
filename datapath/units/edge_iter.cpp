#include "datapath/units/edge_iter.h"

namespace repousse {

template <class P>
std::array<EdgeIterOut, 3> EdgeIter<P>::operator()(const EdgeIterIn& in) const {
    std::array<EdgeIterOut, 3> edges;
    for (unsigned e = 0; e < 3; ++e) {
        const bool known = (in.unsplit >> e & 1) != 0;
        edges[e].number = static_cast<uint8_t>(e);
        edges[e].eligible = !capped(in.generations[e], in.generations[(e + 1) % 3]) && !known;
        edges[e].last = e == 2;
    }
    return edges;
}

template <class P>
void EdgeIter<P>::run(Span<const Triangle<P>> triangles, Span<Edge<P>> edges) {
    Edge<P>* edge = edges.data();
    for (const Triangle<P>& triangle : triangles) {
        for (unsigned e = 0; e < 3; ++e, ++edge) {
            const Vertex<P>& v1 = triangle.corners[e];
            const Vertex<P>& v2 = triangle.corners[(e + 1) % 3];
            const bool too_fine = capped(v1.generation, v2.generation);
            const bool known = (triangle.unsplit_edges >> e & 1) != 0;
            edge->v1 = &v1;
            edge->v2 = &v2;
            edge->eligible = edge->undecided = !too_fine && !known;
            edge->ct = edge->vt = true;
            edge->nt = edge->sht = edge->split = false;
            counters_.capped += too_fine;
            counters_.known_unsplit += known && !too_fine;
        }
    }
    counters_.items += edges.size();
}

template class EdgeIter<Fixed>;
template class EdgeIter<Real>;

}  // namespace repousse
