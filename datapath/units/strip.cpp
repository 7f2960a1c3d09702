#include "datapath/units/strip.h"

namespace repousse {

template <class V>
const V* Strip<V>::source(StripOp op, uint8_t place, Span<const V> vertices, std::size_t& next) {
    switch (op) {
        case StripOp::Ref:
            return loaded_[place] ? &registers_[place] : nullptr;
        case StripOp::New:
            return next < vertices.size() ? &vertices[next++] : nullptr;
        case StripOp::Column:
            return column_.pop();
        case StripOp::Split:
            return split_.pop();
    }
    return nullptr;
}

template <class V>
void Strip<V>::keep(StripKeep kept, const V& vertex) {
    if (kept == StripKeep::No) return;
    Ring& ring = kept == StripKeep::Column ? column_ : split_;
    counters_.bad_refs += !ring.push(vertex);
    if (ring.size() > counters_.deepest) counters_.deepest = ring.size();
}

// A triangle reads its older registers before the new vertex is written, which may replace one.
template <class V>
void Strip<V>::operator()(const StripStep& step, Span<const V> vertices, StripTriangles<V>& out) {
    out.count = 0;
    ++counters_.steps;
    counters_.commands += static_cast<uint64_t>(step.count) + step.init;
    counters_.strips += step.init;
    if (step.init) control_.init(step.flip);
    std::size_t next = 0;
    for (std::size_t i = 0; i < step.count; ++i) {
        const StripCommand& command = step.commands[i];
        const auto place = static_cast<uint8_t>(command.place % kStripRegisters);
        const V* vertex = source(command.op, place, vertices, next);
        if (vertex == nullptr) {
            ++counters_.bad_refs;
            continue;
        }
        const bool is_ref = command.op == StripOp::Ref;
        const StripControl::Triangle made = control_.add(place, is_ref);
        if (made.made && out.count == kStripTriangles) {
            ++counters_.bad_refs;
        } else if (made.made) {
            const V &older = registers_[made.older], &newer = registers_[made.newer];
            auto& triangle = out.triangles[out.count++];
            triangle[0] = older;
            triangle[1] = made.odd ? *vertex : newer;
            triangle[2] = made.odd ? newer : *vertex;
            ++counters_.triangles;
        }
        counters_.swaps += made.swap;
        if (is_ref) continue;
        ++counters_.vertices;
        keep(command.keep, *vertex);
        registers_[place] = *vertex;
        loaded_[place] = true;
    }
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
