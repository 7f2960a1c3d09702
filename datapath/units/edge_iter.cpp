#include "datapath/units/edge_iter.h"

#include <algorithm>

namespace repousse {

template <class P>
void EdgeIter<P>::run(Span<const Triangle<P>> triangles, Span<Edge<P>> edges) {
    Edge<P>* edge = edges.data();
    for (const Triangle<P>& triangle : triangles) {
        for (unsigned e = 0; e < 3; ++e, ++edge) {
            const Vertex<P>& v1 = triangle.corners[e];
            const Vertex<P>& v2 = triangle.corners[(e + 1) % 3];
            const bool capped = std::max(v1.generation, v2.generation) >= cap_;
            const bool known = (triangle.unsplit_edges >> e & 1) != 0;
            edge->v1 = &v1;
            edge->v2 = &v2;
            edge->eligible = edge->undecided = !capped && !known;
            edge->ct = edge->vt = true;
            edge->nt = edge->sht = edge->split = false;
            counters_.capped += capped;
            counters_.known_unsplit += known && !capped;
        }
    }
    counters_.items += edges.size();
}

template class EdgeIter<Fixed>;
template class EdgeIter<Real>;

}  // namespace repousse
