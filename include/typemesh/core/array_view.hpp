// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/version.hpp>

#include <cstddef>
#include <span>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// A pointer and a count: consecutive values in memory that it does not own. It does the job of std::span, and converts
/// to and from a std::span. Compilers need far less time and memory for it, because std::span checks the concepts of
/// iterators and ranges for each element type.
template <class T>
class array_view {
public:
    using element_type = T;                  ///< as in std::span
    using value_type = std::remove_cv_t<T>;  ///< as in std::span

    constexpr array_view() noexcept = default;
    constexpr array_view(T* first, std::size_t count) noexcept : data_{first}, size_{count} {}
    template <std::size_t count>
    constexpr array_view(T (&from)[count]) noexcept : data_{from}, size_{count}
    {
    }

    /// Converts from anything with data() and size(): std::span, std::vector, buffer.
    template <class Array>
        requires(!std::is_same_v<std::remove_cvref_t<Array>, array_view>) && requires(Array& a) {
            a.size();
            static_cast<T(*)[]>(static_cast<std::remove_pointer_t<decltype(a.data())>(*)[]>(nullptr));
        }
    constexpr array_view(Array&& from) noexcept : data_{from.data()}, size_{from.size()}
    {
    }

    // There is one overload for each kind of value. Each overload matches as well as std::span's constructor for
    // ranges, and the compiler prefers the overload.
    constexpr operator std::span<T>() & noexcept { return {data_, size_}; }
    constexpr operator std::span<T>() const& noexcept { return {data_, size_}; }
    constexpr operator std::span<T>() && noexcept { return {data_, size_}; }

    [[nodiscard]] constexpr T* data() const noexcept { return data_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    /// The size of all elements in bytes.
    [[nodiscard]] constexpr std::size_t size_bytes() const noexcept { return size_ * sizeof(T); }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T* begin() const noexcept { return data_; }
    [[nodiscard]] constexpr T* end() const noexcept { return data_ + size_; }
    [[nodiscard]] constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
    [[nodiscard]] constexpr T& front() const noexcept { return *data_; }
    [[nodiscard]] constexpr T& back() const noexcept { return data_[size_ - 1]; }

    /// The first `count` elements.
    [[nodiscard]] constexpr array_view first(std::size_t count) const noexcept { return {data_, count}; }
    /// The last `count` elements.
    [[nodiscard]] constexpr array_view last(std::size_t count) const noexcept { return {end() - count, count}; }
    /// The elements from index `at` on: all of them, or `count` of them.
    [[nodiscard]] constexpr array_view subspan(std::size_t at) const noexcept { return {data_ + at, size_ - at}; }
    [[nodiscard]] constexpr array_view subspan(std::size_t at, std::size_t count) const noexcept
    {
        return {data_ + at, count};
    }

private:
    T* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
