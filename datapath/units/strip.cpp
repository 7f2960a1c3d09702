#include "datapath/units/strip.h"

namespace repousse {

template <class V>
void Strip<V>::operator()(const StripStep& step, Span<const V> vertices, StripTriangles<V>& out) {
    std::size_t next = 0;
    const auto next_vertex = [&](V& vertex) {
        if (next == vertices.size()) return false;
        vertex = vertices[next++];
        return true;
    };
    carry_out(step, control_, next_vertex, out);
}

template <class V>
void Strip<V>::flush() {
    control_.init(false);
    loaded_.fill(false);
    column_.clear();
    split_.clear();
}

template class Strip<uint32_t>;     // a vertex by its number
template class Strip<SweepVertex>;  // straight from the sweep line

}  // namespace repousse
