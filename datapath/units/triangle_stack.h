#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datapath/items.h"

namespace repousse {

/// In which order waiting triangles come back.
enum class StackOrder : uint8_t {
    Lifo, ///< depth first: a few dozen places
    Fifo, ///< breadth first, the paper's Triangle Queue: up to 0.8 of all triangles
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
        : order_(order), capacity_(9 * static_cast<std::size_t>(cap) + 1) {
        if (order == StackOrder::Lifo) triangles_.reserve(capacity_);
    }

    /// False if the stack is full: a broken bound, not a state that a scene can reach.
    bool push(const Triangle<P>& triangle) {
        if (order_ == StackOrder::Lifo && triangles_.size() == capacity_) return false;
        triangles_.push_back(triangle);
        peak_ = size() > peak_ ? size() : peak_;
        return true;
    }

    /// Takes the next triangle; the stack must not be empty.
    Triangle<P> pop() {
        if (order_ == StackOrder::Lifo) {
            const Triangle<P> top = triangles_.back();
            triangles_.pop_back();
            return top;
        }
        const Triangle<P> front = triangles_[head_++];
        // The consumed half is given back at once when it outweighs the rest: O(1) amortised.
        if (2 * head_ > triangles_.size()) {
            triangles_.erase(triangles_.begin(),
                             triangles_.begin() + static_cast<std::ptrdiff_t>(head_));
            head_ = 0;
        }
        return front;
    }

    bool empty() const { return size() == 0; }
    std::size_t size() const { return triangles_.size() - head_; }
    std::size_t capacity() const { return capacity_; }
    std::size_t peak() const { return peak_; } ///< most triangles that ever waited
    StackOrder order() const { return order_; }

private:
    StackOrder order_;
    std::size_t capacity_;
    std::size_t head_ = 0; // FIFO: triangles before it are consumed
    std::size_t peak_ = 0;
    std::vector<Triangle<P>> triangles_;
};

}  // namespace repousse
