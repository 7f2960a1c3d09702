#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "datapath/span.h"

namespace repousse {

/// A sequence that grows at its end without moving what it holds: pages of one size, the last of
/// them not yet full. For results whose number nobody knows before.
template <class T>
class PagedArray {
public:
    static constexpr std::size_t kPageSize = std::size_t{1} << 14;

    /// Goes through the items in order.
    class ConstIterator {
    public:
        ConstIterator(const PagedArray& array, std::size_t at) : array_(&array), at_(at) {}
        const T& operator*() const { return (*array_)[at_]; }
        ConstIterator& operator++() {
            ++at_;
            return *this;
        }
        bool operator!=(const ConstIterator& other) const { return at_ != other.at_; }

    private:
        const PagedArray* array_;
        std::size_t at_;
    };

    void append(Span<const T> items) {
        for (std::size_t done = 0; done < items.size();) {
            if (size() % kPageSize == 0) {
                pages_.emplace_back();
                pages_.back().reserve(kPageSize);
            }
            std::vector<T>& page = pages_.back();
            const std::size_t n = std::min(items.size() - done, kPageSize - page.size());
            page.insert(page.end(), items.begin() + done, items.begin() + done + n);
            done += n;
        }
    }

    std::size_t size() const {
        return pages_.empty() ? 0 : (pages_.size() - 1) * kPageSize + pages_.back().size();
    }
    bool empty() const { return pages_.empty(); }
    const T& operator[](std::size_t i) const { return pages_[i / kPageSize][i % kPageSize]; }
    const T& back() const { return pages_.back().back(); }
    ConstIterator begin() const { return {*this, 0}; }
    ConstIterator end() const { return {*this, size()}; }

    friend bool operator==(const PagedArray& a, const PagedArray& b) {
        return a.pages_ == b.pages_;  // items of one place have one page
    }

private:
    std::vector<std::vector<T>> pages_;
};

}  // namespace repousse
