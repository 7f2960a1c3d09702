#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/fifo.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/transaction.h"
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
    uint64_t bad_refs = 0;    ///< commands that could not be carried out; see Strip
    std::size_t deepest = 0;  ///< most vertices that either FIFO held
};

/// A command as it stands on a port.
inline Word pack(const StripCommand& command) {
    return static_cast<Word>(command.op) << 4 | Word{command.place} << 2 |
           static_cast<Word>(command.keep);
}
inline StripCommand unpack_strip_command(Word word) {
    return {static_cast<StripOp>(word >> 4 & 3), static_cast<uint8_t>(word >> 2 & 3),
            static_cast<StripKeep>(word & 3)};
}

/// One step as it enters the unit, with its new vertices by their numbers: the input ports of the
/// description.
struct StripIn {
    bool flush = false;
    StripStep step;
    std::array<uint32_t, 4> vertices{};

    std::array<Word, 12> pack() const {
        const auto& c = step.commands;
        return {flush,
                step.init,
                step.flip,
                step.count,
                repousse::pack(c[0]),
                repousse::pack(c[1]),
                repousse::pack(c[2]),
                repousse::pack(c[3]),
                vertices[0],
                vertices[1],
                vertices[2],
                vertices[3]};
    }
    static StripIn unpack(const Word* w) {
        StripIn in;
        in.flush = w[0] != 0;
        in.step.init = w[1] != 0;
        in.step.flip = w[2] != 0;
        in.step.count = static_cast<uint8_t>(w[3]);
        for (std::size_t i = 0; i < 4; ++i) {
            in.step.commands[i] = unpack_strip_command(w[4 + i]);
            in.vertices[i] = static_cast<uint32_t>(w[8 + i]);
        }
        return in;
    }
};
static_assert(ports_are(kStripDesc, PortKind::Input,
                        {"flush", "init", "flip", "count", "command0", "command1", "command2",
                         "command3", "vertex0", "vertex1", "vertex2", "vertex3"}));
static_assert(ports_are(kStripDesc, PortKind::Config, {}));

/// The triangles of one step.
template <class V>
struct StripTriangles {
    uint8_t count = 0;
    std::array<std::array<V, 3>, kStripTriangles> triangles;
};

/// What the unit answers to a step: the output ports. Vertices of triangles that were not made are
/// undefined on the ports and 0 here.
struct StripOut {
    StripTriangles<uint32_t> made;
    bool bad_ref = false;

    std::array<Word, 8> pack() const {
        std::array<Word, 8> words = {made.count, bad_ref};
        for (std::size_t i = 0; i < made.count; ++i) {
            for (std::size_t k = 0; k < 3; ++k) words[2 + 3 * i + k] = made.triangles[i][k];
        }
        return words;
    }
};
static_assert(ports_are(kStripDesc, PortKind::Output,
                        {"triangles", "bad_ref", "a0", "b0", "c0", "a1", "b1", "c1"}));

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
    Triangle add(uint8_t place, bool is_ref) {
        const bool full = length_ == 2;
        const bool swap = full && is_ref && place == older_;
        const Triangle triangle{full && !swap, swap, odd_, older_, newer_};
        odd_ ^= full;
        length_ = full ? 2 : static_cast<uint8_t>(length_ + 1);
        older_ = newer_;
        newer_ = place;
        return triangle;
    }

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
/// A whole step, up to four commands, is one transaction, and makes two triangles at most. `V` is
/// the vertex, whatever the stages before have made of it.
///
/// What cannot be carried out is left out and counted, and the rest of the step goes on: a ref to a
/// register, or a setref from a FIFO, without a vertex does nothing; a vertex for a full FIFO is
/// not kept; a third triangle of a step is not made. The sweep line asks for none of these.
template <class V>
class Strip {
public:
    explicit Strip(std::size_t fifo_depth = kStripFifoDepth)
        : column_(fifo_depth), split_(fifo_depth) {}

    /// One step. `vertices` are those of its `New` commands, in their order.
    void operator()(const StripStep& step, Span<const V> vertices, StripTriangles<V>& out);

    /// Steps one after the other, each anything with members `strip` and `vertex_count`. Vertices
    /// go by numbers: those of the `New` commands from `first` on. Triangles are added to `made`.
    template <class Step>
    void run(Span<const Step> steps, uint32_t first, std::vector<std::array<V, 3>>& made);

    /// End of frame, or after the sweep line has dropped a triangle: forgets strip and FIFOs.
    void flush();

    bool bad_ref() const { return counters_.bad_refs != 0; }
    const StripCounters& counters() const { return counters_; }
    void reset() { flush(), counters_ = {}; }

private:
    template <class New>
    void carry_out(const StripStep& step, StripControl& control, New&& next_vertex,
                   StripTriangles<V>& out);
    bool take(Fifo<V>& fifo, V& vertex);
    void keep(Fifo<V>& fifo, const V& vertex);

    StripControl control_;
    std::array<V, kStripRegisters> registers_{};
    std::array<bool, kStripRegisters> loaded_{};
    Fifo<V> column_, split_;
    StripCounters counters_;
};

template <class V>
bool Strip<V>::take(Fifo<V>& fifo, V& vertex) {
    if (fifo.empty()) return false;
    vertex = fifo.front();
    fifo.pop();
    return true;
}

template <class V>
void Strip<V>::keep(Fifo<V>& fifo, const V& vertex) {
    counters_.bad_refs += !fifo.push(vertex);
    if (fifo.size() > counters_.deepest) counters_.deepest = fifo.size();
}

// A triangle reads its older registers before the new vertex is written, which may replace one.
// `next_vertex(V&)` gives the next new vertex, or false.
template <class V>
template <class New>
inline void Strip<V>::carry_out(const StripStep& step, StripControl& control, New&& next_vertex,
                                StripTriangles<V>& out) {
    out.count = 0;
    ++counters_.steps;
    counters_.commands += static_cast<uint64_t>(step.count) + step.init;
    counters_.strips += step.init;
    if (step.init) control.init(step.flip);
    V vertex{};
    for (std::size_t i = 0; i < step.count; ++i) {
        const StripCommand& command = step.commands[i];
        const auto place = static_cast<uint8_t>(command.place % kStripRegisters);
        const bool is_ref = command.op == StripOp::Ref;
        bool there = true;
        if (is_ref) {
            vertex = registers_[place];
            there = loaded_[place];
        } else if (command.op == StripOp::New) {
            there = next_vertex(vertex);
        } else {
            there = take(command.op == StripOp::Column ? column_ : split_, vertex);
        }
        if (!there) {
            ++counters_.bad_refs;
            continue;
        }
        const StripControl::Triangle made = control.add(place, is_ref);
        counters_.swaps += made.swap;
        if (made.made && out.count == kStripTriangles) {
            ++counters_.bad_refs;
        } else if (made.made) {
            const V &older = registers_[made.older], &newer = registers_[made.newer];
            out.triangles[out.count++] = {older, made.odd ? vertex : newer,
                                          made.odd ? newer : vertex};
        }
        if (is_ref) continue;
        ++counters_.vertices;
        if (command.keep != StripKeep::No) {
            keep(command.keep == StripKeep::Column ? column_ : split_, vertex);
        }
        registers_[place] = vertex;
        loaded_[place] = true;
    }
    counters_.triangles += out.count;
}

template <class V>
template <class Step>
void Strip<V>::run(Span<const Step> steps, uint32_t first, std::vector<std::array<V, 3>>& made) {
    StripControl control = control_;  // beside the steps, which might be what a store changes
    StripTriangles<V> triangles;
    for (const Step& step : steps) {
        const uint32_t end = first + step.vertex_count;
        const auto next_vertex = [&](V& vertex) {
            if (first == end) return false;
            vertex = first++;
            return true;
        };
        carry_out(step.strip, control, next_vertex, triangles);
        first = end;
        for (std::size_t i = 0; i < triangles.count; ++i) made.push_back(triangles.triangles[i]);
    }
    control_ = control;
}

}  // namespace repousse
