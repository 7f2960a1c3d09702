#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/fifo.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/triangle_buffer_desc.h"

namespace repousse {

/// What `triangle_buffer` counted. The first five are functions of the data and equal at every
/// level; `deepest` and the waits say what order things arrived in.
struct TriangleBufferCounters {
    uint64_t items = 0;       ///< base triangles
    uint64_t triangles = 0;   ///< that entered
    uint64_t direct = 0;      ///< of these, undisplaced ones
    uint64_t empty = 0;       ///< displaced base triangles that gave no triangle: clipped ones
    uint64_t switches = 0;    ///< the lock went from one source to the other
    uint64_t waits = 0;       ///< direct triangles that came while the other source held the lock
    uint64_t refused = 0;     ///< pushes without the lock or without room: the source waits
    std::size_t deepest = 0;  ///< most triangles that waited to leave
    std::size_t deepest_direct = 0;  ///< most undisplaced triangles that waited for their turn
};

/// The FIFO/Triangle Buffer Unit (Gumhold and Huettner 2.2): brings displaced and undisplaced
/// triangles together in the order of their base triangles, and covers latencies. A vertex leaves
/// once, before the triangles that refer to it by its number: how many have left since the draw
/// began.
///
///  1. `expect`: the controller leaves a token for each base triangle, in order;
///  2. the source that the oldest token names holds the lock. `push`: displaced vertices, then
///     triangles, enter while the displacement unit holds it; `finish` ends a base triangle, also
///     one that gave no triangle, and takes its token away;
///  3. `push_direct`: an undisplaced triangle waits in a FIFO of its own until its token is the
///     oldest, then enters with its three vertices and takes its token away;
///  4. vertices and triangles leave in the order in which they entered.
///
/// Every FIFO has a fixed depth and refuses what it has no room for: the source offers it again.
/// `V` is the vertex, whatever stands for it.
template <class V>
class TriangleBuffer {
public:
    /// An undisplaced triangle.
    struct Direct {
        uint32_t base = 0;
        std::array<V, 3> corners;
    };

    /// `vertex_depth` is at least 3.
    explicit TriangleBuffer(std::size_t depth = kTriangleBufferDepth,
                            std::size_t order_depth = kOrderDepth,
                            std::size_t vertex_depth = kVertexBufferDepth)
        : order_(order_depth), direct_(order_depth), out_(depth), vertices_(vertex_depth) {}

    /// Step 1. False: as many base triangles are under way as the order FIFO has places.
    bool expect(const OrderToken& token) {
        if (!order_.push(token)) return refuse();
        ++counters_.items;
        counters_.switches += token.route != newest_ ? 1 : 0;
        newest_ = token.route;
        settle();
        return true;
    }

    /// Step 2. Vertices, made where they will wait: `make(i, V&)` for the i-th. How many entered:
    /// none without the lock, the first ones if there is not room for all.
    template <class Make>
    std::size_t push_vertices(std::size_t count, Make&& make) {
        const std::size_t n = enter(vertices_, count, make);
        vertex_count_ += static_cast<uint32_t>(n);
        return n;
    }

    /// The number of the vertex that enters next.
    uint32_t vertex_count() const { return vertex_count_; }

    /// Step 2. Triangles, in the same way: `make(i, FineTriangle&)`.
    template <class Make>
    std::size_t push(std::size_t count, Make&& make) {
        const std::size_t n = enter(out_, count, make);
        counters_.triangles += n;
        empty_ = empty_ && n == 0;
        counters_.deepest = std::max(counters_.deepest, out_.size());
        return n;
    }

    /// Step 2. The displaced base triangle that holds the lock is complete. False: none does.
    bool finish() {
        if (!locked_by(Route::Displaced)) return refuse();
        counters_.empty += empty_ ? 1 : 0;
        release();
        settle();
        return true;
    }

    /// Step 3. False: no room for another undisplaced triangle.
    bool push_direct(const Direct& triangle) {
        if (!direct_.push(triangle)) return refuse();
        counters_.deepest_direct = std::max(counters_.deepest_direct, direct_.size());
        counters_.waits += locked_by(Route::Direct) ? 0 : 1;
        settle();
        return true;
    }

    /// Step 4. Hands out everything that waits to leave, as spans, to `sink(Span<const V>)` and
    /// `sink(Span<const FineTriangle>)`.
    template <class Sink>
    void drain(Sink&& sink) {
        while (!out_.empty() || !vertices_.empty()) {
            vertices_.drain(sink);
            out_.drain(sink);
            settle();
        }
    }

    /// Whether the source may push now.
    bool locked_by(Route route) const { return !order_.empty() && order_.front().route == route; }
    bool full() const { return out_.size() == out_.capacity(); }
    bool can_expect() const { return order_.size() < order_.capacity(); }

    /// Nothing waits and no base triangle is under way.
    bool idle() const {
        return order_.empty() && direct_.empty() && out_.empty() && vertices_.empty();
    }

    /// Starts a draw: drops everything under way.
    void clear() {
        order_.clear();
        direct_.clear();
        out_.clear();
        vertices_.clear();
        vertex_count_ = 0;
        newest_ = Route::Displaced;
        empty_ = true;
    }

    const TriangleBufferCounters& counters() const { return counters_; }

    /// The state after power-on.
    void reset() {
        clear();
        counters_ = {};
    }

private:
    bool refuse() {
        ++counters_.refused;
        return false;
    }

    template <class T, class Make>
    std::size_t enter(Fifo<T>& fifo, std::size_t count, Make& make) {
        const std::size_t n = locked_by(Route::Displaced) ? fifo.push(count, make) : 0;
        if (n < count) refuse();
        return n;
    }

    // The oldest base triangle is complete.
    void release() {
        order_.pop();
        empty_ = true;
    }

    // Undisplaced triangles whose turn has come enter while there is room.
    void settle() {
        while (locked_by(Route::Direct) && !direct_.empty() && !out_.full() &&
               vertices_.size() + 3 <= vertices_.capacity()) {
            const Direct& triangle = direct_.front();
            for (const V& corner : triangle.corners) vertices_.push(corner);
            const uint32_t first = vertex_count_;
            vertex_count_ += 3;
            out_.push({triangle.base, {first, first + 1, first + 2}});
            direct_.pop();
            ++counters_.triangles;
            ++counters_.direct;
            counters_.deepest = std::max(counters_.deepest, out_.size());
            release();
        }
    }

    Fifo<OrderToken> order_;
    Fifo<Direct> direct_;
    Fifo<FineTriangle> out_;
    Fifo<V> vertices_;
    uint32_t vertex_count_ = 0;
    Route newest_ = Route::Displaced;  // of the newest token
    bool empty_ = true;                // the one that holds the lock has given no triangle
    TriangleBufferCounters counters_;
};

}  // namespace repousse
