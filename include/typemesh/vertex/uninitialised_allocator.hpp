// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// An allocator for a std::vector that growing_sink fills: resize() leaves new elements uninitialised, while
/// std::allocator sets them to zero. Each element is then written only once.
///
///     std::vector<my_vertex, typemesh::uninitialised_allocator<my_vertex>> vertices;
///     std::vector<std::uint32_t, typemesh::uninitialised_allocator<std::uint32_t>> indices;
///
/// It is useful for large meshes in new vectors, which then cost only their new memory. Reused vectors, with either
/// allocator, are several times as fast as any new memory, whose pages the system provides one by one.
template <class T>
class uninitialised_allocator {
public:
    using value_type = T;

    uninitialised_allocator() noexcept = default;
    template <class Other>
    explicit(false) uninitialised_allocator(const uninitialised_allocator<Other>&) noexcept
    {
    }

    [[nodiscard]] T* allocate(std::size_t count) { return std::allocator<T>{}.allocate(count); }
    void deallocate(T* elements, std::size_t count) noexcept { std::allocator<T>{}.deallocate(elements, count); }

    /// Called by resize() for each new element.
    template <class Element>
    void construct(Element*) noexcept
    {
        static_assert(std::is_trivially_copyable_v<Element> && std::is_trivially_destructible_v<Element>,
                      "typemesh: uninitialised_allocator is for elements that can be copied as bytes");
    }
    template <class Element, class... Values>
        requires(sizeof...(Values) > 0)
    void construct(Element* at, Values&&... values) noexcept(std::is_nothrow_constructible_v<Element, Values...>)
    {
        std::construct_at(at, std::forward<Values>(values)...);
    }

    template <class Other>
    [[nodiscard]] friend bool operator==(const uninitialised_allocator&, const uninitialised_allocator<Other>&) noexcept
    {
        return true;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
