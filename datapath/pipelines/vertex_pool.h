#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/span.h"
#include "datapath/units/strip.h"

namespace repousse {

/// Vertices by number, for a stripping unit that keeps numbers instead of vertices. Those that the
/// unit may still refer to stay; the others go when there are many.
template <class V>
class VertexPool {
public:
    /// Room for a batch: the number of the vertex that is added next.
    uint32_t start_batch(Strip<uint32_t>& strip) {
        if (vertices_.size() > kMost) renumber(strip);
        return static_cast<uint32_t>(vertices_.size());
    }
    void push_back(const V& vertex) { vertices_.push_back(vertex); }
    const V& operator[](uint32_t number) const { return vertices_[number]; }
    Span<const V> all() const { return vertices_; }

    /// Forgets all; the unit must be flushed.
    void clear() { vertices_.clear(); }

private:
    // Together they fit the second-level cache; a unit holds 516 at most.
    static constexpr std::size_t kMost = 4096;
    static constexpr uint32_t kNone = 0xffffffff;

    void renumber(Strip<uint32_t>& strip) {
        numbers_.assign(vertices_.size(), kNone);
        kept_.clear();
        strip.for_each([this](uint32_t& number) {
            uint32_t& renumbered = numbers_[number];
            if (renumbered == kNone) {
                renumbered = static_cast<uint32_t>(kept_.size());
                kept_.push_back(vertices_[number]);
            }
            number = renumbered;
        });
        vertices_.swap(kept_);
    }

    std::vector<V> vertices_;
    std::vector<V> kept_;
    std::vector<uint32_t> numbers_;
};

}  // namespace repousse
