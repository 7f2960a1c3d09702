#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace repousse {

/// A view of `size` elements that somebody else owns: C++17's missing std::span, as much of it as
/// the device needs. It converts from arrays and vectors, and from mutable to const elements.
template <class T>
class Span {
public:
    constexpr Span() = default;
    constexpr Span(T* data, std::size_t size) : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr Span(T (&array)[N]) : data_(array), size_(N) {}
    template <class U, std::size_t N>
    constexpr Span(std::array<U, N>& array) : data_(array.data()), size_(N) {}
    template <class U, std::size_t N>
    constexpr Span(const std::array<U, N>& array) : data_(array.data()), size_(N) {}
    template <class U>
    Span(std::vector<U>& vector) : data_(vector.data()), size_(vector.size()) {}
    template <class U>
    Span(const std::vector<U>& vector) : data_(vector.data()), size_(vector.size()) {}
    template <class U>
    constexpr Span(Span<U> other) : data_(other.data()), size_(other.size()) {}

    constexpr T* data() const { return data_; }
    constexpr std::size_t size() const { return size_; }
    constexpr bool empty() const { return size_ == 0; }
    constexpr T* begin() const { return data_; }
    constexpr T* end() const { return data_ + size_; }
    constexpr T& operator[](std::size_t i) const { return data_[i]; }
    constexpr Span subspan(std::size_t from, std::size_t count) const {
        return Span(data_ + from, count);
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace repousse
