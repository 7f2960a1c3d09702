#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/fifo.h"
#include "datapath/fine_vertices.h"
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
    uint64_t bad_refs = 0;    ///< commands that could not be carried out; see Strip
    std::size_t deepest = 0;  ///< most vertices that either FIFO held
};

/// The triangles of one step.
template <class V>
struct StripTriangles {
    uint8_t count = 0;
    std::array<std::array<V, 3>, kStripTriangles> triangles;
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

    /// Whether the step adds what it takes from the column FIFO, then what it keeps there, and
    /// leaves the strip as the step before it did, but for the vertices in two registers.
    bool climbs(const StripStep& step) const {
        const auto &left = step.commands[0], &right = step.commands[1];
        return !step.init && step.count == 2 && left.op == StripOp::Column &&
               left.keep == StripKeep::No && right.op == StripOp::New &&
               right.keep == StripKeep::Column && length_ == 2 && older_ == left.place &&
               newer_ == right.place && left.place != right.place;
    }
    bool odd() const { return odd_; }

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

    /// The steps of a batch. `next()` gives the next new vertex. Triangles are added to `made`.
    template <class Next>
    void run(Span<const SweepRun> runs, Next&& next, std::vector<std::array<V, 3>>& made);

    /// End of frame, or after the sweep line has dropped a triangle: forgets strip and FIFOs.
    void flush();

    bool bad_ref() const { return counters_.bad_refs != 0; }
    const StripCounters& counters() const { return counters_; }
    void reset() { flush(), counters_ = {}; }

private:
    template <class New>
    void carry_out(const StripStep& step, StripControl& control, New&& next_vertex,
                   StripTriangles<V>& out);
    template <class Next>
    void climb(uint32_t times, bool odd, const StripStep& step, Next& next,
               std::vector<std::array<V, 3>>& made);
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
template <class Next>
void Strip<V>::run(Span<const SweepRun> runs, Next&& next, std::vector<std::array<V, 3>>& made) {
    StripControl control = control_;  // beside the steps, which might be what a store changes
    StripTriangles<V> triangles;
    for (const SweepRun& run : runs) {
        for (uint32_t i = 0; i < run.times; ++i) {
            uint8_t left = run.vertex_count;
            const auto next_vertex = [&](V& vertex) {
                if (left == 0) return false;
                --left;
                vertex = next();
                return true;
            };
            carry_out(run.strip, control, next_vertex, triangles);
            for (std::size_t k = 0; k < triangles.count; ++k) {
                made.push_back(triangles.triangles[k]);
            }
            if (i + 1 < run.times && control.climbs(run.strip)) {
                climb(run.times - i - 1, control.odd(), run.strip, next, made);
                break;
            }
        }
    }
    control_ = control;
}

// Steps that each take a vertex from the column FIFO, then keep a new one, with two registers in
// turn.
template <class V>
template <class Next>
void Strip<V>::climb(uint32_t times, bool odd, const StripStep& step, Next& next,
                     std::vector<std::array<V, 3>>& made) {
    V &left = registers_[step.commands[0].place], &right = registers_[step.commands[1].place];
    const std::size_t start = made.size();
    made.resize(start + 2 * std::size_t{times});
    std::array<V, 3>* to = made.data() + start;
    V l = left, r = right;
    for (uint32_t i = 0; i < times; ++i, to += 2) {
        const V next_left = column_.front(), next_right = next();
        column_.pop();
        column_.push(next_right);
        to[0] = odd ? std::array<V, 3>{l, next_left, r} : std::array<V, 3>{l, r, next_left};
        to[1] = odd ? std::array<V, 3>{r, next_left, next_right}
                    : std::array<V, 3>{r, next_right, next_left};
        l = next_left;
        r = next_right;
    }
    left = l;
    right = r;
    counters_.steps += times;
    counters_.commands += 2 * uint64_t{times};
    counters_.vertices += 2 * uint64_t{times};
    counters_.triangles += 2 * uint64_t{times};
}

}  // namespace repousse
