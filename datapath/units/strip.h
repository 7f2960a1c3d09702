#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/strip_desc.h"

namespace repousse {

/// What `strip` counted.
struct StripCounters {
    uint64_t steps = 0;
    uint64_t commands = 0;  ///< init included
    uint64_t strips = 0;
    uint64_t swaps = 0;  ///< refs that turned the strip and made no triangle
    uint64_t vertices = 0;
    uint64_t triangles = 0;
    uint64_t bad_refs = 0;    ///< a register or FIFO without a vertex was named
    std::size_t deepest = 0;  ///< most vertices that either FIFO held
};

/// The triangles of one step.
template <class V>
struct StripTriangles {
    uint8_t count = 0;
    std::array<std::array<V, 3>, 4> triangles;
};

/// The control of the stripping unit: which vertices make a triangle, in which order. It knows
/// registers by number only.
class StripControl {
public:
    /// Registers of the older and the newer of the strip's last two vertices, and how to wind.
    struct Triangle {
        bool made = false;
        bool swap = false;  ///< not made: the vertex is the older one again
        bool odd = false;   ///< swap the last two of (older, newer, next)
        uint8_t older = 0;
        uint8_t newer = 0;
    };

    void init(bool flip) {
        length_ = 0;
        odd_ = flip;
    }

    /// Adds the vertex of a register, before the register is loaded. A ref to the older of the last
    /// two vertices is a swap: it turns the strip and makes no triangle.
    Triangle add(uint8_t place, bool is_ref);

private:
    uint8_t length_ = 0;  // vertices in the strip, counted to 2
    bool odd_ = false;
    uint8_t older_ = 0;
    uint8_t newer_ = 0;
};

/// The stripping unit (Gumhold and Huettner 2.3): four registers for displaced vertices, from which
/// sequential strips are built, with every second triangle wound the other way.
///
///  1. init starts a strip, with its winding;
///  2. setref i loads register i and adds the vertex; ref i adds the vertex in register i;
///  3. from the third vertex on each makes a triangle with the two before it, but a swap;
///  4. kept vertices go to the column or the split FIFO as well, to be set from there.
///
/// A whole step, up to four commands, is one transaction. `V` is the vertex, whatever the stages
/// before have made of it.
template <class V>
class Strip {
public:
    explicit Strip(std::size_t fifo_depth = kStripFifoDepth)
        : column_(fifo_depth), split_(fifo_depth) {}

    /// One step. `vertices` are those of its `New` commands, in their order.
    void operator()(const StripStep& step, Span<const V> vertices, StripTriangles<V>& out);

    /// End of frame, or after the sweep line has dropped a triangle: forgets strip and FIFOs.
    void flush();

    bool bad_ref() const { return counters_.bad_refs != 0; }
    const StripCounters& counters() const { return counters_; }
    void reset() { flush(), counters_ = {}; }

private:
    /// A FIFO of fixed size in a ring. A full one refuses, an empty one gives nothing.
    class Ring {
    public:
        explicit Ring(std::size_t depth) : places_(depth) {}
        bool push(const V& vertex) {
            if (count_ == places_.size()) return false;
            places_[(first_ + count_++) % places_.size()] = vertex;
            return true;
        }
        const V* pop() {
            if (count_ == 0) return nullptr;
            const V* vertex = &places_[first_];
            first_ = (first_ + 1) % places_.size();
            --count_;
            return vertex;
        }
        void clear() { first_ = count_ = 0; }
        std::size_t size() const { return count_; }

    private:
        std::vector<V> places_;
        std::size_t first_ = 0, count_ = 0;
    };

    const V* source(StripOp op, uint8_t place, Span<const V> vertices, std::size_t& next);
    void keep(StripKeep kept, const V& vertex);

    StripControl control_;
    std::array<V, kStripRegisters> registers_{};
    std::array<bool, kStripRegisters> loaded_{};
    Ring column_, split_;
    StripCounters counters_;
};

}  // namespace repousse
