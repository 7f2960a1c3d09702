#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/items.h"

namespace repousse {

/// In which order waiting triangles come back.
enum class StackOrder : uint8_t {
    Lifo,  ///< depth first: a few dozen places
    Fifo,  ///< breadth first, the paper's Triangle Queue: up to 0.8 of all triangles
};

/// The Triangle Queue (Doggett and Hirche 3, figure 7) of one context, as a stack.
///
/// A context pops only after the last triangle's children are pushed, so depth first needs at most
/// 9 * cap + 1 places: a chain has 3 * cap steps, and each pops one triangle and pushes at most
/// four. A stack that is asked for more says so and refuses; the FIFO order grows as needed.
template <class P>
class TriangleStack {
public:
    TriangleStack(StackOrder order, int cap)
        : order_(order), capacity_(9 * static_cast<std::size_t>(cap) + 1) {}

    /// Adds a child. False if the stack is full: a broken bound, not a state that a scene can
    /// reach.
    bool push(const Child<P>& child) {
        if (end_ == places_.size() && !grow()) return false;
        Triangle<P>& place = places_[end_++];
        for (std::size_t k = 0; k < 3; ++k) place.corners[k] = *child.corners[k];
        place.path = child.path;
        place.unsplit_edges = child.unsplit_edges;
        peak_ = std::max(peak_, size());
        return true;
    }

    /// Takes the next triangle; the stack must not be empty.
    void pop(Triangle<P>& triangle) {
        const Triangle<P>& next = places_[order_ == StackOrder::Lifo ? --end_ : begin_++];
        // Corner by corner: compilers copy 92 bytes in registers, but 300 by a slow string move.
        for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = next.corners[k];
        triangle.path = next.path;
        triangle.unsplit_edges = next.unsplit_edges;
        if (begin_ == end_) begin_ = end_ = 0;
    }

    bool empty() const { return size() == 0; }
    std::size_t size() const { return end_ - begin_; }
    std::size_t capacity() const { return capacity_; }
    std::size_t peak() const { return peak_; }  ///< most triangles that ever waited
    StackOrder order() const { return order_; }

private:
    // Places are made when they are first needed: contexts are many, and most stay shallow.
    bool grow() {
        if (begin_ > end_ / 2) {  // a queue moves to the front when half of it is consumed
            std::move(places_.begin() + static_cast<std::ptrdiff_t>(begin_), places_.end(),
                      places_.begin());
            end_ -= begin_;
            begin_ = 0;
            return true;
        }
        const bool bounded = order_ == StackOrder::Lifo;
        if (bounded && places_.size() == capacity_) return false;
        const std::size_t twice = std::max<std::size_t>(8, 2 * places_.size());
        places_.resize(bounded ? std::min(twice, capacity_) : twice);
        return true;
    }

    StackOrder order_;
    std::size_t capacity_;
    std::size_t begin_ = 0;  // waiting triangles are places_[begin_ .. end_); LIFO: begin_ is 0
    std::size_t end_ = 0;
    std::size_t peak_ = 0;
    std::vector<Triangle<P>> places_;
};

}  // namespace repousse
