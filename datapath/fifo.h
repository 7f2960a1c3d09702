#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "datapath/span.h"

namespace repousse {

/// A FIFO of fixed size in a ring. A full one refuses.
template <class T>
class Fifo {
public:
    explicit Fifo(std::size_t capacity) : places_(capacity) {}

    /// False if it is full.
    bool push(const T& item) {
        if (full()) return false;
        places_[place(count_++)] = item;
        return true;
    }

    /// Makes items in their places: `make(i, T&)` for i = 0, 1, ... How many it had room for.
    template <class Make>
    std::size_t push(std::size_t count, Make&& make) {
        const std::size_t n = std::min(count, capacity() - count_);
        for (std::size_t i = 0; i < n; ++i) make(i, places_[place(count_ + i)]);
        count_ += n;
        return n;
    }

    /// The oldest item; there must be one.
    const T& front() const { return places_[first_]; }

    /// Takes the oldest item away; there must be one.
    void pop() {
        first_ = place(1);
        --count_;
    }

    /// Takes everything: the items lie in one or two spans, handed to `sink(Span<const T>)`.
    template <class Sink>
    void drain(Sink&& sink) {
        const std::size_t straight = std::min(count_, capacity() - first_);
        if (straight != 0) sink(Span<const T>(places_.data() + first_, straight));
        if (straight != count_) sink(Span<const T>(places_.data(), count_ - straight));
        clear();
    }

    void clear() { first_ = count_ = 0; }
    bool empty() const { return count_ == 0; }
    bool full() const { return count_ == capacity(); }
    std::size_t size() const { return count_; }
    std::size_t capacity() const { return places_.size(); }

private:
    // Of the i-th item from the oldest; one compare, as i <= capacity.
    std::size_t place(std::size_t i) const {
        const std::size_t at = first_ + i;
        return at < capacity() ? at : at - capacity();
    }

    std::vector<T> places_;
    std::size_t first_ = 0;
    std::size_t count_ = 0;
};

}  // namespace repousse
